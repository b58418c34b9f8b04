// SPDX-License-Identifier: MIT
#include "sim/wave/vcd_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace cigsim {
namespace {

constexpr int kReal = 64;

constexpr char kPart = '~';  // in the codes of parts only

// Short names of characters from ! to }, the first ones the shortest.
std::string code_of(std::size_t index) {
  constexpr std::size_t kCharacters = kPart - '!';
  std::string code;
  for (++index; index > 0; index /= kCharacters) {
    --index;
    code += static_cast<char>('!' + index % kCharacters);
  }
  return code;
}

std::vector<std::string_view> scopes_of(std::string_view name) {
  std::vector<std::string_view> scopes;
  for (std::size_t dot; (dot = name.find('.')) != std::string_view::npos;) {
    scopes.push_back(name.substr(0, dot));
    name.remove_prefix(dot + 1);
  }
  return scopes;
}

std::string unit_text(double ns) { return ns >= 1 ? "1 ns" : fmt::format("{:.0f} ps", ns * 1000); }

}  // namespace

double vcd_unit_ns(double cycle_ns) {
  for (const double unit : {1.0, 0.1, 0.01}) {
    const double half_cycle = cycle_ns / 2 / unit;
    if (std::abs(half_cycle - std::round(half_cycle)) < 1e-9 * half_cycle) return unit;
  }
  return 0.001;
}

VcdWriter::VcdWriter(std::ostream& out, double cycle_ns, const std::string& clock)
    : out_(out),
      unit_ns_(vcd_unit_ns(cycle_ns)),
      half_cycle_(cycle_ns / 2 / unit_ns_),
      clock_(clock),
      clock_code_(code_of(0)) {}

template <class T>
std::uint64_t VcdWriter::read(const void* object) {
  const T value = *static_cast<const T*>(object);
  if constexpr (std::is_floating_point_v<T>) {
    const double real = value;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &real, sizeof bits);
    return bits;
  } else {
    return static_cast<std::uint64_t>(value);
  }
}

template <class T>
void VcdWriter::add(const T& object, const std::string& name, int width) {
  values_.push_back({name, "", &object, read<T>, width, std::is_floating_point_v<T>});
}

void VcdWriter::refuse(const std::string& name) {
  throw std::logic_error(name + ": waves show bits and numbers only");
}

void VcdWriter::add_part(const std::string& scope, std::unique_ptr<WavePart> part) {
  parts_.emplace_back(scope, kPart + code_of(parts_.size()) + kPart, std::move(part));
}

void VcdWriter::declare() {
  std::vector<RtlPart::Variable> variables;
  const auto range = [](int width) {
    return width > 1 ? fmt::format("[{}:0]", width - 1) : std::string();
  };
  variables.push_back({clock_, "wire", "1", "", clock_code_});
  for (std::size_t i = 0; i < values_.size(); ++i) {
    Value& value = values_[i];
    value.code = code_of(i + 1);
    variables.push_back({value.name, value.real ? "real" : "wire", std::to_string(value.width),
                         value.real ? "" : range(value.width), value.code});
  }
  for (RtlPart& part : parts_)
    for (RtlPart::Variable& variable : part.declare(clock_code_))
      variables.push_back(std::move(variable));
  declare(variables);
}

void VcdWriter::declare(const std::vector<RtlPart::Variable>& variables) {
  // Scope by scope, so that none is opened twice; the clock first.
  std::vector<std::pair<std::vector<std::string_view>, const RtlPart::Variable*>> sorted;
  for (const RtlPart::Variable& variable : variables)
    sorted.emplace_back(scopes_of(variable.name), &variable);
  std::stable_sort(sorted.begin() + 1, sorted.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  out_ << "$version cigsim $end\n$comment one sample a cycle $end\n$timescale "
       << unit_text(unit_ns_) << " $end\n";
  std::vector<std::string_view> open;
  for (const auto& [scopes, variable] : sorted) {
    const auto same = static_cast<std::size_t>(
        std::mismatch(open.begin(), open.end(), scopes.begin(), scopes.end()).first - open.begin());
    for (; open.size() > same; open.pop_back()) out_ << "$upscope $end\n";
    for (; open.size() < scopes.size(); open.push_back(scopes[open.size()]))
      out_ << "$scope module " << scopes[open.size()] << " $end\n";
    out_ << "$var " << variable->type << ' ' << variable->width << ' ' << variable->code << ' '
         << std::string_view(variable->name).substr(variable->name.rfind('.') + 1);
    if (!variable->range.empty()) out_ << ' ' << variable->range;
    out_ << " $end\n";
  }
  for (; !open.empty(); open.pop_back()) out_ << "$upscope $end\n";
  out_ << "$enddefinitions $end\n";
}

void VcdWriter::begin_time(double half_cycles) {
  out_ << '#' << static_cast<std::uint64_t>(std::llround(half_cycles * half_cycle_)) << '\n';
}

void VcdWriter::put(const Value& value, std::uint64_t bits) {
  if (value.real) {
    double real = 0;
    std::memcpy(&real, &bits, sizeof real);
    out_ << fmt::format("r{} {}\n", real, value.code);
    return;
  }
  if (value.width < 64) bits &= (std::uint64_t{1} << value.width) - 1;
  if (value.width == 1)
    out_ << (bits != 0 ? '1' : '0') << value.code << '\n';
  else
    out_ << fmt::format("b{:b} {}\n", bits, value.code);
}

void VcdWriter::sample(Cycle n) {
  const double begin = 2 * static_cast<double>(n);
  begin_time(begin);
  if (first_) out_ << "$dumpvars\n";
  put_clock(true);
  for (Value& value : values_) {
    const std::uint64_t bits = value.read(value.object);
    if (bits == value.last && !first_) continue;
    put(value, bits);
    value.last = bits;
  }
  for (RtlPart& part : parts_) part.sample(n, out_);
  if (first_) out_ << "$end\n";
  first_ = false;
  begin_time(begin + 1);
  put_clock(false);
}

void VcdWriter::end(Cycle n) {
  begin_time(2 * static_cast<double>(n));
  for (RtlPart& part : parts_) part.close();
}

void VcdWriter::trace(const bool& object, const std::string& name) { add(object, name, 1); }
void VcdWriter::trace(const unsigned char& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const unsigned short& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const unsigned int& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const unsigned long& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const char& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const short& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const int& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const long& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const sc_dt::int64& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const sc_dt::uint64& object, const std::string& name, int width) {
  add(object, name, width);
}
void VcdWriter::trace(const float& object, const std::string& name) { add(object, name, kReal); }
void VcdWriter::trace(const double& object, const std::string& name) { add(object, name, kReal); }

void VcdWriter::trace(const sc_core::sc_event&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_core::sc_time&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_bit&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_logic&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_int_base&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_uint_base&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_signed&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_unsigned&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_fxval&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_fxval_fast&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_fxnum&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_fxnum_fast&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_bv_base&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const sc_dt::sc_lv_base&, const std::string& name) { refuse(name); }
void VcdWriter::trace(const unsigned int&, const std::string& name, const char**) { refuse(name); }

}  // namespace cigsim
