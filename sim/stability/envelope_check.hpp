// SPDX-License-Identifier: MIT
// A scene and its viewpoints held against the envelope of the number format that they are to be
// computed in, before a run.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/envelope.hpp"
#include "sim/view.hpp"

namespace cigsim::stability {

/// Limits were found on a sample of worlds: half of what they allow is taken (of lines all).
inline constexpr double kReserve = 2;

/// A quantity of which a frame asks more than the format's limit.
struct Excess {
  Quantity quantity = Quantity::kLines;
  double value = 0, limit = 0;  ///< limit: the reserve taken off
  std::size_t frame = 0;        ///< the worst one, from 0
  double times() const;         ///< by how much the value is beyond the limit, above 1
};

struct EnvelopeVerdict {
  bool known = false;  ///< an envelope is known of the format
  std::string format;  ///< whose envelope was taken
  std::size_t frames_checked = 0;
  std::optional<Measures> measures;  ///< the worst of all frames; none: there is no limit to check
  std::vector<Excess> excesses;      ///< the worst first; empty: inside
  std::optional<std::string> will_do;  ///< as the command's options name it; when outside

  bool inside() const { return excesses.empty(); }
};

/// `words_only`: stages that know time compute on machine words, so only wider words can do. On
/// machine words without a row of their own the widest row that is nowhere wider counts. Where
/// frames see many faces, evenly spaced ones are looked at: `frames_checked` says how many.
EnvelopeVerdict check_envelope(const Database& database, const MachineOptions& options,
                               const std::vector<FrameView>& views, bool words_only,
                               const std::vector<Envelope>& envelopes);

/// "demand 1.2e+07 in frame 3, not above 2.6e+06, 4.6 times beyond (what demand is)"; `where` is
/// the " in frame 3".
std::string excess_text(const Excess& excess, std::string_view where);

/// One line, without its end: which limit, by how much, what will do. Empty when inside.
std::string envelope_warning(const EnvelopeVerdict& verdict);

/// {"known", "format", "inside", "frames_checked", "measures", "excesses", "will_do"}
nlohmann::ordered_json envelope_verdict_json(const EnvelopeVerdict& verdict);

}  // namespace cigsim::stability
