// SPDX-License-Identifier: MIT
#include "sim/stability/accumulation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "models/edge_orderer/functional.hpp"
#include "models/geometry_processor/functional.hpp"
#include "models/geometry_processor/functional_words.hpp"
#include "models/machine/scale.hpp"

namespace cigsim::stability {
namespace {

constexpr int kPoints[] = {1, 16, 64, 256, 480, 1024, 2048, 4096, 8190};

// Floating-point edges are stepped times 2^kFiner, which scales every number in them exactly: the
// whole element that comes out then tells the place to 2^-kFiner.
constexpr int kFiner = 16;

// A triangle before an eyepoint at the origin that looks north: a plane of constant distance, in
// which a unit spans an element.
struct Trial {
  FaceSet set;
  ViewTransform view;
  double top_x = 0, top_y = 0, bottom_x = 0, bottom_y = 0;  ///< of the long edge, on the raster
};

Trial make_trial(int lines, Random& random) {
  const double half = lines / 2.0;
  const auto sixteenths = [&](double low, double high) {
    return std::floor(random.between(low, high) * 16) / 16;
  };
  const double top_x = sixteenths(2, lines - 2), bottom_x = sixteenths(2, lines - 2);
  const double top_y = sixteenths(0, 0.5), bottom_y = lines - sixteenths(0, 0.4);
  const double third_x = top_x + bottom_x < lines ? lines - 1 : 1;
  const auto corner = [&](double x, double y) { return Vec3{x - half, half, half - y}; };
  Trial trial{{}, {}, top_x, top_y, bottom_x, bottom_y};
  trial.set.vertices = {corner(top_x, top_y), corner(bottom_x, bottom_y), corner(third_x, half)};
  trial.set.corners = {0, 1, 2};
  trial.set.planes = {
      plane_through(trial.set.vertices[0], trial.set.vertices[1], trial.set.vertices[2])};
  PreparedFace face;
  face.corner_count = 3;
  face.object = 1;
  face.two_sided = true;
  trial.set.faces = {face};
  trial.set.items = {{0, 1, 0, 3, {{0, half, 0}, 2.0 * lines}}};
  trial.view = {{}, {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}, half, {lines, lines}};
  return trial;
}

// Of the triangle's edges the one that crosses the most lines.
template <class N>
Edge<N> long_edge(const EdgeList<N>& list) {
  if (list.edges.empty()) throw std::logic_error("a triangle across the raster has no edges");
  return *std::max_element(list.edges.begin(), list.edges.end(), [](const auto& a, const auto& b) {
    return a.end_line - a.first_line < b.end_line - b.first_line;
  });
}

template <class N>
Edge<N> set_up(const Trial& trial) {
  const ItemRef item{SetId::kStatic, 0};
  const FaceSet none;
  geometry_processor::Functional<N> geometry;
  EdgeList<N> edges;
  geometry.compute(trial.view, {&trial.set, &none, &none}, std::span(&item, 1), edges);
  return long_edge(edges);
}

Edge<MachineWord> set_up_in_words(const Trial& trial, const MachineDescription& machine) {
  Database database;
  database.systems.emplace_back().set = trial.set;
  const int scale = coordinate_scale(database, machine.formats);
  const geometry_processor::FaceMemory memory(trial.set, scale, machine);
  std::uint64_t overflows = 0;
  const geometry_processor::GeometryBank bank{
      view_words(trial.view, scale, machine.formats, overflows), {&memory, &memory, &memory}};
  const ItemWord items[] = {{SetId::kStatic, 0, false}, {SetId::kStatic, 0, true}};
  geometry_processor::FunctionalWords geometry(machine);
  geometry_processor::Figures figures;
  EdgeList<MachineWord> edges;
  geometry.compute(bank, items, edges, figures);
  return long_edge(edges);
}

// Where a format has the edge on the lines from its first one on.
struct Stepped {
  int first_line = 0;
  std::vector<double> place;  ///< a value that the place lies within `below` of and not above
  double below = 0;
  std::vector<std::int32_t> element;
};

template <class N>
Stepped step(const Edge<N>& edge, int width) {
  const auto lines = static_cast<std::size_t>(edge.end_line - edge.first_line);
  Stepped out;
  out.first_line = edge.first_line;
  out.element.resize(lines);
  edge_orderer::step_edge(edge, edge.first_line, edge.end_line, width, out.element.data());
  Edge<N> finer = edge;
  finer.x = std::ldexp(edge.x, kFiner);
  finer.slope = std::ldexp(edge.slope, kFiner);
  std::vector<std::int32_t> element(lines);
  edge_orderer::step_edge(finer, edge.first_line, edge.end_line, width << kFiner, element.data());
  for (const std::int32_t e : element) out.place.push_back(std::ldexp(e, -kFiner));
  out.below = std::ldexp(1, -kFiner);
  return out;
}

Stepped step(const Edge<MachineWord>& edge, int width) {
  edge_orderer::EdgeBank bank(edge.end_line);
  EdgeWord word;
  word.first_line = static_cast<std::uint16_t>(edge.first_line);
  word.end_line = static_cast<std::uint16_t>(edge.end_line);
  word.left = edge.left;
  word.x = edge.x.raw;
  word.slope = edge.slope.raw;
  bank.add(word);
  edge_orderer::LineOrderer orderer(width, 0, OverloadPolicy::kDrop);
  orderer.begin(bank);
  Stepped out;
  out.first_line = edge.first_line;
  for (int line = 0; line < edge.end_line; ++line) {
    const edge_orderer::OrderedLine& ordered = orderer.next();
    if (line < edge.first_line) continue;
    out.place.push_back(to_double(MachineWord{ordered.crossings[0].x}));
    out.element.push_back(ordered.crossings[0].element());
  }
  return out;
}

// The long edge in a format; nothing for exact numbers, which are the referee.
std::optional<Stepped> stepped(const Format& format, const Trial& trial) {
  const int width = trial.view.raster.width;
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
      return step(set_up<float>(trial), width);
    case Arithmetic::kDouble:
      return step(set_up<double>(trial), width);
    case Arithmetic::kMachine: {
      MachineDescription machine = machine_preset("unlimited");
      machine.raster = trial.view.raster;
      machine.formats = format.machine.formats;
      machine.hither = format.machine.hither;
      return step(set_up_in_words(trial, machine), width);
    }
    case Arithmetic::kCertified:
    case Arithmetic::kExact:
      break;
  }
  return std::nullopt;
}

// How far `exact` is from the places that the format may have meant.
double error_of(const Stepped& got, std::size_t line, const Exact& exact) {
  const double above = to_double(Exact(exact - Exact(got.place[line])));
  if (above > 0) return above;
  return std::max(0.0, -above - got.below);
}

// The long edge by the equation of its line: columns measured from the first sample.
struct ExactEdge {
  int first_line = 0;
  Exact slope;
  std::vector<Exact> place;
  std::vector<std::int32_t> element;  ///< the first whose sample is not left of it
};

ExactEdge exact_edge(const Trial& trial) {
  const Exact half(0.5), top(trial.top_y), bottom(trial.bottom_y);
  const Raster& raster = trial.view.raster;
  ExactEdge out;
  out.first_line = ceil_clamped(Exact(top - half), 0, raster.height);
  out.slope = (Exact(trial.bottom_x) - Exact(trial.top_x)) / (bottom - top);
  const int end = ceil_clamped(Exact(bottom - half), 0, raster.height);
  for (int line = out.first_line; line < end; ++line) {
    out.place.push_back(Exact(trial.top_x + out.slope * (line + half - top) - half));
    out.element.push_back(ceil_clamped(out.place.back(), 0, raster.width));
  }
  return out;
}

// A line that one of the two has and the other does not.
void note_line(Accumulation& result, int lines_below) {
  for (AccumulationPoint& point : result.points) {
    if (lines_below >= point.lines) continue;
    ++point.crossings;
    ++point.wrong;
  }
}

void compare(const ExactEdge& exact, const Stepped& got, Accumulation& result) {
  const double slope = std::abs(to_double(exact.slope));
  // Where rounding moves the first or the last line, the lines that both have are compared.
  const int shift = got.first_line - exact.first_line;
  const auto lines = static_cast<int>(exact.place.size()), end = static_cast<int>(got.place.size());
  for (int line = 0; line < lines; ++line)
    if (line < shift || line >= shift + end) note_line(result, line);
  for (std::size_t k = 0; k < got.place.size(); ++k) {
    const auto at = static_cast<std::ptrdiff_t>(k) + shift;
    if (at < 0 || at >= lines) {
      note_line(result, static_cast<int>(k));
      continue;
    }
    const auto line = static_cast<std::size_t>(at);
    const double error = error_of(got, k, exact.place[line]);
    const double bound = slope_bound(result.format, slope, static_cast<int>(k), result.raster);
    for (AccumulationPoint& point : result.points) {
      if (static_cast<int>(k) >= point.lines) continue;
      ++point.crossings;
      point.wrong += got.element[k] != exact.element[line];
      point.held = point.held && error <= bound;
      if (error >= point.worst) point.bound = bound;
      point.worst = std::max(point.worst, error);
    }
  }
}

}  // namespace

double slope_bound(const Format& format, double slope, int line, int lines) {
  switch (format.arithmetic) {
    case Arithmetic::kFloat:
    case Arithmetic::kDouble: {
      const double u = format.arithmetic == Arithmetic::kFloat ? 0x1p-24 : 0x1p-53;
      return 8 * u * lines * (1 + slope);
    }
    case Arithmetic::kMachine: {
      const WordFormats& words = format.machine.formats;
      const double place = std::ldexp(1, -words.raster_fraction - 1);
      const double corner = std::ldexp(lines / 2.0, -words.quotient_fraction) + place;
      return corner * (1 + slope) * (1 + 2.0 * (line + 1) / lines) + place * (line + 3);
    }
    case Arithmetic::kCertified:
    case Arithmetic::kExact:
      break;
  }
  return 0;
}

std::vector<Accumulation> measure_accumulation(const AccumulationOptions& options) {
  if (options.lines < 16 || options.lines > 8190 || options.lines % 2 != 0)
    throw std::invalid_argument("lines: an even number in 16..8190");
  std::vector<Accumulation> results;
  for (const Format& format : options.formats) {
    Accumulation& result = results.emplace_back(Accumulation{format, options.lines, {}});
    for (const int lines : kPoints)
      if (lines <= options.lines) result.points.push_back({lines, 0, 0, true, 0, 0});
  }
  Random random(options.seed);
  for (int t = 0; t < options.trials; ++t) {
    const Trial trial = make_trial(options.lines, random);
    const ExactEdge exact = exact_edge(trial);
    for (Accumulation& result : results)
      if (const auto got = stepped(result.format, trial)) compare(exact, *got, result);
  }
  return results;
}

}  // namespace cigsim::stability
