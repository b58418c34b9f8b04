// SPDX-License-Identifier: MIT
#include "models/boundary/rtl_model.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>

#include "models/boundary/rtl_coverage.hpp"

namespace cigsim {
namespace {

// Stays loaded: the code of a library is shared by its models, and outlives them all.
const rtl::Interface& load(std::filesystem::path library, std::size_t pins_size) {
  if (const char* const folder = std::getenv("CIGSIM_RTL_INSTEAD")) {
    const auto instead = std::filesystem::path(folder) / library.filename();
    if (std::filesystem::exists(instead)) library = instead;
  }
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    throw std::runtime_error(std::string("RTL library: ") + dlerror() +
                             "; remove it to have it built anew");
  const auto get =
      reinterpret_cast<const rtl::Interface* (*)()>(dlsym(handle, "cigsim_rtl_interface"));
  if (get == nullptr || get()->version != rtl::kInterfaceVersion || get()->pins_size != pins_size)
    throw std::runtime_error("RTL library " + library.string() +
                             " is of another version of cigsim; remove it to have it built anew");
  return *get();
}

}  // namespace

RtlModel::RtlModel(const std::filesystem::path& library, std::size_t pins_size, std::uint32_t seed)
    : table_(&load(library, pins_size)),
      model_(table_->create(seed)),
      pins_(table_->pins(model_)) {}

RtlModel::~RtlModel() {
  if (table_->write_coverage != nullptr)
    add_rtl_coverage([this](const std::filesystem::path& file) {
      table_->write_coverage(model_, file.c_str());
    });
  table_->destroy(model_);
}

void RtlModel::wave_open(WriteWave write) {
  write_ = std::move(write);
  table_->wave_open(
      model_,
      [](void* self, const char* text, std::size_t size) {
        static_cast<RtlModel*>(self)->write_({text, size});
      },
      this);
}

}  // namespace cigsim
