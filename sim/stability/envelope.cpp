// SPDX-License-Identifier: MIT
#include "sim/stability/envelope.hpp"

#include <algorithm>
#include <cmath>

#include "sim/stability/envelope_worlds.hpp"

namespace cigsim::stability {
namespace {

// A judged frame of one format.
struct JudgedFrame {
  Measures measures;
  FrameFaults faults;
  SearchAxis axis = SearchAxis::kRaster;
  int step = 0, view = 0;
  const std::string* world = nullptr;
};

bool tells_of(SearchAxis axis, Quantity q) {
  switch (q) {
    case Quantity::kLines:
      return axis == SearchAxis::kRaster;
    case Quantity::kClearance:
      return axis == SearchAxis::kClearance;
    case Quantity::kSmallest:
      return axis == SearchAxis::kSmall;
    case Quantity::kLargest:
      return axis == SearchAxis::kLarge;
    case Quantity::kDemand:
      return axis == SearchAxis::kOffset || axis == SearchAxis::kFar;
    case Quantity::kNearness:
      return axis == SearchAxis::kNear;
    case Quantity::kCut:
      break;
  }
  return axis == SearchAxis::kClearance || axis == SearchAxis::kNear;
}

// What is wrong with the picture of an eyepoint near a plane is the business of `cut`.
bool is_wrong(const FrameFaults& faults, Quantity q) {
  if (q == Quantity::kClearance) return faults.priorities > 0 || faults.facings > 0;
  return faults.any();
}

// Where a wrong frame is one of many, many are looked at.
int views_at(SearchAxis axis, int views) {
  switch (axis) {
    case SearchAxis::kClearance:
      return 16 * views;
    case SearchAxis::kOffset:
    case SearchAxis::kFar:
      return 4 * views;
    case SearchAxis::kNear:
      return 2 * views;
    case SearchAxis::kRaster:
    case SearchAxis::kSmall:
    case SearchAxis::kLarge:
      break;
  }
  return views;
}

const QuantityName& named(Quantity q) { return quantity_names()[static_cast<std::size_t>(q)]; }

// The larger, the harder.
double hardness(const Measures& measures, Quantity q) {
  const double value = measures.*named(q).field;
  return named(q).least ? -value : value;
}

bool outside(const EnvelopeLimit& limit, const Measures& measures, Quantity q) {
  if (!limit.failure) return false;
  if (!limit.value) return true;
  const double bound = named(q).least ? -*limit.value : *limit.value;
  return hardness(measures, q) > bound;
}

// Whether a limit that was found before says already that the frame may be wrong.
bool explained(const Envelope& envelope, const Measures& measures, Quantity q) {
  for (std::size_t earlier = 0; earlier < static_cast<std::size_t>(q); ++earlier)
    if (outside(envelope.limits[earlier], measures, static_cast<Quantity>(earlier))) return true;
  return false;
}

void find_limit(const std::vector<JudgedFrame>& all, Quantity q, Envelope& envelope) {
  EnvelopeLimit& limit = envelope.limits[static_cast<std::size_t>(q)];
  std::vector<const JudgedFrame*> frames;
  for (const JudgedFrame& e : all)
    if (tells_of(e.axis, q) && !explained(envelope, e.measures, q)) frames.push_back(&e);
  if (frames.empty()) return;
  limit.searched = true;
  std::stable_sort(frames.begin(), frames.end(), [q](const JudgedFrame* a, const JudgedFrame* b) {
    return hardness(a->measures, q) < hardness(b->measures, q);
  });
  const auto value = [q](const JudgedFrame& e) { return e.measures.*named(q).field; };
  limit.reached = value(*frames.back());
  for (const JudgedFrame* e : frames) {
    if (is_wrong(e->faults, q)) {
      limit.failure = EnvelopeFailure{
          *e->world, std::string(name_of(e->axis)), e->step, e->view, value(*e), e->faults};
      break;
    }
    limit.value = value(*e);
  }
  // A wrong frame as hard as the last right one: the value before it.
  if (limit.failure && limit.value == limit.failure->value) {
    limit.value.reset();
    for (const JudgedFrame* e : frames) {
      if (value(*e) == limit.failure->value) break;
      limit.value = value(*e);
    }
  }
}

class Search {
 public:
  explicit Search(const EnvelopeOptions& options)
      : options_(options),
        worlds_(search_worlds(options.seed, options.airfield)),
        frames_(options.formats.size()) {}

  std::vector<Envelope> run() {
    for (const SearchAxis axis : kSearchAxes) count_steps(axis);
    for (const SearchAxis axis : kSearchAxes) walk(axis);
    std::vector<Envelope> out;
    for (std::size_t f = 0; f < options_.formats.size(); ++f) {
      Envelope& envelope = out.emplace_back();
      envelope.format = options_.formats[f];
      envelope.frames = frames_[f].size();
      for (const JudgedFrame& e : frames_[f]) envelope.wrong += e.faults.any();
      for (const QuantityName& q : quantity_names()) {
        find_limit(frames_[f], q.quantity, envelope);
        envelope.limits[static_cast<std::size_t>(q.quantity)].predicted =
            predicted_limit(envelope.format, q.quantity);
      }
    }
    return out;
  }

 private:
  template <class Use>
  void for_each_step(SearchAxis axis, Use use) const {
    const Steps steps = steps_of(axis);
    for (int step = steps.first; step <= steps.last; step += steps.by * options_.stride)
      if (axis != SearchAxis::kRaster || 1 << step <= options_.most_lines) use(step);
  }

  void count_steps(SearchAxis axis) {
    for_each_step(axis, [this](int) { ++steps_; });
  }

  void walk(SearchAxis axis) {
    for_each_step(axis, [&](int step) {
      for (std::size_t w = 0; w < worlds_.size(); ++w) judge_step(axis, step, w);
      ++done_;
      if (options_.progress) options_.progress(static_cast<double>(done_) / steps_);
    });
  }

  void judge_step(SearchAxis axis, int step, std::size_t w) {
    const SteppedWorld world(worlds_[w], axis, step);
    for (int view = 0; view < views_at(axis, options_.views); ++view) {
      // The same instance, however coarse the search.
      Random random(options_.seed +
                    0x9e3779b97f4a7c15u * ((static_cast<std::uint64_t>(axis) << 24) +
                                           (static_cast<std::uint64_t>(step) << 16) + (w << 8) +
                                           static_cast<std::uint64_t>(view) + 1));
      const std::optional<Viewpoint> viewpoint = world.viewpoint(random);
      if (!viewpoint) continue;
      const ExactFrame frame(world.database(), *viewpoint, world.raster());
      if (frame.items().empty()) continue;
      const Measures measures = frame.measures();
      for (std::size_t f = 0; f < options_.formats.size(); ++f) {
        const Format& format = options_.formats[f];
        // 13.18 holds no more lines.
        if (format.arithmetic == Arithmetic::kMachine && measures.lines > 8191) continue;
        // The words of two machines may be the same.
        std::size_t same = 0;
        while (!same_numbers(options_.formats[same], format)) ++same;
        const FrameFaults faults = same < f ? frames_[same].back().faults : frame.judge(format);
        frames_[f].push_back({measures, faults, axis, step, view, &worlds_[w].name});
      }
    }
  }

  const EnvelopeOptions& options_;
  std::vector<SearchWorld> worlds_;
  std::vector<std::vector<JudgedFrame>> frames_;  // by format
  int steps_ = 0, done_ = 0;
};

// The unit of the largest coordinate that a format keeps, as a share of it.
std::optional<double> unit_of(const Format& format) {
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      return 0x1p-24;
    case Arithmetic::kDouble:
      return 0x1p-53;
    case Arithmetic::kMachine:
      return std::ldexp(1, 2 - format.machine.formats.coordinate_bits);
    case Arithmetic::kCertified:
    case Arithmetic::kExact:
      break;
  }
  return std::nullopt;
}

}  // namespace

bool same_numbers(const Format& a, const Format& b) {
  return a.arithmetic == b.arithmetic && a.machine.formats == b.machine.formats &&
         a.machine.hither == b.machine.hither;
}

const std::array<QuantityName, kQuantities>& quantity_names() {
  static const std::array<QuantityName, kQuantities> names{{
      {Quantity::kLines, "lines", "lines or elements a line of the raster", &Measures::lines,
       false},
      {Quantity::kClearance, "clearance",
       "distance of the eyepoint from the nearest plane, as a share of the largest coordinate",
       &Measures::clearance, true},
      {Quantity::kSmallest, "smallest", "radius of the smallest item, in units",
       &Measures::smallest, true},
      {Quantity::kLargest, "largest", "largest coordinate, in units", &Measures::largest, false},
      {Quantity::kDemand, "demand",
       "elements that the largest coordinate would span at the nearest face's distance",
       &Measures::demand, false},
      {Quantity::kNearness, "nearness",
       "distance of the nearest face, as a share of the largest coordinate", &Measures::nearness,
       true},
      {Quantity::kCut, "cut",
       "the same as demand of the nearest face that reaches out of the pyramid of vision",
       &Measures::cut, false},
  }};
  return names;
}

std::vector<Format> searched_formats() {
  std::vector<Format> formats{{"float", Arithmetic::kFloat, {}},
                              {"double", Arithmetic::kDouble, {}},
                              {"certified", Arithmetic::kCertified, {}}};
  for (const std::string& preset : machine_presets())
    formats.push_back({preset, Arithmetic::kMachine, machine_preset(preset)});
  return formats;
}

std::vector<Envelope> search_envelope(const EnvelopeOptions& options) {
  return Search(options).run();
}

std::optional<double> predicted_limit(const Format& format, Quantity quantity) {
  const std::optional<double> unit = unit_of(format);
  if (!unit) return std::nullopt;
  const bool words = format.arithmetic == Arithmetic::kMachine;
  switch (quantity) {
    case Quantity::kLines:
      if (words) return std::ldexp(kEdgeMargin, format.machine.formats.raster_fraction + 1);
      return std::nullopt;
    case Quantity::kClearance:
      // Sides are exact in double. On words a unit normal has its own unit.
      if (format.arithmetic == Arithmetic::kFloat) return 4 * *unit;
      if (words)
        return 4 * std::max(*unit, std::ldexp(1, -format.machine.formats.direction_fraction));
      return std::nullopt;
    case Quantity::kSmallest:
      if (format.arithmetic == Arithmetic::kFloat) return std::exp2(-126.0 / 3);
      return std::nullopt;
    case Quantity::kLargest:
      if (format.arithmetic == Arithmetic::kFloat) return std::exp2(128.0 / 3);
      return std::nullopt;
    case Quantity::kDemand:
      return kEdgeMargin / (4 * *unit);
    case Quantity::kNearness:
      if (words) return format.machine.hither * *unit;
      return std::nullopt;
    case Quantity::kCut:
      // Cuts are made with quotients.
      if (words)
        return kEdgeMargin /
               (4 * std::max(*unit, std::ldexp(1, -format.machine.formats.quotient_fraction)));
      return format.arithmetic == Arithmetic::kFloat ? std::optional(kEdgeMargin / (4 * *unit))
                                                     : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace cigsim::stability
