// SPDX-License-Identifier: MIT
#include "sim/cosim/replay_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "models/database/database_json.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "models/machine/description_json.hpp"
#include "sim/cosim/report.hpp"
#include "sim/cosim/stuck_option.hpp"

namespace cigsim::cosim {
namespace {

using Json = nlohmann::json;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* kTag = "cigsim-replay";
constexpr int kVersion = 1;

// Above these nothing that cigsim compare writes goes.
constexpr std::uint64_t kMostCycles = 1'000'000'000'000, kMostFrames = 1'000'000, kMostBits = 256,
                        kMostSize = 65'536, kMostSeed = 0x7fffffff;

// A whole number; a conversion alone would cut off what does not fit.
template <class Number, class AnyJson>
Number whole(const AnyJson& json, const char* name, std::uint64_t low, std::uint64_t high) {
  const AnyJson& value = json.at(name);
  if (!value.is_number_unsigned() || value.template get<std::uint64_t>() < low ||
      value.template get<std::uint64_t>() > high)
    throw std::invalid_argument(fmt::format("{} is {}; it must be a whole number from {} to {}",
                                            name, value.dump(), low, high));
  return value.template get<Number>();
}

OrderedJson view_json(const PlannedFrame& frame) {
  const Viewpoint& v = frame.view.viewpoint;
  return {{"database", frame.database},
          {"eye", {v.eye.position.x, v.eye.position.y, v.eye.position.z}},
          {"attitude", {v.eye.heading, v.eye.pitch, v.eye.roll}},
          {"fov", v.fov},
          {"position", frame.view.position}};
}

PlannedFrame frame_of(const Json& json) {
  const auto eye = json.at("eye").get<std::array<double, 3>>();
  const auto attitude = json.at("attitude").get<std::array<double, 3>>();
  PlannedFrame frame;
  frame.database = whole<std::size_t>(json, "database", 0, kMostFrames);
  frame.view.viewpoint.eye = {{eye[0], eye[1], eye[2]}, attitude[0], attitude[1], attitude[2]};
  frame.view.viewpoint.fov = json.at("fov").get<double>();
  frame.view.position = json.at("position").get<double>();
  if (!(frame.view.viewpoint.fov > 0 && frame.view.viewpoint.fov < 180))
    throw std::invalid_argument("fov must lie between 0 and 180 degrees");
  return frame;
}

OrderedJson variant_json(const RtlVariant& variant) {
  OrderedJson parameters = OrderedJson::array();
  for (const RtlVariant::Parameter& p : variant.parameters)
    parameters.push_back({{"name", p.name}, {"value", p.value}});
  return {{"stage", variant.stage}, {"module", variant.module}, {"parameters", parameters}};
}

RtlVariant variant_of(const OrderedJson& json) {
  RtlVariant variant{json.at("stage"), json.at("module"), {}};
  for (const OrderedJson& p : json.at("parameters"))
    variant.parameters.push_back(
        {p.at("name"), whole<std::uint32_t>(p, "value", 1, std::uint32_t{1} << 31)});
  return variant;
}

Mismatch mismatch_of(const Json& json) {
  Mismatch m;
  m.stage = json.at("stage");
  m.field = json.at("field");
  m.cycle = whole<Cycle>(json, "cycle", 0, kMostCycles);
  m.frame = whole<std::uint32_t>(json, "frame", 0, kMostFrames);
  if (json.contains("line")) m.line = whole<std::uint32_t>(json, "line", 0, kMostFrames);
  m.expected = json.at("expected");
  m.got = json.at("got");
  m.inputs = json.at("inputs").get<std::vector<std::string>>();
  return m;
}

OrderedJson to_json(const FrameReplay& replay) {
  const ComparePlan& plan = replay.plan;
  OrderedJson json{{"name", plan.name},
                   {"mismatch", mismatch_json(replay.mismatch)},
                   {"overload", name_of(plan.overload)},
                   {"eye_reach", plan.eye_reach},
                   {"seed", plan.seed}};
  for (const RtlVariant& variant : plan.variants) json["rtl"].push_back(variant_json(variant));
  if (plan.stalls) json["stalls"] = *plan.stalls;
  if (plan.stuck)
    json["stuck"] = {{"stage", name_of(plan.stuck->first)},
                     {"pins", plan.stuck->second.pins},
                     {"field", plan.stuck->second.field},
                     {"bit", plan.stuck->second.bit},
                     {"high", plan.stuck->second.high}};
  for (const PlannedFrame& frame : plan.frames) json["frames"].push_back(view_json(frame));
  json["machine"] = Json::parse(machine_json(plan.description));
  for (const auto& database : plan.databases)
    json["databases"].push_back(database_to_json(*database));
  return json;
}

template <class Choices, class Name>
auto named(const Choices& choices, const Name& name) {
  for (const auto choice : choices)
    if (name_of(choice) == name) return choice;
  throw std::invalid_argument(fmt::format("'{}' is not known", name));
}

// A file that was edited must not pass because something else was run, or nothing.
void check_variants(const ComparePlan& plan) {
  if (plan.stages.empty()) throw std::invalid_argument("no stage is of RTL");
  ComparePlan needed = plan;
  choose_variants(needed);
  for (std::size_t i = 0; i < plan.variants.size(); ++i) {
    const RtlVariant &variant = plan.variants[i], &least = needed.variants[i];
    if (std::count(plan.stages.begin(), plan.stages.end(), plan.stages[i]) > 1)
      throw std::invalid_argument(variant.stage + " is there twice");
    if (!variant.covers(least))
      throw std::invalid_argument(fmt::format("RTL {} does not hold its frames, which need {}",
                                              variant.name(), least.name()));
    for (std::size_t p = 0; p < variant.parameters.size(); ++p)
      if (variant.parameters[p].value >
          std::max<std::uint64_t>(kMostSize, least.parameters[p].value))
        throw std::invalid_argument(fmt::format("RTL {} is too large to be built", variant.name()));
  }
}

// As the option --stuck, so that a fault which is not there is refused.
std::pair<Stage, StuckBit> stuck_of(const OrderedJson& json, const ComparePlan& plan) {
  const StuckChoice choice = parse_stuck(
      fmt::format("{}.{}.{}:{}={}", json.at("stage").get<std::string>(),
                  json.at("pins").get<std::string>(), json.at("field").get<std::string>(),
                  whole<unsigned>(json, "bit", 0, kMostBits), json.at("high").get<bool>() ? 1 : 0));
  const auto* stuck = std::get_if<std::pair<Stage, StuckBit>>(&choice);
  if (stuck == nullptr || std::count(plan.stages.begin(), plan.stages.end(), stuck->first) == 0)
    throw std::invalid_argument("stuck is on a stage that is not of RTL");
  return *stuck;
}

FrameReplay frames_of(const OrderedJson& json, const std::string& file) {
  FrameReplay replay;
  ComparePlan& plan = replay.plan;
  plan.name = json.at("name");
  replay.mismatch = mismatch_of(Json(json.at("mismatch")));
  plan.overload =
      named(std::array{OverloadPolicy::kDrop, OverloadPolicy::kCut, OverloadPolicy::kExtend},
            json.at("overload").get<std::string>());
  plan.eye_reach = json.at("eye_reach");
  if (!(plan.eye_reach >= 0)) throw std::invalid_argument("eye_reach must not be negative");
  plan.seed = whole<std::uint32_t>(json, "seed", 1, kMostSeed);
  for (const OrderedJson& variant : json.at("rtl")) {
    plan.variants.push_back(variant_of(variant));
    plan.stages.push_back(named(kAllStages, plan.variants.back().stage));
  }
  if (json.contains("stalls")) plan.stalls = json.at("stalls").get<std::uint64_t>();
  if (json.contains("stuck")) plan.stuck = stuck_of(json.at("stuck"), plan);
  plan.description = parse_machine(json.at("machine").dump(), file);
  for (const OrderedJson& database : json.at("databases")) {
    plan.databases.push_back(std::make_shared<Database>(database_from_json(Json(database))));
    check_database(*plan.databases.back());
  }
  for (const OrderedJson& frame : json.at("frames")) {
    plan.frames.push_back(frame_of(Json(frame)));
    if (plan.frames.back().database >= plan.databases.size())
      throw std::invalid_argument("a frame names a database that is not there");
  }
  if (plan.frames.empty()) throw std::invalid_argument("there are no frames");
  check_variants(plan);
  return replay;
}

std::string hex(const priority_processor::SoBits& bits) {
  std::string text;
  for (const std::uint64_t word : bits) text = fmt::format("{:016x}", word) + text;
  return text;
}

priority_processor::SoBits bits_of(const std::string& text) {
  priority_processor::SoBits bits{};
  if (text.size() != 16 * bits.size() ||
      text.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw std::invalid_argument(
        fmt::format("'{}' must be {} hexadecimal digits", text, 16 * bits.size()));
  for (std::size_t i = 0; i < bits.size(); ++i)
    bits[i] = std::stoull(text.substr(16 * (bits.size() - 1 - i), 16), nullptr, 16);
  return bits;
}

// The lowest `count` bits may be set.
priority_processor::SoBits bits_of(const OrderedJson& json, const char* name, unsigned count) {
  const priority_processor::SoBits bits = bits_of(json.at(name).get<std::string>());
  for (unsigned bit = count; bit < 64 * bits.size(); ++bit)
    if (bits[bit / 64] >> bit % 64 & 1)
      throw std::invalid_argument(fmt::format("{} has more than {} bits", name, count));
  return bits;
}

OrderedJson to_json(const SoReplay& replay) {
  OrderedJson json{{"difference", replay.difference},  {"seed", replay.seed},
                   {"objects", replay.inputs.objects}, {"planes", replay.inputs.planes},
                   {"eye", hex(replay.inputs.eye)},    {"active", hex(replay.inputs.active)}};
  for (const priority_processor::SoRow& row : replay.inputs.rows)
    json["rows"].push_back({{"tells", hex(row.tells)}, {"plus", hex(row.plus)}});
  if (replay.stuck)
    json["stuck"] = {{"output", replay.stuck->output},
                     {"bit", replay.stuck->bit},
                     {"high", replay.stuck->value}};
  return json;
}

SoReplay so_of(const OrderedJson& json) {
  SoReplay replay;
  replay.difference = json.at("difference");
  replay.seed = whole<std::uint32_t>(json, "seed", 1, kMostSeed);
  const unsigned objects = whole<unsigned>(json, "objects", 2, priority_processor::kSoMost);
  const unsigned planes = whole<unsigned>(json, "planes", 1, priority_processor::kSoMost);
  replay.inputs = {
      objects, planes, {}, bits_of(json, "eye", planes), bits_of(json, "active", objects)};
  for (const OrderedJson& row : json.at("rows"))
    replay.inputs.rows.push_back({bits_of(row, "tells", planes), bits_of(row, "plus", planes)});
  if (json.contains("stuck")) {
    const OrderedJson& stuck = json.at("stuck");
    replay.stuck = SoStuckBit{stuck.at("output"), whole<unsigned>(stuck, "bit", 0, kMostBits),
                              stuck.at("high")};
    check_stuck(*replay.stuck, objects);
  }
  if (replay.inputs.rows.size() != replay.inputs.objects)
    throw std::invalid_argument("there must be a row for each object");
  return replay;
}

}  // namespace

void write_replay(const Replay& replay, const std::filesystem::path& file) {
  const bool frames = std::holds_alternative<FrameReplay>(replay);
  const OrderedJson json{
      {kTag, kVersion},
      {frames ? "frames_of_machine" : "so_matrix",
       frames ? to_json(std::get<FrameReplay>(replay)) : to_json(std::get<SoReplay>(replay))}};
  write_file(file, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Replay read_replay(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream in(file);
  if (!in) throw InputError(name, 0, "cannot be read; name a file that cigsim compare wrote");
  try {
    const OrderedJson json = OrderedJson::parse(in);
    if (!json.is_object() || !json.contains(kTag) || json.at(kTag) != kVersion)
      throw std::invalid_argument(fmt::format("there is no \"{}\": {}", kTag, kVersion));
    if (json.contains("so_matrix")) return so_of(json.at("so_matrix"));
    return frames_of(json.at("frames_of_machine"), name);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(name, 0,
                     fmt::format("is no replay file of this version ({}); run cigsim compare again",
                                 error.what()));
  }
}

}  // namespace cigsim::cosim
