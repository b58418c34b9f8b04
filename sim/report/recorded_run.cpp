// SPDX-License-Identifier: MIT
#include "sim/report/recorded_run.hpp"

#include <array>

#include "models/environment/input_error.hpp"
#include "models/environment/json_reason.hpp"
#include "models/machine/description_json.hpp"
#include "sim/json_file.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint64_t kLargestRaster = 16384;

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument(what); }

// The one of `values` that is called so.
template <class T, std::size_t N>
T named(const Json& name, const std::array<T, N>& values) {
  for (const T value : values)
    if (name == std::string(name_of(value))) return value;
  refuse(name.dump() + " is not known here");
}

Vec3 vector_of(const Json& list) {
  if (list.size() != 3) refuse("a list of three numbers is missing");
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

// A file beside stats.json, never elsewhere.
std::string file_name(const Json& name) {
  const auto text = name.get<std::string>();
  if (text.empty() || std::filesystem::path(text).filename() != text || text == "." || text == "..")
    refuse("\"" + text + "\" is no name of a file beside it");
  return text;
}

// A whole number in low..high.
std::uint64_t whole(const Json& value, std::uint64_t low, std::uint64_t high) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < low ||
      value.get<std::uint64_t>() > high)
    refuse(value.dump() + " is no number from " + std::to_string(low) + " to " +
           std::to_string(high));
  return value.get<std::uint64_t>();
}

Raster raster_of(const Json& list) {
  if (list.size() != 2) refuse("the raster is missing");
  return {static_cast<int>(whole(list[0], 1, kLargestRaster)),
          static_cast<int>(whole(list[1], 1, kLargestRaster))};
}

// But for the description of machine words.
MachineOptions options_of(const Json& options) {
  MachineOptions out;
  out.number = named(options.at("number"),
                     std::array{NumberType::kFloat, NumberType::kDouble, NumberType::kMachine,
                                NumberType::kCertified, NumberType::kExact});
  out.priority = named(options.at("priority"),
                       std::array{PriorityMethod::kCounters, PriorityMethod::kSoMatrix});
  out.resolver = named(options.at("resolver"),
                       std::array{ResolverMethod::kAuto, ResolverMethod::kPainter,
                                  ResolverMethod::kCoverage, ResolverMethod::kActiveList});
  out.overload =
      named(options.at("overload"),
            std::array{OverloadPolicy::kDrop, OverloadPolicy::kCut, OverloadPolicy::kExtend});
  out.raster = raster_of(options.at("raster"));
  out.detail = options.at("detail") == "most" ? 0 : options.at("detail").get<double>();
  out.eye_reach = options.at("eye_reach").get<double>();
  if (!(out.detail >= 0 && out.eye_reach >= 0)) refuse("detail or eye_reach is below 0");
  if (out.number != NumberType::kMachine) {
    out.retrieval = options.at("retrieval").get<bool>();
    out.coherence = options.at("coherence").get<bool>();
  }
  return out;
}

// The reason alone: its line is of no file, and what it advises is for one written by hand.
std::string bare_reason(const InputError& error) {
  const std::string words = error.what();
  const std::size_t begin = words.find(": ") + 2;
  return words.substr(begin, words.find(';', begin) - begin);
}

MachineDescription description_of(const Json& machine, const Raster& raster) {
  MachineDescription out;
  try {
    out = parse_machine(machine.dump(), "machine");
  } catch (const InputError& error) {
    refuse(bare_reason(error));
  }
  if (out.raster.width != raster.width || out.raster.height != raster.height)
    refuse("the machine's raster is not the run's");
  return out;
}

PreparationChoices preparation_of(const Json& options) {
  PreparationChoices out;
  if (const Json& sun = options.at("sun"); !sun.is_null())
    out.sun = Sun{sun.at(0).get<double>(), sun.at(1).get<double>()};
  if (const Json& share = options.at("contact_tolerance"); !share.is_null())
    out.contact_tolerance = share.get<double>();
  out.most_detailed = options.at("detail") == "most";
  return out;
}

RecordedFrame frame_of(Json figures) {
  RecordedFrame out;
  const Json& view = figures.at("view");
  Placement& eye = out.view.viewpoint.eye;
  eye.position = vector_of(view.at("eye"));
  const Vec3 attitude = vector_of(view.at("attitude"));
  eye.heading = attitude.x;
  eye.pitch = attitude.y;
  eye.roll = attitude.z;
  out.view.viewpoint.fov = view.at("fov").get<double>();
  if (!(out.view.viewpoint.fov > 0 && out.view.viewpoint.fov < 180))
    refuse("a field of view is out of range");
  out.view.position = figures.at("position").get<double>();
  out.picture = file_name(figures.at("picture"));
  out.ids = file_name(figures.at("ids"));
  out.faces = whole(figures.at("faces"), 0, kNone);
  for (const Json& fault : figures.at("listability"))
    for (const Json& object : fault.at("objects")) whole(object, 0, kNone);
  out.figures = std::move(figures);
  return out;
}

using Place = Json::json_pointer;

// `place` is kept at what is being read.
RecordedRun run_of(Json stats, Place& place) {
  RecordedRun run;
  run.scene = stats.at("scene").get<std::string>();
  if (run.scene != kBuiltInScene) run.scene_file = run.scene;
  place = Place("/options");
  run.machine = options_of(stats.at("options"));
  run.preparation = preparation_of(stats.at("options"));
  if (run.machine.number == NumberType::kMachine) {
    place = Place("/machine");
    run.machine.description = description_of(stats.at("machine"), run.machine.raster);
  }
  place = Place("/frames");
  Json& frames = stats.at("frames");
  if (!frames.is_array()) refuse("the list of frames is missing");
  for (std::size_t i = 0; i < frames.size(); ++i) {
    place = Place("/frames") / i;
    run.frames.push_back(frame_of(std::move(frames[i])));
  }
  stats.erase("frames");
  run.stats = std::move(stats);
  return run;
}

[[noreturn]] void refuse_run(const JsonFile& json, const std::string& file, const Place& place,
                             const std::string& reason) {
  std::string words = "is not what cigsim run of this version writes: ";
  if (!place.empty()) words += place.to_string().substr(1) + ": ";
  throw InputError(file, json.line_of(place), words + reason + "; repeat the run");
}

}  // namespace

RecordedRun read_recorded_run(const std::filesystem::path& stats_file) {
  const JsonFile json(stats_file);
  const std::string file = stats_file.string();
  Place place;
  try {
    return run_of(json.value(), place);
  } catch (const Json::exception& error) {
    refuse_run(json, file, place, json_reason(error.what()));
  } catch (const std::invalid_argument& error) {
    refuse_run(json, file, place, error.what());
  }
}

}  // namespace cigsim
