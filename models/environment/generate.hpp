// SPDX-License-Identifier: MIT
// Seeded scenes of any size, so that anybody can repeat a figure. The same kind, count and seed
// give the same scene on every machine (own generator, no std:: distributions).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "models/environment/environment.hpp"

namespace cigsim {

struct GenerateOptions {
  std::uint32_t objects = 200;
  std::uint64_t seed = 1;
};

struct GenerateKind {
  std::string_view name, description;
};

/// The kinds that `generate_environment` knows, in the order the command lists them.
const std::vector<GenerateKind>& generate_kinds();

/// Throws std::invalid_argument for an unknown kind.
Environment generate_environment(std::string_view kind, const GenerateOptions& options);

}  // namespace cigsim
