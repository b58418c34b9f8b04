// SPDX-License-Identifier: MIT
#include "models/environment/document.hpp"

#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>

#include "models/environment/input_error.hpp"
#include "models/environment/json_reason.hpp"

namespace cigsim {
namespace {

/// Where the parser has read to: `line` is that of the last character it took.
struct Position {
  std::uint32_t line = 1;
  bool after_newline = false;
};

/// Hands the parser characters and keeps count of the lines.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    position_->line += position_->after_newline;
    position_->after_newline = *at_ == '\n';
    ++at_;
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }
  friend bool operator!=(const CountingIterator& a, const CountingIterator& b) { return !(a == b); }

 private:
  const char* at_;
  Position* position_;
};

}  // namespace

/// Receives the parser's events and lays them out as entries.
class DocumentBuilder {
 public:
  using Kind = Document::Kind;
  using json = nlohmann::json;

  DocumentBuilder(Document& document, const Position* position)
      : document_(document), position_(position) {}

  bool null() { return add(Kind::null); }
  bool boolean(bool value) { return add(Kind::boolean).whole(value); }
  bool number_integer(json::number_integer_t value) {
    if (value >= 0) return number_unsigned(static_cast<json::number_unsigned_t>(value));
    add(Kind::negative);
    document_.entries_.back().negative = value;
    return true;
  }
  bool number_unsigned(json::number_unsigned_t value) { return add(Kind::whole).whole(value); }
  bool number_float(json::number_float_t value, const json::string_t&) {
    add(Kind::real);
    document_.entries_.back().real = value;
    return true;
  }
  bool string(json::string_t& value) { return add_text(Kind::string, value); }
  bool binary(json::binary_t&) { fail("holds binary data; a scene has numbers and texts only"); }
  bool start_object(std::size_t) { return open(Kind::object); }
  bool start_array(std::size_t) { return open(Kind::array); }
  bool key(json::string_t& value) { return add_text(Kind::key, value); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool parse_error(std::size_t, const std::string&, const json::exception& exception) {
    fail((line() > 0 ? "not valid JSON: " : "not valid CBOR: ") + json_reason(exception.what()) +
         "; correct it or write the file again");
  }

 private:
  /// Deeper than any scene; keeps a hostile file from exhausting the stack.
  static constexpr std::size_t kDeepest = 64;

  struct Added {
    Document::Entry& entry;
    bool whole(std::uint64_t value) {
      entry.whole = value;
      return true;
    }
    operator bool() const { return true; }
  };

  std::uint32_t line() const { return position_ ? position_->line : 0; }

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(document_.name_, static_cast<int>(line()), what);
  }

  Added add(Kind kind) {
    Document::Entry entry;
    entry.kind = kind;
    entry.line = line();
    entry.whole = 0;
    document_.entries_.push_back(entry);
    return {document_.entries_.back()};
  }

  bool add_text(Kind kind, std::string& value) {
    add(kind).whole(document_.texts_.size());
    document_.texts_.push_back(std::move(value));
    return true;
  }

  bool open(Kind kind) {
    if (open_.size() == kDeepest)
      fail("is nested more than " + std::to_string(kDeepest) + " deep; nothing of ours is");
    open_.push_back(document_.entries_.size());
    return add(kind);
  }

  bool close() {
    document_.entries_[open_.back()].whole = document_.entries_.size();
    open_.pop_back();
    return add(Kind::end);
  }

  Document& document_;
  const Position* position_;
  std::vector<std::size_t> open_;
};

Document Document::from_json(std::string_view text, const std::string& name) {
  Document document;
  document.name_ = name;
  Position position;
  DocumentBuilder builder(document, &position);
  nlohmann::json::sax_parse(CountingIterator(text.data(), &position),
                            CountingIterator(text.data() + text.size(), &position), &builder);
  return document;
}

Document Document::from_cbor(std::string_view bytes, const std::string& name) {
  Document document;
  document.name_ = name;
  DocumentBuilder builder(document, nullptr);
  nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &builder,
                            nlohmann::json::input_format_t::cbor);
  return document;
}

}  // namespace cigsim
