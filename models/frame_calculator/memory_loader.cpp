// SPDX-License-Identifier: MIT
#include "models/frame_calculator/memory_loader.hpp"

#include "models/frame_calculator/functional.hpp"
#include "models/machine/scale.hpp"
#include "models/priority_processor/named_faults.hpp"

namespace cigsim::frame_calculator {
namespace {

using geometry_processor::FaceMemory;
using priority_processor::PriorityBank;

constexpr std::uint64_t kSpheresOfAChoice = 2;

std::uint64_t spheres_tested(const PriorityHierarchy& hierarchy,
                             const std::vector<ActiveGroup>& groups) {
  std::uint64_t spheres = 0;
  for (const ActiveGroup& active : groups) {  // FC2
    const Group& group = hierarchy.groups[active.group];
    spheres += group.choice == kNone ? group.member_count : kSpheresOfAChoice;
  }
  return spheres;
}

}  // namespace

MemoryLoader::Image::Image(const Database& from, const MachineDescription& machine,
                           double eye_reach)
    : database(&from),
      scale(coordinate_scale(from, machine.formats, eye_reach)),
      priority(from.systems[0].hierarchy, from.systems[0].set.items.size(), scale, machine),
      faces(from.systems[0].set, scale, machine),
      ground(from.ground, scale, machine) {}

MemoryLoader::MemoryLoader(const MachineDescription& machine, double eye_reach, double detail)
    : machine_(machine),
      eye_reach_(eye_reach),
      detail_(detail),
      nothing_(PriorityHierarchy(), 0, 0, machine),
      priority_{PriorityBank(nothing_), PriorityBank(nothing_)} {}

Work MemoryLoader::load(const Database& database, const Viewpoint& viewpoint, double position,
                        std::uint32_t frame) {
  if (!image_ || image_->database != &database)
    image_ = std::make_shared<const Image>(database, machine_, eye_reach_);
  Side& side = sides_[frame % 2];
  Functional(database, detail_)
      .compute(viewpoint, machine_.raster, position, side.active, side.moving);
  auto moving = std::make_unique<FaceMemory>(side.moving, image_->scale, machine_);
  Work work;
  work.vertices = side.moving.vertices.size();
  work.spheres = spheres_tested(database.systems[0].hierarchy, side.active.groups);
  work.detail = side.active.detail;
  work.overflows = moving->overflows();
  const ViewWords view =
      view_words(side.active.view, image_->scale, machine_.formats, work.overflows);
  PriorityBank& priority = priority_[frame % 2];
  if (side.image != image_) priority = PriorityBank(image_->priority);
  priority.fill(side.active, view, static_cast<std::uint32_t>(database.ground.items.size()));
  geometry_[frame % 2] = {view, {&image_->faces, moving.get(), &image_->ground}};
  video_[frame % 2].background = database.background;
  side.image = image_;
  side.moving_faces = std::move(moving);
  return work;
}

std::vector<ListabilityFault> MemoryLoader::named_faults(
    std::uint32_t frame, const std::vector<std::uint32_t>& faults) const {
  const Side& side = sides_[frame % 2];
  if (faults.empty() || !side.image) return {};
  const PreparedSystem& system = side.image->database->systems[0];
  return priority_processor::named_faults(system.hierarchy, system.set, side.active,
                                          geometry_[frame % 2].view, side.image->scale,
                                          machine_.formats, faults);
}

}  // namespace cigsim::frame_calculator
