// SPDX-License-Identifier: MIT
// A proof of listability in words and as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sim/listability_proof.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using listability::Circuit;
using listability::PairFault;

constexpr std::size_t kMostPairs = 8;

std::string name_of(const Database& database, std::uint32_t object) {
  if (object == 0 || object > database.object_names.size()) return std::to_string(object);
  const std::string& name = database.object_names[object - 1];
  return name.empty() ? std::to_string(object) : fmt::format("{} ({})", object, name);
}

std::string place_of(const GroupFault& fault, const SceneProof& proof) {
  return proof.by_hand ? "" : fmt::format(" in group {} of system {}", fault.group, fault.system);
}

std::string circuit_text(const Circuit& circuit, const GroupFault& fault,
                         const Database& database) {
  const auto name = [&](std::size_t m) {
    return name_of(database, fault.objects[circuit.members[m]]);
  };
  std::vector<std::string> sides;
  for (const listability::EyeSide& s : circuit.sides)
    sides.push_back(fmt::format("{} at plane {}", s.eye_true ? "TRUE" : "FALSE", s.plane + 1));
  return fmt::format("objects {} -> {} -> {} -> {}, from {} ({})", name(0), name(1), name(2),
                     name(0), text_of(circuit.eye), fmt::join(sides, ", "));
}

std::string pair_text(const PairFault& pair, const GroupFault& fault, const Database& database) {
  return fmt::format("pair {}, {} stands on {}", name_of(database, fault.objects[pair.a]),
                     name_of(database, fault.objects[pair.b]),
                     pair.times == 0 ? "no plane" : fmt::format("{} places", pair.times));
}

std::string fault_text(const GroupFault& fault, const SceneProof& scene, const Database& database) {
  const listability::Proof& proof = fault.proof;
  std::string out = fmt::format("NOT LISTABLE{}\n", place_of(fault, scene));
  for (std::size_t p = 0; p < std::min(proof.pair_faults.size(), kMostPairs); ++p)
    out += fmt::format("  {}\n", pair_text(proof.pair_faults[p], fault, database));
  if (proof.pair_faults.size() > kMostPairs)
    out += fmt::format("  {} more such pairs\n", proof.pair_faults.size() - kMostPairs);
  if (proof.witness)
    out += fmt::format("  witness: from the eyepoint {} the counts are {}\n",
                       text_of(proof.witness->eye), fmt::join(proof.witness->counts, " "));
  else if (!proof.pair_faults.empty())
    out +=
        "  with all objects in view the counts are unique from every eyepoint; with the two of "
        "such a pair alone in view they are not, from none\n";
  if (fault.machine && !fault.machine->circuit.empty())
    out += fmt::format("  the machine names there: objects {} -> {}: each precedes the next\n",
                       fmt::join(fault.machine->circuit, " -> "), fault.machine->circuit.front());
  for (const Circuit& circuit : proof.circuits)
    out += fmt::format("  circuit: {}\n", circuit_text(circuit, fault, database));
  if (proof.circuit_count > proof.circuits.size())
    out += fmt::format("  {} more circuits\n", proof.circuit_count - proof.circuits.size());
  return out;
}

std::string side_text(const SceneProof& proof, const Database& database) {
  std::uint64_t tests = 0, tolerated = 0;
  double deepest = 0;
  std::string faults;
  for (const auto& [s, check] : proof.sides) {
    tests += check.tests;
    tolerated += check.tolerated;
    deepest = std::max(deepest, check.deepest);
    for (const listability::SideFault& fault : check.faults) {
      const FaceSet& set = database.systems[s].set;
      faults += fmt::format(
          "WRONG SIDE: object {} reaches {:.6g} across plane {} of group {} of system {}, on whose "
          "{} side its pairs put it\n",
          name_of(database, set.faces[set.items[fault.item].first_face].object), fault.depth,
          fault.node + 1, fault.group, s, fault.true_side ? "TRUE" : "FALSE");
    }
  }
  if (proof.side_faults() > 0)
    return faults +
           fmt::format("{} of {} tests of an item at a plane failed\n", proof.side_faults(), tests);
  std::string out =
      fmt::format("Every object lies on the sides that its pairs say: {} tests", tests);
  if (tolerated > 0)
    out += fmt::format("; {} reach across by at most {:.2g}, within the contact tolerance",
                       tolerated, deepest);
  return out + "\n";
}

Json json_of(const listability::Eyepoint& eye) {
  Json out;
  if (eye.rounded) out["eye"] = {eye.rounded->x, eye.rounded->y, eye.rounded->z};
  out["eye_exact"] = {eye.exact.x.get_str(), eye.exact.y.get_str(), eye.exact.z.get_str()};
  return out;
}

Json json_of(const Circuit& circuit, const GroupFault& fault) {
  Json out = json_of(circuit.eye);
  out["objects"] = Json::array();
  for (const std::uint32_t m : circuit.members) out["objects"].push_back(fault.objects[m]);
  out["sides"] = Json::array();
  for (const listability::EyeSide& s : circuit.sides)
    out["sides"].push_back({{"plane", s.plane + 1}, {"true", s.eye_true}});
  return out;
}

Json json_of(const GroupFault& fault) {
  const listability::Proof& proof = fault.proof;
  Json out{{"system", fault.system},
           {"group", fault.group},
           {"listable_with_all_in_view", proof.listable_with_all}};
  if (proof.witness) {
    out["witness"] = json_of(proof.witness->eye);
    out["witness"]["counts"] = proof.witness->counts;
    out["witness"]["objects"] = fault.objects;
  }
  if (fault.machine) out["machine_circuit"] = fault.machine->circuit;
  out["circuit_count"] = proof.circuit_count;
  out["circuits"] = Json::array();
  for (const Circuit& circuit : proof.circuits) out["circuits"].push_back(json_of(circuit, fault));
  out["pairs_not_on_one_plane"] = Json::array();
  for (const PairFault& pair : proof.pair_faults)
    out["pairs_not_on_one_plane"].push_back(
        {{"objects", {fault.objects[pair.a], fault.objects[pair.b]}}, {"times", pair.times}});
  return out;
}

}  // namespace

std::string proof_report(const SceneProof& proof, const Database& database,
                         const std::string& name) {
  std::string out =
      proof.by_hand ? fmt::format("{}: a table of {} objects, {} planes and {} pairs\n", name,
                                  proof.members, proof.planes, proof.pairs)
                    : fmt::format("{}: {} groups of up to {} members, {} planes, {} pairs\n", name,
                                  proof.groups, proof.largest_group, proof.planes, proof.pairs);
  for (const GroupFault& fault : proof.faults) out += fault_text(fault, proof, database);
  if (proof.fault_count > proof.faults.size())
    out +=
        fmt::format("{} more groups are not listable\n", proof.fault_count - proof.faults.size());
  if (proof.fault_count == 0)
    out += "LISTABLE from every eyepoint, proved, whichever objects are in view\n";
  out += side_text(proof, database);
  out += fmt::format("Decided in {:.3g} ms: {} triples of members, both ways round",
                     proof.milliseconds, proof.triples);
  if (proof.cells > 0) out += fmt::format("; {} cells of the planes", proof.cells);
  out += fmt::format("; sides of objects in {:.3g} ms\n", proof.side_milliseconds);
  if (database.systems.size() > 1)
    out += "Moving systems are placed among the others frame by frame; that is not part of this\n";
  return out;
}

Json to_json(const SceneProof& proof, const Database& database) {
  Json out{{"listable", proof.listable()},
           {"by_hand", proof.by_hand},
           {"systems", database.systems.size()},
           {"groups", proof.groups},
           {"largest_group", proof.largest_group},
           {"members", proof.members},
           {"planes", proof.planes},
           {"pairs", proof.pairs},
           {"triples", proof.triples},
           {"cells", proof.cells},
           {"groups_not_listable", proof.fault_count}};
  out["faults"] = Json::array();
  for (const GroupFault& fault : proof.faults) out["faults"].push_back(json_of(fault));
  std::uint64_t tests = 0, tolerated = 0;
  for (const SystemSides& system : proof.sides) {
    tests += system.check.tests;
    tolerated += system.check.tolerated;
  }
  out["side_tests"] = tests;
  out["side_tolerated"] = tolerated;
  out["side_faults"] = proof.side_faults();
  out["ms"] = proof.milliseconds;
  out["side_ms"] = proof.side_milliseconds;
  return out;
}

}  // namespace cigsim
