// SPDX-License-Identifier: MIT
#include "firmware/assembler/listing.hpp"

#include <fmt/format.h>

#include <iterator>

namespace cigsim::firmware {
namespace {

std::string hex(const Microword& word, unsigned width) {
  const std::string digits = fmt::format("{:016x}{:016x}", word.high, word.low);
  return digits.substr(digits.size() - (width + 3) / 4);
}

}  // namespace

std::string listing(const Program& program) {
  const Format& format = program.format;
  std::string text = fmt::format("; {}: {} words of {} bits, format {}\n", program.name,
                                 program.words.size(), format.width, format.name);
  const auto out = std::back_inserter(text);
  for (const Field& field : format.fields)
    fmt::format_to(out, "; bits {:>3}..{:<3} {}\n", field.place.first,
                   field.place.first + field.place.bits - 1, field.name);
  std::multimap<std::uint32_t, std::string> labels;
  for (const auto& [label, address] : program.labels) labels.emplace(address, label);
  for (std::uint32_t address = 0; address < program.words.size(); ++address) {
    const auto [first, last] = labels.equal_range(address);
    for (auto label = first; label != last; ++label) fmt::format_to(out, "{}:\n", label->second);
    const Program::Source& source = program.sources[address];
    fmt::format_to(out, "{:03x}  {}  {:>4}  {}\n", address,
                   hex(program.words[address], format.width), source.line, source.text);
  }
  for (const auto& [name, value] : program.constants)
    fmt::format_to(out, "; constant {} = {}\n", name, value);
  for (const auto& [name, cycles] : program.costs)
    fmt::format_to(out, "; cost {} = {} cycles\n", name, cycles);
  return text;
}

std::string address_names(const Program& program) {
  std::string text = fmt::format("# Microaddresses of {}\n", program.name), label;
  std::map<std::uint32_t, std::string> labels;  // the first of those at an address
  for (const auto& [name, address] : program.labels) labels.emplace(address, name);
  std::uint32_t from = 0;
  for (std::uint32_t address = 0; address < program.words.size(); ++address) {
    if (const auto found = labels.find(address); found != labels.end()) {
      label = found->second;
      from = address;
    }
    text += fmt::format("{} {}", address, label.empty() ? "start" : label);
    text += address == from ? "\n" : fmt::format("+{}\n", address - from);
  }
  return text;
}

std::string hex_image(const Program& program) {
  std::string text;
  for (const Microword& word : program.words) text += hex(word, program.format.width) + "\n";
  return text;
}

}  // namespace cigsim::firmware
