// SPDX-License-Identifier: MIT
#include "models/environment/emitter.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace cigsim {
namespace {

/// The text as a JSON string with its quotes.
std::string quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

class JsonEmitter : public Emitter {
 public:
  explicit JsonEmitter(std::ostream& out) : out_(out) {}

  void begin_object(std::uint64_t, Layout layout) override { open('{', '}', layout); }
  void begin_array(std::uint64_t, Layout layout) override { open('[', ']', layout); }
  void end() override {
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == Layout::lines && !level.first) new_line();
    out_ << level.closing;
    if (levels_.empty()) out_ << '\n';
  }
  void key(std::string_view name) override {
    separate();
    out_ << '"' << name << "\": ";
    after_key_ = true;
  }
  void text(std::string_view value) override {
    separate();
    out_ << quoted(value);
  }
  void whole(std::uint64_t value) override {
    separate();
    char digits[24];
    out_.write(digits, std::to_chars(digits, digits + sizeof digits, value).ptr - digits);
  }
  void number(double value) override {
    separate();
    if (value == 0 && std::signbit(value)) {
      out_ << "-0.0";
      return;
    }
    char digits[40];
    out_.write(digits, std::to_chars(digits, digits + sizeof digits, value).ptr - digits);
  }

 private:
  struct Level {
    char closing;
    Layout layout;
    bool first = true;
  };

  void open(char opening, char closing, Layout layout) {
    separate();
    out_ << opening;
    if (!levels_.empty() && levels_.back().layout == Layout::one_line) layout = Layout::one_line;
    levels_.push_back({closing, layout});
  }

  void separate() {
    if (after_key_ || levels_.empty()) {
      after_key_ = false;
      return;
    }
    Level& level = levels_.back();
    if (!level.first) out_ << (level.layout == Layout::lines ? "," : ", ");
    if (level.layout == Layout::lines) new_line();
    level.first = false;
  }

  void new_line() {
    out_ << '\n';
    for (std::size_t i = 0; i < levels_.size(); ++i) out_ << ' ';
  }

  std::ostream& out_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

class CborEmitter : public Emitter {
 public:
  explicit CborEmitter(std::ostream& out) : out_(out) {}

  void begin_object(std::uint64_t count, Layout) override { head(5, count); }
  void begin_array(std::uint64_t count, Layout) override { head(4, count); }
  void end() override {}
  void key(std::string_view name) override { text_bytes(std::string(name)); }
  void text(std::string_view value) override {
    text_bytes(nlohmann::json::parse(quoted(value)).get<std::string>());
  }
  void whole(std::uint64_t value) override { head(0, value); }
  void number(double value) override {
    out_.put(static_cast<char>(0xfb));
    big_endian(std::bit_cast<std::uint64_t>(value), 8);
  }

 private:
  void text_bytes(const std::string& bytes) {
    head(3, bytes.size());
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }

  /// Major type in the upper three bits, then the shortest spelling of the argument.
  void head(unsigned major, std::uint64_t argument) {
    const unsigned type = major << 5;
    if (argument < 24) {
      out_.put(static_cast<char>(type | argument));
      return;
    }
    const unsigned size = argument <= 0xff ? 0 : argument <= 0xffff ? 1 : argument >> 32 ? 3 : 2;
    out_.put(static_cast<char>(type | (24 + size)));
    big_endian(argument, 1 << size);
  }

  void big_endian(std::uint64_t value, int bytes) {
    while (bytes-- > 0) out_.put(static_cast<char>(value >> (8 * bytes) & 0xff));
  }

  std::ostream& out_;
};

}  // namespace

std::unique_ptr<Emitter> make_json_emitter(std::ostream& out) {
  return std::make_unique<JsonEmitter>(out);
}

std::unique_ptr<Emitter> make_cbor_emitter(std::ostream& out) {
  return std::make_unique<CborEmitter>(out);
}

}  // namespace cigsim
