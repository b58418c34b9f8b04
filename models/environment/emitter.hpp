// SPDX-License-Identifier: MIT
// One walk over a scene writes either spelling of it: JSON text or CBOR (RFC 8949).
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string_view>

namespace cigsim {

/// How JSON text lays out the members of an object or array. CBOR has no layout.
enum class Layout { lines, one_line };

class Emitter {
 public:
  virtual ~Emitter() = default;
  /// `count` is the number of members that follow before end().
  virtual void begin_object(std::uint64_t count, Layout layout) = 0;
  virtual void begin_array(std::uint64_t count, Layout layout) = 0;
  virtual void end() = 0;
  virtual void key(std::string_view name) = 0;
  virtual void text(std::string_view value) = 0;
  virtual void whole(std::uint64_t value) = 0;
  virtual void number(double value) = 0;
};

/// Doubles are written with the fewest digits that read back to the same double. Bytes of a text
/// that are not UTF-8 become U+FFFD.
std::unique_ptr<Emitter> make_json_emitter(std::ostream& out);
std::unique_ptr<Emitter> make_cbor_emitter(std::ostream& out);

}  // namespace cigsim
