// SPDX-License-Identifier: MIT
// The proof of a whole scene's listability: every group of every coordinate system, and where its
// objects lie.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "models/boundary/transactions.hpp"
#include "models/database/listability/group_listability.hpp"

namespace cigsim {

/// A group whose counts are not unique from everywhere. Members are told by object numbers.
struct GroupFault {
  std::uint32_t system = 0, group = 0;
  listability::PriorityTable table;
  listability::Proof proof;
  std::vector<std::uint32_t> objects;  ///< by member: its number, or that of an object below it
  /// What the machine's own counters and sides make of the witness, where doubles reach it.
  std::optional<ListabilityFault> machine;
};

struct SystemSides {
  std::uint32_t system = 0;
  listability::SideCheck check;
};

struct SceneProof {
  bool by_hand = false;  ///< one table that the scene brings, or that was found for a deck
  std::uint64_t groups = 0, largest_group = 0, members = 0, planes = 0, pairs = 0;
  std::uint64_t triples = 0, cells = 0;
  std::uint64_t fault_count = 0;
  std::vector<GroupFault> faults;  ///< the first
  std::vector<SystemSides> sides;
  double milliseconds = 0;       ///< of the proofs
  double side_milliseconds = 0;  ///< of the tests where objects lie

  std::uint64_t side_faults() const;
  bool listable() const { return fault_count == 0 && side_faults() == 0; }
};

SceneProof prove_scene(const Database& database, double contact_tolerance);

/// The counts of a group's members from an eyepoint.
struct EyeReport {
  std::vector<std::uint32_t> counts;  ///< by member of the first group
  std::vector<bool> eye_true;         ///< by plane
  bool unique = true;
};
EyeReport look_from(const Database& database, const Vec3& eye);

std::string proof_report(const SceneProof& proof, const Database& database,
                         const std::string& name);
nlohmann::ordered_json to_json(const SceneProof& proof, const Database& database);

}  // namespace cigsim
