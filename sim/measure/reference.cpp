// SPDX-License-Identifier: MIT
#include "sim/measure/reference.hpp"

namespace cigsim {

NumberType exact_number() { return NumberType::kCertified; }

std::vector<ReferencePicture> reference_pictures(const Database& database,
                                                 const std::vector<FrameView>& views,
                                                 const Raster& raster,
                                                 const std::function<void(double)>& progress,
                                                 NumberType number) {
  MachineOptions options;
  options.number = number;
  options.raster = raster;
  options.detail = 0;
  FunctionalMachine machine(database, options);
  std::vector<ReferencePicture> pictures;
  for (const FrameView& view : views) {
    pictures.push_back(reference_picture(machine.compute(view.viewpoint, view.position)));
    if (progress)
      progress(static_cast<double>(pictures.size()) / static_cast<double>(views.size()));
  }
  return pictures;
}

}  // namespace cigsim
