// SPDX-License-Identifier: MIT
#include "sim/report/run_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "models/environment/text_file.hpp"
#include "models/machine/description.hpp"
#include "sim/report/base64.hpp"
#include "sim/report/faces_json.hpp"
#include "sim/report/frame_repeat.hpp"
#include "sim/report/spread.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostEdges = 200000;  // of all frames of a page: about 8 MB
constexpr std::size_t kNeighbours = 2;      // pictures on either side that share the machine

Json machine_section(const RecordedRun& run) {
  if (run.machine.number != NumberType::kMachine) return nullptr;
  const MachineDescription& machine = run.machine.description;
  Json figures = Json::array();
  for (const MachineFigure& figure : machine_figures(machine))
    figures.push_back({{"figure", figure.name},
                       {"value", figure.value},
                       {"unit", figure.unit},
                       {"standing", name_of(figure.provenance.standing)},
                       {"source", figure.provenance.source}});
  return {{"name", machine.name},
          {"title", machine.title},
          {"clock_ns", machine.clock_ns},
          {"frame_cycles", machine.frame_cycles},
          {"crossing_capacity", machine.crossing_capacity},
          {"notices", machine_notices(machine)},
          {"figures", std::move(figures)}};
}

// A row of the table of all frames.
Json row_of(const RecordedFrame& frame, std::size_t number) {
  const Json& f = frame.figures;
  Json row{{"frame", number}};
  for (const char* name : {"host_ms", "faces", "edges", "crossings", "worst_line_crossings",
                           "spans", "faults", "exact_tests", "certified"})
    if (f.contains(name)) row[name] = f[name];
  if (const Json timing = f.value("timing", Json()); timing.is_object()) {
    row["transport_delay"] = timing.value("transport_delay", Json());
    row["frames_extended"] = timing.value("frames_extended", Json());
  }
  if (const Json overload = f.value("overload", Json()); overload.is_object())
    for (const char* name :
         {"dropped_items", "dropped_faces", "dropped_crossings", "overfull_lines", "late_lines"})
      row[name] = overload.value(name, Json());
  return row;
}

// When the pictures beside this one were in the machine.
Json neighbours_of(const RecordedRun& run, std::size_t number) {
  Json out = Json::array();
  const std::size_t first = number < kNeighbours ? 0 : number - kNeighbours;
  for (std::size_t i = first; i < run.frames.size() && i <= number + kNeighbours; ++i)
    if (const Json timing = run.frames[i].figures.value("timing", Json());
        i != number && timing.is_object())
      out.push_back({{"frame", i}, {"timing", timing}});
  return out;
}

Json difference_json(const FrameDifference& difference) {
  Json out = picture_error_json(difference.error);
  const bool same = difference.exact_png.empty();
  out["exact"] = same ? Json() : Json(data_uri("image/png", difference.exact_png));
  out["picture"] = same ? Json() : Json(data_uri("image/png", difference.difference_png));
  out["places"] = difference.places;
  return out;
}

// The section under construction.
class Section {
 public:
  Section(const RecordedRun& run, const std::filesystem::path& folder,
          const RunSectionOptions& options)
      : run_(run), folder_(folder), options_(options) {
    find_scene();
  }

  Json make() {
    Json frames = Json::array(), table = Json::array();
    const auto shown = spread_evenly(run_.frames.size(), options_.frames);
    for (const std::size_t number : shown) {
      frames.push_back(frame(number));
      if (options_.progress)
        options_.progress(static_cast<double>(frames.size()) / static_cast<double>(shown.size()));
    }
    for (std::size_t i = 0; i < run_.frames.size(); ++i) table.push_back(row_of(run_.frames[i], i));
    Json out = run_.stats;
    out["machine"] = machine_section(run_);
    out["background"] = repeater_ ? Json(colour_words(repeater_->database().background)) : Json();
    out["object_names"] = std::move(names_);
    out["shown"] = std::move(frames);
    out["table"] = std::move(table);
    out["notes"] = notes_;
    return out;
  }

 private:
  void note(std::string words) {
    if (std::find(notes_.begin(), notes_.end(), words) == notes_.end())
      notes_.push_back(std::move(words));
  }

  void find_scene() {
    try {
      repeater_.emplace(run_);
    } catch (const std::exception& error) {
      note(
          fmt::format("The scene cannot be had any more ({}). Difference pictures, crossings by "
                      "line and priority lists are left out.",
                      error.what()));
    }
  }

  Json frame(std::size_t number) {
    const RecordedFrame& recorded = run_.frames[number];
    Json out{{"frame", number},
             {"picture", data_uri("image/png", read_whole_file(folder_ / recorded.picture))},
             {"figures", recorded.figures},
             {"neighbours", neighbours_of(run_, number)},
             {"difference", nullptr},
             {"crossings", nullptr},
             {"faces", nullptr},
             {"limits", Json::array()}};
    // Read in any case: a picture that is none is no picture of the page either.
    const Picture picture = read_picture(recorded, folder_, run_.machine.raster);
    if (repeater_) add_repeated(number, picture, out);
    return out;
  }

  void add_repeated(std::size_t number, const Picture& picture, Json& out) {
    const RecordedFrame& recorded = run_.frames[number];
    const RepeatedFrame frame = repeater_->repeat(recorded, picture, options_.difference);
    if (frame.other_elements > 0) {
      note(fmt::format(
          "Frame {} computed again is another one at {} elements: the scene or the program is "
          "not the one of this run. Its difference picture, crossings by line and priority lists "
          "are left out.",
          number, frame.other_elements));
      return;
    }
    if (frame.difference) out["difference"] = difference_json(*frame.difference);
    out["crossings"] = frame.crossings;
    edges_ += frame.faces.edges.size();
    if (edges_ > kMostEdges) {
      note(fmt::format(
          "Priority lists stand for the first {} edges alone, so that the page stays small; take "
          "fewer frames (--frames) for those of other frames.",
          kMostEdges));
      return;
    }
    out["faces"] = faces_json(frame.faces, run_.machine.raster.width);
    out["limits"] = limits_json(frame.limits);
    for (const RasterFace& face : frame.faces.faces) name_object(face.object);
    for (const Json& fault : recorded.figures.value("listability", Json::array()))
      for (const Json& object : fault.value("objects", Json::array()))
        name_object(object.get<std::uint32_t>());
  }

  void name_object(std::uint32_t object) {
    const Database& database = repeater_->database();
    std::string& name = names_[std::to_string(object)];
    if (object == 0 || !name.empty()) return;
    if (object <= database.object_names.size()) name = database.object_names[object - 1];
    if (name.empty() && object > database.object_count)
      name = fmt::format("ground face {}", object - database.object_count);
  }

  const RecordedRun& run_;
  const std::filesystem::path& folder_;
  const RunSectionOptions& options_;
  std::optional<FrameRepeater> repeater_;
  std::map<std::string, std::string> names_;
  std::vector<std::string> notes_;
  std::size_t edges_ = 0;
};

}  // namespace

Json run_section(const RecordedRun& run, const std::filesystem::path& folder,
                 const RunSectionOptions& options) {
  return Section(run, folder, options).make();
}

}  // namespace cigsim
