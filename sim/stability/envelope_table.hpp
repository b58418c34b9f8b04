// SPDX-License-Identifier: MIT
// Envelopes as JSON, and the ones that the program carries (envelope.json: what `cigsim
// stability --envelope --json` prints under "envelope").
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "common/embedded_file.hpp"
#include "sim/stability/envelope.hpp"

namespace cigsim {

/// "envelope.json".
std::span<const EmbeddedFile> embedded_envelope();

}  // namespace cigsim

namespace cigsim::stability {

/// {"seed", "formats": [{"format", "words", "frames", "wrong", "limits": [{"quantity", "sense",
/// "searched", "limit", "reached", "predicted", "failure"}]}]}; what is not there is null.
nlohmann::ordered_json envelope_json(const std::vector<Envelope>& envelopes, std::uint64_t seed);

/// The reverse. Throws nlohmann::json::exception and std::invalid_argument for anything else.
std::vector<Envelope> envelopes_from_json(const nlohmann::ordered_json& table);

/// The seed of the embedded table.
inline constexpr std::uint64_t kStoredSeed = 1;
/// Those of the embedded table.
const std::vector<Envelope>& stored_envelopes();

}  // namespace cigsim::stability
