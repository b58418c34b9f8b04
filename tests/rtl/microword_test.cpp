// SPDX-License-Identifier: MIT
// The RTL's table of fields and codes against the format file of the microprogram: nothing differs,
// nothing is missing, nothing is left over.
#include <gtest/gtest.h>

#include <cctype>
#include <map>
#include <regex>

#include "firmware/programs.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using Constants = std::map<std::string, std::uint64_t>;

/// "LAST_RANK" as the RTL writes it.
std::string camel(const std::string& name) {
  std::string text;
  bool upper = true;
  for (const char c : name) {
    if (c != '_') text += static_cast<char>(upper ? std::toupper(c) : std::tolower(c));
    upper = c == '_';
  }
  return text;
}

Constants of_format(const firmware::Format& format) {
  Constants constants{{"MicrowordBits", format.width}};
  for (const firmware::Field& field : format.fields) {
    constants[camel(field.name) + "Lsb"] = field.place.first;
    constants[camel(field.name) + "Bits"] = field.place.bits;
    if (field.name == "op") continue;  // the sequencer's own
    for (const auto& [name, value] : field.values)
      constants[camel(field.name) + camel(name)] = value;
  }
  return constants;
}

Constants of_rtl(const std::string& file) {
  const std::string text = test::bytes_of(std::string(CIGSIM_SOURCE_DIR) + "/rtl/" + file);
  const std::regex line(R"(localparam (?:int|logic \[\d+:0\]) (\w+) = (?:\d+'d)?(\d+)[,;])");
  Constants constants;
  for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at)
    EXPECT_TRUE(constants.emplace((*at)[1], std::stoull((*at)[2])).second) << (*at)[1];
  return constants;
}

TEST(Microword, FieldsAndCodesAreThoseOfTheFormatFile) {
  const firmware::Format format = firmware::stage_format("priority_processor");
  EXPECT_EQ(of_rtl("priority_processor/microword.svh"), of_format(format));
  EXPECT_LE(format.width, 64u) << "a word goes through the pins in one piece";
}

TEST(Microword, TheControlStoreHoldsTheMicroprogram) {
  const auto words = firmware::stage_program("priority_processor").words.size();
  EXPECT_LE(words, rtl::priority_processor::kImageWords);
  const Constants constants = of_rtl("priority_processor/priority_processor.sv");
  EXPECT_EQ(constants.at("ImageWords"), rtl::priority_processor::kImageWords);
  EXPECT_EQ(constants.at("ImageBits"), firmware::stage_format("priority_processor").width);
}

}  // namespace
}  // namespace cigsim
