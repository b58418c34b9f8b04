// SPDX-License-Identifier: MIT
#include "sim/budget/budget_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/arguments.hpp"
#include "sim/budget/cache.hpp"
#include "sim/budget/evidence.hpp"
#include "sim/budget/frames.hpp"
#include "sim/measure/measure.hpp"
#include "sim/measure/reference.hpp"
#include "sim/rtl/library.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFrames = 5;        // sampled, and held back
constexpr std::size_t kMostProofs = 2;        // held back, in rational numbers
constexpr double kMostReferences = 1u << 30;  // bytes that right pictures may take
constexpr double kReferenceBytes = 10;        // an element: colour, number, distance
constexpr double kSampleShare = 0.7;          // of the work, about

// "1 frame", "2 sampled frames".
std::string frames_text(std::size_t count, const char* which = "") {
  return fmt::format("{} {}frame{}", count, which, count == 1 ? "" : "s");
}

// A frame that was held back.
struct Checked {
  std::size_t frame = 0;
  ErrorFigures errors;
  double distance = 0;
  bool kept = true;
};

class Calibration {
 public:
  explicit Calibration(const BudgetRequest& request) : request_(request), range_(request.range) {
    const Raster& raster = range_.words.raster;
    const double picture = kReferenceBytes * raster.width * raster.height;
    const double fits = std::max(1.0, kMostReferences / picture);
    sample_ = sample_frames(request.views.size(),
                            static_cast<std::size_t>(std::min<double>(kMostFrames, fits)));
    if (request.budget.kind == Budget::Kind::kExact && sample_.held_back.size() > kMostProofs)
      sample_.held_back.resize(kMostProofs);
    if (request.budget.kind == Budget::Kind::kNone) sample_.held_back.clear();
    if (request.budget.cycles) find_referee();
    settings_ = candidates(request.budget, range_);
  }

  BudgetOutcome settle() {
    const std::vector<FrameView> views = views_of(sample_.sampled);
    const Json key = evidence_key(*request_.database, views, settings_, range_.referee);
    const std::filesystem::path file = evidence_file(key);
    const auto known = read_evidence(file, key);
    const std::vector<Evidence> evidence = known ? *known : gather(views);
    bool cached = known.has_value();
    // What failed may succeed another time.
    const bool whole = std::all_of(evidence.begin(), evidence.end(),
                                   [](const Evidence& one) { return one.measured; });
    if (!known && whole) cached = keep(file, key, evidence);
    const auto chosen = choose(request_.budget, evidence);
    if (!chosen)
      throw UsageError(fmt::format("--max-error: no setting keeps {} on this scene; nearest: {}",
                                   request_.budget.text, nearest_text(request_.budget, evidence)));
    const std::vector<Checked> checked = check(settings_[*chosen]);
    BudgetOutcome outcome;
    outcome.chosen = settings_[*chosen];
    outcome.kept = std::all_of(checked.begin(), checked.end(),
                               [](const Checked& frame) { return frame.kept; });
    outcome.lines = lines(evidence, *chosen, checked);
    for (const Evidence& one : evidence)
      if (!one.measured) outcome.lines.push_back(one.name + " could not be measured; left out");
    if (numbers_saturate(*request_.database)) outcome.lines.emplace_back(kNumbersSaturate);
    outcome.lines.push_back(!whole    ? "measured now; not kept for later runs"
                            : !cached ? "measured now; it could not be kept for later runs"
                            : known   ? fmt::format("as measured earlier: {}", file.string())
                                      : fmt::format("measured now, kept in {}", file.string()));
    outcome.json = json(evidence, *chosen, checked);
    outcome.json["host"] = {{"from_earlier_run", known.has_value()},
                            {"evidence", cached ? Json(file.string()) : Json()}};
    return outcome;
  }

 private:
  std::vector<FrameView> views_of(const std::vector<std::size_t>& frames) const {
    std::vector<FrameView> views;
    for (const std::size_t frame : frames) views.push_back(request_.views[frame]);
    return views;
  }
  void progress(double share) const {
    if (request_.progress) request_.progress(share);
  }

  // RTL where it is there or can be built, else the clocked level.
  void find_referee() {
    Setting setting;
    setting.machine = range_.words;
    range_.referee = Level::kRtl;
    try {
      rtl_libraries(at_level(setting, Level::kRtl), *request_.database);
    } catch (const UsageError& error) {
      say_on_stderr(fmt::format("{}; the clocked level takes its place", error.what()));
      range_.referee = Level::kClocked;
    }
  }

  std::vector<Cycle> referee_delays(const Setting& setting, Workload work) const {
    work.references = nullptr;
    MeasureOptions once;
    once.rounds = 1;
    return measure({at_level(setting, range_.referee)}, work, once).front().delays;
  }

  std::vector<Evidence> gather(const std::vector<FrameView>& views) const {
    // What is to be proved is not compared with itself.
    const bool proof = request_.budget.kind == Budget::Kind::kExact;
    const auto references = reference_pictures(
        *request_.database, views, range_.words.raster,
        [this](double share) { progress(kSampleShare / 4 * share); },
        proof ? NumberType::kExact : exact_number());
    const Workload work{request_.database, views, &references};
    MeasureOptions options;
    options.progress = [this](double share, const std::string&) {
      progress(kSampleShare * (1 + 3 * share) / 4);
    };
    const std::vector<Measured> measured = measure(settings_, work, options);
    std::map<double, std::vector<Cycle>> referees;  // by the scale of levels of detail
    for (const Measured& m : measured)
      if (m.setting.levels == at_level(m.setting, range_.referee).levels)
        referees[m.setting.machine.detail] = m.delays;
    std::vector<Evidence> evidence;
    for (const Measured& m : measured) {
      Evidence& e = evidence.emplace_back();
      const PictureError error = m.error();
      e.name = m.setting.name;
      e.measured = !m.given_up;
      e.frame_ms = m.frame_ms;
      e.worst = {error.worst_share, error.worst_mean_colour, {}};
      e.worst_distance = error.worst_distance;
      if (m.delays.empty()) continue;
      const double scale = m.setting.machine.detail;
      if (!referees.contains(scale)) referees[scale] = referee_delays(m.setting, work);
      e.worst.cycles = cycle_error(m.delays, referees[scale]);
    }
    return evidence;
  }

  // Evidence that cannot be kept serves this run nevertheless.
  static bool keep(const std::filesystem::path& file, const Json& key,
                   const std::vector<Evidence>& evidence) {
    try {
      write_evidence(file, key, evidence);
      return true;
    } catch (const std::exception& error) {
      say_on_stderr(fmt::format("cigsim: evidence is not kept: {}", error.what()));
      return false;
    }
  }

  std::vector<Checked> check(const Setting& setting) const {
    progress(kSampleShare);
    if (sample_.held_back.empty()) return {};
    const std::vector<FrameView> views = views_of(sample_.held_back);
    const bool proof = request_.budget.kind == Budget::Kind::kExact;
    const auto references = reference_pictures(
        *request_.database, views, range_.words.raster,
        [this](double share) { progress(kSampleShare + (1 - kSampleShare) * share); },
        proof ? NumberType::kExact : exact_number());
    const Workload work{request_.database, views, &references};
    MeasureOptions once;
    once.rounds = 1;
    const Measured measured = measure({setting}, work, once).front();
    if (measured.given_up)
      throw UsageError(fmt::format("--max-error: {} on the frames held back", *measured.given_up));
    std::vector<Cycle> referee;
    if (request_.budget.cycles && !measured.delays.empty()) referee = referee_delays(setting, work);
    std::vector<Checked> checked;
    for (std::size_t i = 0; i < views.size(); ++i) {
      const PictureError& error = measured.errors[i];
      Checked& frame = checked.emplace_back();
      frame.frame = sample_.held_back[i];
      frame.errors = {error.share(), error.mean_colour(), {}};
      if (i < referee.size()) frame.errors.cycles = cycle_error({measured.delays[i]}, {referee[i]});
      frame.distance = error.worst_distance;
      frame.kept = keeps(request_.budget, frame.errors);
    }
    return checked;
  }

  std::string why(const std::vector<Evidence>& evidence, std::size_t chosen) const {
    const Evidence& e = evidence[chosen];
    const auto keeping = std::count_if(evidence.begin(), evidence.end(), [&](const Evidence& one) {
      return one.measured && keeps(request_.budget, one.worst);
    });
    std::string text = fmt::format(
        "{}: {:.3f} ms a frame, the fastest of the {} of {} settings that keep {} on {} "
        "(worst: {})",
        e.name, e.frame_ms.median, keeping, evidence.size(), request_.budget.text,
        frames_text(sample_.sampled.size(), "sampled "), errors_text(request_.budget, e.worst));
    if (const auto next = second(request_.budget, evidence, chosen))
      text += fmt::format("; next is {} with {:.3f} ms", evidence[*next].name,
                          evidence[*next].frame_ms.median);
    return text;
  }

  std::vector<std::string> lines(const std::vector<Evidence>& evidence, std::size_t chosen,
                                 const std::vector<Checked>& checked) const {
    std::vector<std::string> out{why(evidence, chosen)};
    if (checked.empty()) {
      if (request_.budget.kind != Budget::Kind::kNone)
        out.push_back("kept; no frame was held back, since all were sampled");
      return out;
    }
    const auto broken = std::count_if(checked.begin(), checked.end(),
                                      [](const Checked& frame) { return !frame.kept; });
    const Checked& worst =
        *std::max_element(checked.begin(), checked.end(), [&](const Checked& a, const Checked& b) {
          const double x = excess(request_.budget, a.errors), y = excess(request_.budget, b.errors);
          return x < y || (x == y && a.errors.elements < b.errors.elements);
        });
    if (broken == 0)
      out.push_back(fmt::format("kept on {} held back (worst: frame {}, {})",
                                frames_text(checked.size()), worst.frame,
                                errors_text(request_.budget, worst.errors)));
    else
      out.push_back(fmt::format(
          "BROKEN on {} of {} held back (worst: frame {}, {}, up to {:.1f} elements from an "
          "edge)",
          broken, frames_text(checked.size()), worst.frame,
          errors_text(request_.budget, worst.errors), worst.distance));
    return out;
  }

  Json json(const std::vector<Evidence>& evidence, std::size_t chosen,
            const std::vector<Checked>& checked) const {
    Json list = Json::array();
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      Json one = evidence_json(evidence[i]);
      one["keeps"] = evidence[i].measured && keeps(request_.budget, evidence[i].worst);
      one["setting"] = setting_json(settings_[i]);
      list.push_back(std::move(one));
    }
    Json held = Json::array();
    bool kept = true;
    for (const Checked& frame : checked) {
      kept = kept && frame.kept;
      held.push_back({{"frame", frame.frame},
                      {"elements", frame.errors.elements},
                      {"worst_distance", frame.distance},
                      {"colour", frame.errors.colour},
                      {"cycles", frame.errors.cycles ? Json(*frame.errors.cycles) : Json()},
                      {"kept", frame.kept}});
    }
    return {{"text", request_.budget.text},
            {"chosen", evidence[chosen].name},
            {"why", why(evidence, chosen)},
            {"kept", kept},
            {"referee", request_.budget.cycles ? Json(name_of(range_.referee)) : Json()},
            {"sampled", sample_.sampled},
            {"candidates", std::move(list)},
            {"held_back", std::move(held)}};
  }

  const BudgetRequest& request_;
  CandidateRange range_;
  FrameSample sample_;
  std::vector<Setting> settings_;
};

}  // namespace

BudgetOutcome settle_budget(const BudgetRequest& request) { return Calibration(request).settle(); }

}  // namespace cigsim
