// SPDX-License-Identifier: MIT
// A fingerprint of all of a prepared database that its pictures depend on.
#pragma once

#include <cstdint>

#include "models/database/database.hpp"

namespace cigsim {

/// Of everything but names and the report. Equal databases have equal digests.
std::uint64_t database_digest(const Database& database);

}  // namespace cigsim
