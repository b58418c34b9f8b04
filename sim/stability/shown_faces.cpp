// SPDX-License-Identifier: MIT
#include "sim/stability/shown_faces.hpp"

#include "models/geometry_processor/face_walk.hpp"

namespace cigsim::stability {
namespace {

// Hears the steps of the geometry processor's walk over one item.
struct Listener {
  ItemWord item;
  bool taken = false;
  std::vector<bool> shown = {};

  void spend(geometry_processor::Step step, std::size_t = 1) {
    using geometry_processor::Step;
    if (step == Step::kBack || step == Step::kShown) shown.push_back(step == Step::kShown);
  }
  bool late() const { return false; }
  ItemWord take() {
    if (taken) return {SetId::kStatic, 0, true};
    taken = true;
    return item;
  }
  void edge(const EdgeWord&) {}
  void face(const FaceWord&) {}
};

}  // namespace

std::vector<bool> shown_faces(const MachineDescription& machine,
                              const geometry_processor::GeometryBank& bank, const ItemWord& item) {
  Listener listener{item};
  geometry_processor::Figures figures;
  geometry_processor::FaceWalk<Listener>(machine, listener).run(bank, figures);
  return listener.shown;
}

}  // namespace cigsim::stability
