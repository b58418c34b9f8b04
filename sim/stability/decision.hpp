// SPDX-License-Identifier: MIT
// A decision of the machine, posed at its extremes and answered in every number format.
//
// The answers come from the machine's own code for the format (models/…); the referee is rational
// arithmetic written for the purpose, which shares no formula with them. An answer is right when
// nothing that the machine shows or lists differs from what exact arithmetic on the same doubles
// gives.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/environment/random.hpp"
#include "models/machine/description.hpp"
#include "models/numeric/plane.hpp"
#include "sim/stability/extremes.hpp"
#include "sim/stability/material.hpp"

namespace cigsim::stability {

enum class Arithmetic : std::uint8_t { kFloat, kDouble, kCertified, kMachine, kExact };

struct Format {
  std::string name;
  Arithmetic arithmetic = Arithmetic::kDouble;
  MachineDescription machine;  ///< for kMachine: its word formats and hither distance

  friend bool operator==(const Format& a, const Format& b) { return a.name == b.name; }
};

/// A format by its name: float, double, certified, exact; a machine description's name (a preset,
/// with "machine" for "unlimited") or file; or words of any width, "machine:C,D,Q,R" for coordinate
/// bits and the fraction bits of directions, quotients and raster places. Throws UsageError, and
/// InputError for a description.
Format format_named(const std::string& name);
/// Those that are tried when none is named: float, double, certified, exact, machine (the widest
/// words) and nasa1968.
std::vector<Format> usual_formats();

/// What a decision is asked about. Which fields count is the decision's business. Doubles, taken as
/// exact; environment units.
struct Instance {
  std::vector<Vec3> points;
  std::vector<PlaneDefinition> planes;
  std::vector<Sphere> spheres;
  ViewTransform view;  ///< the eyepoint is view.eye
};

enum class Verdict : std::uint8_t {
  kNone,  ///< the format takes no such decision
  kRight,
  kWrong,
  kDoubtful  ///< the format itself says that it cannot (words saturated, a number not finite)
};

struct Outcome {
  Verdict verdict = Verdict::kNone;
  /// How far what the format computed is from the truth, in the decision's unit, where that is a
  /// quantity; of a yes or no that is wrong, how far the truth was from the border.
  std::optional<double> error;
  /// What the format's documents claim: the error is never larger. None: nothing is claimed.
  std::optional<double> bound;
};

struct Decision {
  std::string name;  ///< "side", as the command takes it
  std::string what;  ///< a sentence without its full stop
  std::string unit;  ///< of error and bound
  std::vector<Axis> axes;
  /// Taken at preparation or by the frame calculator, in one way whatever the frames' format is.
  bool shared = false;
  /// One instance; the same for the same arguments and state of `random`.
  std::function<Instance(const Material&, const Extremes&, Random&)> pose;
  /// An outcome for each format, in their order. Shared decisions give all the same.
  std::function<std::vector<Outcome>(const Instance&, std::span<const Format>)> judge;
};

/// All of them, in the order of the machine: preparation, frame calculator, priority processor,
/// geometry processor, edge orderer.
const std::vector<Decision>& decisions();

}  // namespace cigsim::stability
