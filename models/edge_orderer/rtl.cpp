// SPDX-License-Identifier: MIT
#include "models/edge_orderer/rtl.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "models/boundary/tracer.hpp"
#include "models/boundary/wave_part.hpp"
#include "rtl/edge_orderer/edge_orderer.pins.hpp"

namespace cigsim::edge_orderer {

using rtl::edge_orderer::Pins;

Rtl::Rtl(sc_core::sc_module_name name, const MachineDescription& machine, OverloadPolicy policy,
         const Clock& time, const std::filesystem::path& library, FiguresFunction figures,
         std::uint32_t seed)
    : sc_module(name),
      time_(time),
      report_(std::move(figures)),
      height_(static_cast<std::uint32_t>(machine.raster.height)),
      model_(library, sizeof(Pins), seed) {
  SC_HAS_PROCESS(Rtl);
  SC_METHOD(edge);
  dont_initialize();
  sensitive << clock.pos();
  edges.ready.initialize(true);
  start.ready.initialize(true);

  Pins& pins = model_.pins<Pins>();
  pins.cfg_width_i = static_cast<std::uint16_t>(machine.raster.width);
  pins.cfg_height_i = static_cast<std::uint16_t>(machine.raster.height);
  pins.cfg_crossing_capacity_i = machine.crossing_capacity;
  pins.cfg_policy_i = static_cast<std::uint8_t>(policy);
  pins.rst_i = true;
  model_.edge();
  model_.edge();
  pins.rst_i = false;
}

void Rtl::trace(sc_core::sc_trace_file* file) {
  const Tracer show(file, *this);
  show.pins(edges, "edges");
  show.pins(loaded, "loaded");
  show.pins(start, "start");
  show.pins(crossings, "crossings");
  trace_rtl(file, *this, model_, [this] { drive(); });
}

void Rtl::edge() {
  const Pins& pins = model_.pins<Pins>();
  count(time_.cycle());
  drive();
  model_.edge();
  if (pins.mon_too_small_o)
    throw std::runtime_error("edge_orderer: picture " + std::to_string(figures_.frame) +
                             " has more edges, lines or crossings of a line than this RTL size"
                             " holds");
  show();
}

void Rtl::drive() {
  Pins& pins = model_.pins<Pins>();
  const EdgeWord& edge = edges.word.read();
  pins.edges_valid_i = edges.valid.read();
  pins.edges_face_i = edge.face;
  pins.edges_first_line_i = edge.first_line;
  pins.edges_end_line_i = edge.end_line;
  pins.edges_left_i = edge.left;
  pins.edges_end_i = edge.end;
  pins.edges_x_i = static_cast<std::uint32_t>(edge.x);
  pins.edges_slope_i = static_cast<std::uint32_t>(edge.slope);
  pins.loaded_ready_i = loaded.ready.read();
  pins.start_valid_i = start.valid.read();
  pins.start_frame_i = start.word.read().frame;
  pins.crossings_ready_i = crossings.ready.read();
}

void Rtl::show() {
  const Pins& pins = model_.pins<Pins>();
  edges.ready.write(pins.edges_ready_o);
  loaded.valid.write(pins.loaded_valid_o);
  if (pins.loaded_valid_o) loaded.word.write({pins.loaded_frame_o});
  start.ready.write(pins.start_ready_o);
  crossings.valid.write(pins.crossings_valid_o);
  if (pins.crossings_valid_o)
    crossings.word.write({pins.crossings_face_o, pins.crossings_element_o, pins.crossings_left_o,
                          pins.crossings_end_o, pins.crossings_cut_o});
}

// What happens in cycle `now`; the RTL's pins still are those of that cycle.
void Rtl::count(Cycle now) {
  if (edges.valid.read() && edges.ready.read()) {
    std::uint64_t& loaded_edges = loaded_edges_[load_frame_ % 2];
    if (edges.word.read().end)
      ++load_frame_;
    else
      ++loaded_edges;
  }
  if (start.valid.read() && start.ready.read()) {
    figures_ = {};
    figures_.frame = start.word.read().frame;
    figures_.activity.start = now;
    figures_.edges = std::exchange(loaded_edges_[figures_.frame % 2], 0);
    fill_line_ = drain_line_ = 0;
  }
  count_filling();
  count_draining(now);
}

void Rtl::count_filling() {
  const Pins& pins = model_.pins<Pins>();
  figures_.passes += pins.mon_pass_o;
  figures_.overfull_lines += pins.mon_overfull_o;
  figures_.dropped += pins.mon_dropped_o;
  figures_.overflows += pins.mon_overflow_o;
  if (!pins.mon_line_o) return;
  figures_.crossings += pins.mon_crossings_o;
  if (pins.mon_crossings_o > figures_.worst_line_crossings) {
    figures_.worst_line_crossings = pins.mon_crossings_o;
    figures_.worst_line = fill_line_;
  }
  ++fill_line_;
}

void Rtl::count_draining(Cycle now) {
  if (!crossings.valid.read()) return;
  if (!crossings.ready.read()) {
    ++figures_.activity.stalled;
    return;
  }
  if (!crossings.word.read().end || ++drain_line_ < height_) return;
  figures_.activity.finish = now;
  if (report_) report_(figures_);
}

}  // namespace cigsim::edge_orderer
