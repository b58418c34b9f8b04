// SPDX-License-Identifier: MIT
// Levine's measurements of his hidden-line algorithm (1975, ch. VII and app. III), repeated: eight
// data sets, each yawed and then pitched through 360 degrees in steps of one degree.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/environment/environment.hpp"
#include "models/hidden_line/hidden_lines.hpp"
#include "sim/experiments/hull_experiment.hpp"

namespace cigsim {

struct HiddenLineFrame {
  hidden_line::Counters counters;
  double ms = 0;
};

struct HiddenLineDataSet {
  std::string name;
  bool cubes = false;  ///< one of the six lattice sets, which his graphs connect
  std::size_t objects = 0, edges = 0;
  std::vector<HiddenLineFrame> yaw, pitch;  ///< a frame a degree, from 0
};

struct NamedCounter {
  const char* key;
  const char* letters;
  std::uint64_t hidden_line::Counters::*value;
};

inline constexpr NamedCounter kHiddenLineCounters[] = {
    {"front_faces", "FF", &hidden_line::Counters::front_faces},
    {"objects_considered_invisibility", "OC/I", &hidden_line::Counters::objects_considered_inv},
    {"objects_in_window_invisibility", "OW/I", &hidden_line::Counters::objects_in_window_inv},
    {"extreme_edges_considered_invisibility", "EEC/I",
     &hidden_line::Counters::edges_considered_inv},
    {"intersections_computed_invisibility", "IC/I",
     &hidden_line::Counters::intersections_computed_inv},
    {"edges_displayed", "ED", &hidden_line::Counters::edges_displayed},
    {"objects_considered", "OC/HL", &hidden_line::Counters::objects_considered},
    {"objects_in_window", "OW/HL", &hidden_line::Counters::objects_in_window},
    {"extreme_edges_considered", "EEC/HL", &hidden_line::Counters::edges_considered},
    {"intersections_computed", "IC/HL", &hidden_line::Counters::intersections_computed},
    {"actual_intersections", "AI/HL", &hidden_line::Counters::actual_intersections}};

/// All eight sets. `city` is scenes/levine-city.json, whose sizes are a reconstruction; the random
/// cubes depend on the seed. `step` is the angle between frames, degrees; his is 1.
std::vector<HiddenLineDataSet> run_hidden_line_experiment(const ExperimentOptions& options,
                                                          const Environment& city, int step = 1);

/// Averages over all frames of a set.
double average(const HiddenLineDataSet& set, std::uint64_t hidden_line::Counters::*counter);
double average_ms(const HiddenLineDataSet& set);

}  // namespace cigsim
