// SPDX-License-Identifier: MIT
#include "sim/experiments/growth_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/database/prepare.hpp"
#include "models/environment/generate.hpp"
#include "models/environment/shapes.hpp"
#include "models/frame_calculator/functional.hpp"
#include "models/priority_processor/functional.hpp"
#include "sim/experiments/crowded_city.hpp"
#include "sim/processor_time.hpp"
#include "sim/scene.hpp"

namespace cigsim {
namespace {

constexpr std::uint32_t kFewest = 10, kInView = 10;

// Ten times as many each time, up to `most`, which is the last; a few more where that is little.
std::vector<std::uint32_t> sizes(std::uint32_t most) {
  constexpr std::uint32_t kLittle = 1000;
  std::vector<std::uint32_t> out;
  for (std::uint64_t decade = kFewest; decade < most; decade *= 10) {
    out.push_back(static_cast<std::uint32_t>(decade));
    if (most < kLittle && decade * 3 < most) out.push_back(static_cast<std::uint32_t>(decade * 3));
  }
  out.push_back(most);
  return out;
}

GrowthSubject subject(double x, const Environment& environment, const Viewpoint& viewpoint) {
  ProcessorTime time;
  auto database = std::make_shared<const Database>(prepare(environment));
  GrowthSubject made{x, std::move(database), viewpoint, {}};
  made.preparation_s = time.lap() * 1e-3;
  // What a frame costs that nothing was kept for.
  made.machine.coherence = false;
  return made;
}

Viewpoint view_of(const Environment& environment) {
  return {environment.view->eye, environment.view->fov};
}

std::vector<GrowthPoint> points_of(const std::vector<GrowthSubject>& subjects,
                                   const std::function<double(const GrowthSubject&)>& value) {
  std::vector<GrowthPoint> points;
  for (const GrowthSubject& s : subjects) {
    const double y = value(s);
    points.push_back({s.x, {y, y, y}});
  }
  return points;
}

double planes_of(const GrowthSubject& s) { return static_cast<double>(s.database->report.planes); }
double bytes_of(const GrowthSubject& s) { return database_bytes(*s.database); }
double preparation_of(const GrowthSubject& s) { return s.preparation_s; }
double frame_of(const FrameStats& f) { return f.host_ms; }
double calculator_of(const FrameStats& f) { return f.stages.frame_calculator; }
double priority_of(const FrameStats& f) { return f.stages.priority_processor; }
double geometry_of(const FrameStats& f) { return f.stages.geometry_processor; }

Picture picture_of(const GrowthSubject& subject) {
  return FunctionalMachine(*subject.database, subject.machine).compute(subject.viewpoint, 0);
}

// The frame took `ms`, and each stage its share of that.
void take_time(FrameStats& stats, double ms) {
  const double share = stats.host_ms > 0 ? ms / stats.host_ms : 0;
  stats.host_ms = ms;
  for (double* stage : {&stats.stages.frame_calculator, &stats.stages.geometry_processor,
                        &stats.stages.priority_processor, &stats.stages.edge_orderer,
                        &stats.stages.priority_resolver, &stats.stages.video_processor})
    *stage *= share;
}

std::size_t rounds_of(const GrowthOptions& options) { return options.quick ? 3 : 21; }

}  // namespace

void measure_frames(std::vector<GrowthSubject>& subjects, std::size_t rounds, std::uint64_t seed) {
  std::vector<FunctionalMachine> machines;
  for (const GrowthSubject& s : subjects) machines.emplace_back(*s.database, s.machine);
  for (const std::size_t i : interleaved(subjects.size(), rounds, seed)) {
    machines[i].compute(subjects[i].viewpoint, 0);
    ProcessorTime time;
    machines[i].compute(subjects[i].viewpoint, 0);
    const double ms = time.lap();
    subjects[i].frames.push_back(machines[i].stats());
    take_time(subjects[i].frames.back(), ms);
  }
}

std::vector<GrowthPoint> frame_points(const std::vector<GrowthSubject>& subjects,
                                      const std::function<double(const FrameStats&)>& value) {
  std::vector<GrowthPoint> points;
  for (const GrowthSubject& s : subjects) {
    std::vector<double> values;
    for (const FrameStats& frame : s.frames) values.push_back(value(frame));
    points.push_back({s.x, spread(std::move(values))});
  }
  return points;
}

double database_bytes(const Database& database) {
  const auto bytes = [](const auto& v) { return static_cast<double>(v.size() * sizeof v[0]); };
  const auto set_bytes = [&](const FaceSet& s) {
    return bytes(s.vertices) + bytes(s.cut_vertices) + bytes(s.corners) + bytes(s.planes) +
           bytes(s.faces) + bytes(s.items);
  };
  double sum = set_bytes(database.ground);
  for (const PreparedSystem& system : database.systems) {
    const PriorityHierarchy& h = system.hierarchy;
    sum += set_bytes(system.set) + bytes(h.planes) + bytes(h.nodes) + bytes(h.pairs) +
           bytes(h.members) + bytes(h.groups) + bytes(h.choices);
  }
  return sum;
}

bool same_views(const std::vector<GrowthSubject>& subjects, std::uint32_t in_view) {
  const Picture first = picture_of(subjects.front());
  // A ground face comes after all objects, so its number is not that of the smaller scene.
  const auto same_number = [&](std::uint16_t m, std::uint16_t n) {
    return m == n || (m > in_view && n > in_view);
  };
  return std::all_of(subjects.begin() + 1, subjects.end(), [&](const GrowthSubject& subject) {
    const Picture other = picture_of(subject);
    return first.colours == other.colours &&
           std::equal(first.numbers.begin(), first.numbers.end(), other.numbers.begin(),
                      other.numbers.end(), same_number);
  });
}

std::vector<GrowthCurve> grow_out_of_view(const GrowthOptions& options, bool& same_pictures) {
  std::vector<GrowthSubject> subjects;
  for (const std::uint32_t size : sizes(options.quick ? 300 : options.most_objects)) {
    const CrowdedCity city = make_crowded_city(kInView, size, options.seed);
    subjects.push_back(subject(size, city.environment, city.viewpoint));
  }
  same_pictures = same_views(subjects, kInView);
  measure_frames(subjects, rounds_of(options), options.seed);
  const std::string sweep = "objects, ten of them in view";
  return {
      {sweep,
       "frame, ms",
       "out_of_view_frame",
       "nothing to compute but what is in view, and the picture's bytes",
       true,
       {0, -0.15, 0.3},
       frame_points(subjects, frame_of)},
      {sweep,
       "frame_calculator, ms",
       "out_of_view_frame_calculator",
       "groups that the border of the view passes through: the root of the objects that a plane "
       "holds",
       true,
       {0.5, 0, 0.75},
       frame_points(subjects, calculator_of)},
      {sweep,
       "preparation, s",
       "preparation",
       "n log n: each object through every level of the tree of planes",
       true,
       {1.1, 0.9, 1.3},
       points_of(subjects, preparation_of)},
      {sweep,
       "planes of the environment",
       "planes",
       "n - 1 planes part n convex objects",
       false,
       {1, 0.97, 1.05},
       points_of(subjects, planes_of)},
      {sweep,
       "prepared database, bytes",
       "database_bytes",
       "each object and each plane has its place",
       false,
       {1, 0.95, 1.05},
       points_of(subjects, bytes_of)}};
}

std::vector<GrowthCurve> grow_in_view(const GrowthOptions& options) {
  std::vector<GrowthSubject> subjects;
  for (const std::uint32_t size :
       sizes(options.quick ? 300 : std::max(kFewest, options.most_objects / 10))) {
    const Environment city = generate_environment("city", {size, options.seed});
    subjects.push_back(subject(size, city, view_of(city)));
  }
  measure_frames(subjects, options.quick ? 3 : 9, options.seed);
  const std::string sweep = "objects, all in view";
  return {
      {sweep,
       "frame, ms",
       "in_view_frame",
       "the picture's bytes at first, then 1: each object is clipped, projected, ordered, drawn",
       true,
       {1, 0.4, 1.2},
       frame_points(subjects, frame_of)},
      {sweep,
       "geometry_processor, ms",
       "in_view_geometry_processor",
       "1: the faces of each object",
       true,
       {1, 0.8, 1.25},
       frame_points(subjects, geometry_of)},
      {sweep,
       "priority_processor, ms",
       "in_view_priority_processor",
       "1: groups are of up to 64 members, and their number grows",
       true,
       {1, 0.6, 1.4},
       frame_points(subjects, priority_of)},
      {sweep,
       "planes tested",
       "in_view_planes_tested",
       "n - 1: one side test a plane",
       false,
       {1, 0.97, 1.05},
       frame_points(subjects,
                    [](const FrameStats& f) { return static_cast<double>(f.tested_planes); })}};
}

std::vector<GrowthCurve> grow_edges(const GrowthOptions& options) {
  constexpr std::uint32_t kPrisms = 4;
  std::vector<GrowthSubject> subjects;
  for (std::uint32_t sides = 8; sides <= (options.quick ? 64u : 2048u); sides *= 2) {
    Environment environment;
    environment.models.push_back({"prisms", 0});
    for (std::uint32_t i = 0; i < kPrisms; ++i) {
      std::vector<Vec3> base;
      for (std::uint32_t k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        base.push_back({3.0 * i + std::cos(angle), std::sin(angle), 0});
      }
      environment.objects.push_back(prism(base, {0, 0, 1}));
    }
    // A prism has the edges of its two ends, and as many upright ones as each of those.
    subjects.push_back(
        subject(3.0 * sides * kPrisms, environment, {look_at({4.5, -9, 12}, {4.5, 0, 0}), 60}));
  }
  measure_frames(subjects, rounds_of(options), options.seed);
  return {{"edges of four prisms",
           "geometry_processor, ms",
           "edges_geometry_processor",
           "1: each corner is transformed and each edge projected",
           true,
           {1, 0.7, 1.2},
           frame_points(subjects, geometry_of)}};
}

std::vector<GrowthCurve> grow_raster(const GrowthOptions& options) {
  const auto airfield = std::make_shared<const Database>(load_scene({}, {}).database);
  std::vector<GrowthSubject> subjects;
  for (int side = 128; side <= (options.quick ? 512 : 8192); side *= 2) {
    GrowthSubject made{
        static_cast<double>(side) * side, airfield, {airfield->view.eye, airfield->view.fov}, {}};
    made.machine.coherence = false;
    made.machine.raster = {side, side};
    subjects.push_back(std::move(made));
  }
  measure_frames(subjects, options.quick ? 3 : 7, options.seed);
  const std::string sweep = "elements of the raster";
  return {{sweep,
           "frame, ms",
           "raster_frame",
           "1: six bytes are written for each element; below that lie the edges, above it the "
           "step where the picture outgrows the caches",
           true,
           {1, 0.7, 1.35},
           frame_points(subjects, frame_of)},
          {sweep,
           "picture, bytes",
           "raster_bytes",
           "1: six bytes an element",
           false,
           {1, 1, 1},
           points_of(subjects,
                     [](const GrowthSubject& s) {
                       Picture picture;
                       picture.fit(s.machine.raster);
                       return static_cast<double>(picture.colours.size() * sizeof(std::uint32_t) +
                                                  picture.numbers.size() * sizeof(std::uint16_t));
                     })},
          {sweep,
           "crossings",
           "raster_crossings",
           "1/2: edges cross lines, and lines grow as the side",
           false,
           {0.5, 0.47, 0.53},
           frame_points(subjects,
                        [](const FrameStats& f) { return static_cast<double>(f.crossings); })}};
}

}  // namespace cigsim
