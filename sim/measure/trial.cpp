// SPDX-License-Identifier: MIT
#include "sim/measure/trial.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "sim/measure/child.hpp"
#include "sim/measure/digest.hpp"
#include "sim/stats.hpp"
#include "sim/systemc_machine.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using Libraries = std::map<Stage, std::filesystem::path>;

// Frames are repeated until they have taken so long together, or were computed so often.
constexpr double kLongEnough_ms = 30;
constexpr std::size_t kMostPasses = 32;

// Memory of the process that belongs to no file, MiB; 0 where the system does not tell it.
double private_memory_mib() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("RssAnon:")) return std::strtod(line.c_str() + 8, nullptr) / 1024;
  return 0;
}

class Memory {
 public:
  void look() { most_ = std::max(most_, private_memory_mib()); }
  double growth_mib() const { return most_ - start_; }

 private:
  double start_ = private_memory_mib(), most_ = start_;
};

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// What is kept of the pictures of a trial.
class Pictures {
 public:
  explicit Pictures(const Workload& work) : work_(work) {}

  void add(std::size_t view, const Picture& picture) {
    digest_.add(bytes_of(picture.colours));
    digest_.add(bytes_of(picture.numbers));
    if (work_.references != nullptr)
      errors_.push_back(picture_error(picture, (*work_.references)[view]));
  }
  void give(Trial& trial) const {
    trial.errors = errors_;
    trial.digest = digest_.value();
  }

 private:
  const Workload& work_;
  Digest digest_;
  std::vector<PictureError> errors_;
};

Trial functional_trial(const Setting& setting, const Workload& work) {
  Trial trial;
  Memory memory;
  Pictures pictures(work);
  FunctionalMachine machine(*work.database, setting.machine);
  machine.compute(work.views.back().viewpoint, work.views.back().position);
  std::vector<std::vector<double>> times(work.views.size());
  double total = 0;
  for (std::size_t pass = 0; pass == 0 || (pass < kMostPasses && total < kLongEnough_ms); ++pass)
    for (std::size_t v = 0; v < work.views.size(); ++v) {
      const FrameView& view = work.views[v];
      const Picture& picture = machine.compute(view.viewpoint, view.position);
      times[v].push_back(machine.stats().host_ms);
      total += times[v].back();
      memory.look();
      if (pass > 0) continue;
      pictures.add(v, picture);
      trial.overload.add(machine.stats());
    }
  for (const std::vector<double>& ms : times) trial.frame_ms.push_back(median(ms));
  trial.memory_mib = memory.growth_mib();
  pictures.give(trial);
  return trial;
}

// One frame goes before those that count, and two follow, so that the three pictures in the machine
// are there at all times.
Trial pipeline_trial(const Setting& setting, const Workload& work, const Libraries& libraries) {
  Trial trial;
  Memory memory;
  Pictures pictures(work);
  SystemcMachine machine("trial", pipeline_options(setting, libraries));
  const std::size_t count = work.views.size();
  std::size_t fed = 0, shown = 0;
  Cycle last = 0;
  machine.feed(
      [&]() -> std::optional<FrameJob> {
        if (fed == count + 3) return {};
        const FrameView& view = work.views[(fed++ + count - 1) % count];
        return FrameJob{work.database, view.viewpoint, view.position};
      },
      [&](const Picture& picture, const FrameStats& stats) {
        memory.look();
        if (shown > 0 && shown <= count) {
          trial.frame_ms.push_back(stats.host_ms);
          trial.delays.push_back(stats.timing->transport_delay());
          trial.cycles += stats.timing->last_element - last;
          pictures.add(shown - 1, picture);
          trial.overload.add(stats);
        }
        last = stats.timing->last_element;
        if (++shown == count + 1) machine.stop(1);
      });
  SystemcMachine::simulate({&machine});
  trial.memory_mib = memory.growth_mib();
  pictures.give(trial);
  return trial;
}

Json to_wire(const PictureError& e) {
  return {e.pictures,   e.elements,     e.wrong,       e.worst_distance,   e.wrong_colours,
          e.colour_sum, e.worst_colour, e.worst_share, e.worst_mean_colour};
}

PictureError error_from_wire(const Json& json) {
  PictureError e;
  json[0].get_to(e.pictures);
  json[1].get_to(e.elements);
  json[2].get_to(e.wrong);
  json[3].get_to(e.worst_distance);
  json[4].get_to(e.wrong_colours);
  json[5].get_to(e.colour_sum);
  json[6].get_to(e.worst_colour);
  json[7].get_to(e.worst_share);
  json[8].get_to(e.worst_mean_colour);
  return e;
}

Json to_wire(const Trial& trial) {
  Json errors = Json::array();
  for (const PictureError& error : trial.errors) errors.push_back(to_wire(error));
  return {{"frame_ms", trial.frame_ms}, {"memory_mib", trial.memory_mib},
          {"delays", trial.delays},     {"cycles", trial.cycles},
          {"errors", errors},           {"overload", overload_sum_json(trial.overload)},
          {"digest", trial.digest}};
}

Trial trial_from_wire(const Json& json) {
  Trial trial;
  json.at("frame_ms").get_to(trial.frame_ms);
  json.at("memory_mib").get_to(trial.memory_mib);
  json.at("delays").get_to(trial.delays);
  json.at("cycles").get_to(trial.cycles);
  for (const Json& error : json.at("errors")) trial.errors.push_back(error_from_wire(error));
  trial.overload = overload_sum_from_json(json.at("overload"));
  json.at("digest").get_to(trial.digest);
  return trial;
}

}  // namespace

Trial run_trial(const Setting& setting, const Workload& work, const Libraries& libraries,
                double limit_s) {
  return trial_from_wire(in_child(setting.name, limit_s, [&] {
    return to_wire(setting.levels.functional() ? functional_trial(setting, work)
                                               : pipeline_trial(setting, work, libraries));
  }));
}

}  // namespace cigsim
