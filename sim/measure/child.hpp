// SPDX-License-Identifier: MIT
// Work in a process of its own: SystemC has one simulation a process, memory is measured from a
// known start, and what crashes or takes too long ends alone.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace cigsim {

/// A measurement came to nothing; the message names what was measured.
class MeasureError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What `work` returns, done in a fork of this process, which must not have made a SystemC module.
/// Its children end with this process, by whatever signal that ends. Throws MeasureError with
/// `name` when it throws (with its message), ends by a signal, cannot be started, or is not done
/// within `limit_s` seconds (more than 0).
nlohmann::ordered_json in_child(const std::string& name, double limit_s,
                                const std::function<nlohmann::ordered_json()>& work);

}  // namespace cigsim
