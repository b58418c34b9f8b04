// SPDX-License-Identifier: MIT
#include "sim/wave/vcd_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "models/environment/input_error.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kBlock = 1 << 16;
constexpr std::size_t kLongestToken = 1 << 20;
constexpr std::uint32_t kWidest = 1 << 16;  // bits
constexpr double kLatest = 9e18;            // units
constexpr WaveTime kForever = std::numeric_limits<WaveTime>::max();

bool blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The digit of a wave for a value of a VCD file, 0 for none.
char digit_of(char c) {
  switch (c) {
    case '0':
    case 'l':
    case 'L':
      return '0';
    case '1':
    case 'h':
    case 'H':
      return '1';
    case 'z':
    case 'Z':
      return 'z';
    case 'x':
    case 'X':
    case 'u':
    case 'U':
    case 'w':
    case 'W':
    case '-':
      return 'x';
    default:
      return 0;
  }
}

bool to_count(std::string_view text, std::uint64_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

bool is_real(std::string_view type) {
  return type == "real" || type == "realtime" || type == "real_parameter" || type == "shortreal";
}

}  // namespace

VcdReader::VcdReader(ByteSource source, std::string name)
    : source_(std::move(source)), name_(std::move(name)), block_(kBlock) {
  std::string token;
  while (true) {
    if (!next(token)) fail("ends within its declarations; it is cut short");
    if (token == "$enddefinitions") {
      skip_to_end("$enddefinitions");
      break;
    }
    if (token == "$timescale")
      read_timescale();
    else if (token == "$scope")
      read_scope();
    else if (token == "$var")
      read_variable();
    else if (token == "$upscope") {
      skip_to_end("$upscope");
      if (scopes_.empty()) fail("$upscope: no scope is open");
      scopes_.pop_back();
    } else if (token.front() == '$') {
      skip_to_end(token.c_str());  // $date, $version, $comment, and what programs add
    } else {
      fail(fmt::format("'{}' stands among the declarations; is this a VCD file?",
                       token.substr(0, 40)));
    }
  }
  if (unit_ns_ == 0) fail("has no $timescale");
}

void VcdReader::fail(const std::string& what) const {
  constexpr std::uint64_t kLastLine = std::numeric_limits<int>::max();
  throw InputError(name_, static_cast<int>(std::min(line_, kLastLine)), what);
}

bool VcdReader::fill() {
  at_ = 0;
  end_ = source_(block_.data(), block_.size());
  return end_ != 0;
}

// The next word between blanks. Its line is that of messages.
bool VcdReader::next(std::string& token) {
  token.clear();
  while (true) {
    if (at_ == end_ && !fill()) return false;
    if (!blank(block_[at_])) break;
    if (block_[at_++] == '\n') ++line_;
  }
  while (true) {
    const std::size_t begin = at_;
    while (at_ < end_ && !blank(block_[at_])) ++at_;
    token.append(block_.data() + begin, at_ - begin);
    if (token.size() > kLongestToken) fail("has a word of more than a million characters");
    if (at_ < end_ || !fill()) return true;
  }
}

void VcdReader::need(std::string& token, const char* what) {
  if (!next(token)) fail(fmt::format("ends within {}; it is cut short", what));
}

void VcdReader::skip_to_end(const char* command) {
  const std::string what = command;
  for (std::string token; token != "$end";) need(token, what.c_str());
}

std::string VcdReader::text_to_end(const char* command) {
  std::string text, token;
  while (true) {
    need(token, command);
    if (token == "$end") return text;
    text += token;
  }
}

void VcdReader::read_timescale() {
  static constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{
      {{"s", 1e9}, {"ms", 1e6}, {"us", 1e3}, {"ns", 1}, {"ps", 1e-3}, {"fs", 1e-6}}};
  const std::string text = text_to_end("$timescale");
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  std::uint64_t count = 0;
  if (to_count(std::string_view(text).substr(0, digits), count) &&
      (count == 1 || count == 10 || count == 100))
    for (const auto& [unit, ns] : kUnits)
      if (std::string_view(text).substr(digits) == unit) unit_ns_ = static_cast<double>(count) * ns;
  if (unit_ns_ == 0)
    fail(fmt::format("$timescale: '{}' must be 1, 10 or 100 of s, ms, us, ns, ps or fs", text));
}

void VcdReader::read_scope() {
  std::string type, scope;
  need(type, "$scope");
  need(scope, "$scope");
  if (type == "$end" || scope == "$end") fail("$scope: must have a type and a name");
  scopes_.push_back(scope);
  std::string end;
  need(end, "$scope");
  if (end != "$end") fail(fmt::format("$scope: '{}' stands where $end must", end));
}

void VcdReader::read_variable() {
  std::string type, size, code, name, range;
  for (std::string* word : {&type, &size, &code, &name}) {
    need(*word, "$var");
    if (*word == "$end") fail("$var: must have a type, a width, a code and a name");
  }
  range = text_to_end("$var");
  // Some programs leave out the blank before the range.
  if (const std::size_t bracket = name.find('[');
      range.empty() && bracket != std::string::npos && bracket != 0 && name.back() == ']') {
    range = name.substr(bracket);
    name.resize(bracket);
  }
  std::uint64_t width = 0;
  if (!to_count(size, width) || width > kWidest)
    fail(fmt::format("$var: '{}' is no width from 0 to {}", size, kWidest));
  WaveSignal signal;
  for (const std::string& scope : scopes_) signal.name += scope + ".";
  signal.name += name;
  signal.range = range;
  signal.real = is_real(type) || type == "string";
  signal.width = static_cast<std::uint32_t>(std::max<std::uint64_t>(width, 1));
  Code& entry = codes_[code];
  if (!entry.signals.empty() && (entry.width != signal.width || entry.real != signal.real))
    fail(fmt::format("$var: {} shares the code '{}' with {}, which has another width", signal.name,
                     code, signals_[entry.signals.front()].name));
  entry.width = signal.width;
  entry.real = signal.real;
  entry.signals.push_back(signals_.size());
  signals_.push_back(std::move(signal));
}

VcdReader::Code& VcdReader::code_of(std::string_view code) {
  const auto found = codes_.find(code);
  if (found == codes_.end())
    fail(fmt::format("a value for the code '{}', which no declaration has", code));
  return found->second;
}

void VcdReader::change(Code& code, const std::string& value, Wave& wave) {
  for (const std::size_t index : code.traces) {
    std::vector<WaveChange>& changes = wave.traces[index].changes;
    const WaveTime time = std::max(now_, from_);
    if (!changes.empty() && changes.back().time == time) changes.pop_back();
    if (changes.empty() || changes.back().value != value) changes.push_back({time, value});
  }
}

void VcdReader::take_scalar(const std::string& token, Wave& wave) {
  if (token.size() < 2)
    fail(fmt::format("'{}' has no code of a signal; the file is cut short", token));
  Code& code = code_of(std::string_view(token).substr(1));
  if (code.width != 1 || code.real)
    fail(fmt::format("'{}' is a value of one bit, but {} has {}", token,
                     signals_[code.signals.front()].name, code.width));
  if (code.traces.empty()) return;
  value_.assign(1, digit_of(token.front()));
  change(code, value_, wave);
}

void VcdReader::take_vector(const std::string& token, Wave& wave) {
  need(code_text_, "a value");
  Code& code = code_of(code_text_);
  const bool bits = token.front() == 'b' || token.front() == 'B';
  if (bits == code.real)
    fail(fmt::format("'{}' is no value for {}", token.substr(0, 40),
                     signals_[code.signals.front()].name));
  if (!bits) {
    value_ = token.substr(1);
  } else {
    const std::size_t digits = token.size() - 1;
    if (digits == 0) fail("a value without digits");
    if (digits > code.width)
      fail(fmt::format("a value of {} bits for {}, which has {}", digits,
                       signals_[code.signals.front()].name, code.width));
    const char highest = digit_of(token[1]);
    value_.assign(code.width - digits, highest == '1' ? '0' : highest);
    for (std::size_t i = 1; i < token.size(); ++i) {
      const char digit = digit_of(token[i]);
      if (digit == 0) fail(fmt::format("'{}' is no binary value", token.substr(0, 40)));
      value_ += digit;
    }
  }
  change(code, value_, wave);
}

// False when the window has ended.
bool VcdReader::take_time(const std::string& token, Wave& wave) {
  std::uint64_t time = 0;
  if (!to_count(std::string_view(token).substr(1), time))
    fail(fmt::format("'{}' is no time; times are whole numbers after #", token.substr(0, 40)));
  if (timed_ && time < now_) fail(fmt::format("time goes back from {} to {}", now_, time));
  if (!timed_) {
    wave.first = std::max(from_, time);
    for (WaveTrace& trace : wave.traces)  // what was said ahead of the first time
      for (WaveChange& change : trace.changes) change.time = wave.first;
  }
  timed_ = true;
  now_ = time;
  return time <= to_;
}

// A whole number of units where it is one but for rounding.
WaveTime VcdReader::in_units(double ns, double (*round)(double)) const {
  const double units = std::clamp(ns / unit_ns_, 0.0, kLatest), nearest = std::round(units);
  return static_cast<WaveTime>(std::abs(units - nearest) < 1e-6 ? nearest : round(units));
}

Wave VcdReader::read(const std::vector<std::size_t>& wanted, const WaveWindow& window) {
  Wave wave;
  wave.unit_ns = unit_ns_;
  from_ = window.from ? in_units(*window.from, std::floor) : 0;
  to_ = window.to ? in_units(*window.to, std::ceil) : kForever;
  std::vector<std::vector<std::size_t>> traces(signals_.size());
  for (const std::size_t index : wanted) {
    traces[index].push_back(wave.traces.size());
    wave.traces.push_back({signals_[index], {}});
  }
  for (auto& [text, code] : codes_)
    for (const std::size_t signal : code.signals)
      code.traces.insert(code.traces.end(), traces[signal].begin(), traces[signal].end());

  std::string token;
  bool inside = true;
  while (inside && next(token)) {
    switch (token.front()) {
      case '#':
        inside = take_time(token, wave);
        break;
      case 'b':
      case 'B':
      case 'r':
      case 'R':
      case 's':
      case 'S':
        take_vector(token, wave);
        break;
      case '$':
        if (token == "$comment") skip_to_end("$comment");
        break;  // $dumpvars and the like enclose values, until $end
      default:
        if (digit_of(token.front()) == 0)
          fail(fmt::format("'{}' is neither a time nor a value", token.substr(0, 40)));
        take_scalar(token, wave);
    }
  }
  if (!timed_) fail("has no times after its declarations; it is cut short");
  wave.last = std::min(now_, to_);
  if (wave.first > to_)
    throw InputError(
        name_, 0,
        fmt::format("begins at {} ns, after the window", static_cast<double>(now_) * unit_ns_));
  if (wave.last < from_)
    throw InputError(
        name_, 0,
        fmt::format("ends at {} ns, before the window", static_cast<double>(now_) * unit_ns_));
  return wave;
}

}  // namespace cigsim
