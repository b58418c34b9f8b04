// SPDX-License-Identifier: MIT
// A JSON or CBOR document with the line of every value, so that faults of the contents can be
// reported where they stand. The values lie in one flat list in the order of the text (16 bytes
// each), because scenes hold millions of them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cigsim {

class Document {
 public:
  /// What a value is. `end` closes an object or array; `key` precedes a member's value.
  enum class Kind : std::uint8_t {
    object,
    array,
    end,
    key,
    string,
    whole,
    negative,
    real,
    boolean,
    null
  };

  struct Entry {
    Kind kind;
    std::uint32_t line;  ///< from 1; 0 in CBOR, which has no lines
    union {
      std::uint64_t whole;  ///< whole: the number; string, key: index of the text; object, array:
                            ///< index of its end
      std::int64_t negative;
      double real;
    };
  };

  /// Throw InputError, with the line for JSON, when the bytes are not a document at all.
  static Document from_json(std::string_view text, const std::string& name);
  static Document from_cbor(std::string_view bytes, const std::string& name);

  const std::string& name() const { return name_; }
  const Entry& entry(std::size_t at) const { return entries_[at]; }
  const std::string& text(std::size_t at) const { return texts_[entries_[at].whole]; }
  /// The place after the value at `at`.
  std::size_t after(std::size_t at) const {
    const Entry& e = entries_[at];
    return (e.kind == Kind::object || e.kind == Kind::array) ? e.whole + 1 : at + 1;
  }

 private:
  friend class DocumentBuilder;
  std::string name_;
  std::vector<Entry> entries_;
  std::vector<std::string> texts_;
};

}  // namespace cigsim
