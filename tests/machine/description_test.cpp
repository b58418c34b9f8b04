// SPDX-License-Identifier: MIT
#include "models/machine/description.hpp"

#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/machine/description_json.hpp"

namespace cigsim {
namespace {

std::string preset_file(const std::string& name) {
  return read_whole_file(CIGSIM_SOURCE_DIR "/models/machine/presets/" + name + ".json");
}

/// asupt1975's file with one piece of its text replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = preset_file("asupt1975");
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + from);
  return text.replace(at, from.size(), to);
}

std::string fault_of(const std::string& text) {
  try {
    parse_machine(text, "m.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_fault(const std::string& from, const std::string& to, const std::string& message) {
  EXPECT_EQ(fault_of(changed(from, to)).substr(0, message.size()), message) << from << " -> " << to;
}

TEST(MachineDescription, asupt1975_is_the_machine_of_the_design) {
  const MachineDescription m = machine_preset("asupt1975");
  EXPECT_EQ(m.name, "asupt1975");
  EXPECT_EQ(m.clock_ns, 125);
  EXPECT_EQ(m.frame_cycles, 266'667);
  EXPECT_EQ(m.line_cycles, 260);
  EXPECT_EQ(m.raster.width, 1024);
  EXPECT_EQ(m.raster.height, 1023);
  EXPECT_EQ(m.elements_per_cycle, 4u);
  EXPECT_EQ(m.edge_capacity, 2500u);
  EXPECT_EQ(m.crossing_capacity, 256u);
  EXPECT_EQ(m.vertical_blanking(), 266'667 - 260 * 1023);
  EXPECT_EQ(m.provenance.at("edge_capacity").standing, Standing::kRecalled);
  EXPECT_EQ(m.provenance.at("clock_ns").standing, Standing::kReconstruction);
  EXPECT_TRUE(machine_notices(m).empty());
}

TEST(MachineDescription, nasa1968_has_the_published_figures) {
  const MachineDescription m = machine_preset("nasa1968");
  EXPECT_EQ(m.edge_capacity, 240u);
  EXPECT_EQ(m.provenance.at("edge_capacity").standing, Standing::kPublished);
  EXPECT_NEAR(static_cast<double>(m.frame_cycles) * m.clock_ns * 1e-9, 1.0 / 30, 1e-6);
  EXPECT_TRUE(machine_notices(m).empty());
}

TEST(MachineDescription, unlimited_has_no_limits) {
  const MachineDescription m = machine_preset("unlimited");
  for (const auto capacity : {m.object_capacity, m.face_capacity, m.edge_capacity,
                              m.crossing_capacity, m.vertex_capacity, m.corner_capacity})
    EXPECT_EQ(capacity, 0u);
  EXPECT_EQ(m.frame_cycles, 0);
  EXPECT_EQ(m.line_cycles, 0);
  EXPECT_EQ(m.vertical_blanking(), 0);
}

TEST(MachineDescription, an_unknown_preset_is_refused_with_the_known_names) {
  try {
    machine_preset("cray");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "there is no machine \"cray\"; the presets are nasa1968, asupt1975, unlimited");
  }
}

TEST(MachineDescription, written_presets_are_their_files_byte_for_byte) {
  for (const std::string& name : machine_presets())
    EXPECT_EQ(machine_json(machine_preset(name)), preset_file(name)) << name;
}

TEST(MachineDescription, the_manual_lists_every_figure_of_every_preset) {
  const std::string document = read_whole_file(CIGSIM_SOURCE_DIR "/docs/machine/description.md");
  for (const std::string& name : machine_presets()) {
    const MachineDescription machine = machine_preset(name);
    std::ostringstream chapter;
    chapter << "### " << name << "\n\n"
            << machine.title << ".\n\n| figure | value | unit | standing | source |\n"
            << "| --- | ---: | --- | --- | --- |\n";
    for (const MachineFigure& figure : machine_figures(machine))
      chapter << "| `" << figure.name << "` | " << std::setprecision(15) << figure.value << " | "
              << figure.unit << " | " << name_of(figure.provenance.standing) << " | "
              << figure.provenance.source << " |\n";
    EXPECT_NE(document.find(chapter.str()), std::string::npos)
        << "docs/machine/description.md should have:\n"
        << chapter.str();
  }
}

TEST(MachineDescription, every_figure_reads_back_from_its_own_key) {
  MachineDescription m = machine_preset("unlimited");
  const std::size_t count = machine_figures(m).size();
  EXPECT_EQ(m.provenance.size(), count);
  m.links.crossings = 77;
  m.formats.quotient_fraction = 14;
  m.hither = 5;
  m.clock_ns = 62.5;
  m.frame_calculator.vertex = 9;
  const MachineDescription back = parse_machine(machine_json(m), "m.json");
  EXPECT_EQ(back.links.crossings, 77u);
  EXPECT_EQ(back.formats.quotient_fraction, 14);
  EXPECT_EQ(back.hither, 5);
  EXPECT_EQ(back.clock_ns, 62.5);
  EXPECT_EQ(back.frame_calculator.vertex, 9);
}

TEST(MachineDescription, faults_name_file_line_and_remedy) {
  expect_fault("\"cigsim-machine\"", "\"tea\"", "m.json:2: is no machine description");
  expect_fault("\"version\": 1", "\"version\": 2", "m.json:3: this version");
  expect_fault("\"clock_ns\"", "\"clock\"", "m.json:7: there is no figure \"clock\"");
  expect_fault("\"items\"", "\"item\"", "m.json:23: there is no figure \"links.item\"");
  expect_fault("\"value\": 125", "\"value\": \"fast\"", "m.json:7: clock_ns must be a number");
  expect_fault("\"value\": 125", "\"value\": 0",
               "m.json:7: clock_ns is 0; it must be a number from");
  expect_fault("\"value\": 2500", "\"value\": 2.5",
               "m.json:17: edge_capacity is 2.5; it must be a whole number from 0 to");
  expect_fault(
      "\"value\": 24", "\"value\": 25",
      "m.json:32: formats.quotient_fraction is 25; it must be an even number from 8 to 30");
  expect_fault("\"items\": {\"value\": 4", "\"items\": {\"value\": 0",
               "m.json:23: links.items is 0; it must be a whole number from 1 to");
  expect_fault("\"standing\": \"recalled\"", "\"standing\": \"certain\"",
               "m.json:11: there is no standing \"certain\"");
  expect_fault("\"face_capacity\"", "\"edge_capacity\"",
               "m.json:17: figure edge_capacity stands twice");
  expect_fault("\"standing\": \"derived\", ", "",
               "m.json:8: key \"standing\" is missing in frame_cycles");
  expect_fault("\"name\": \"asupt1975\"", "\"name\": \"\"",
               "m.json:4: the machine's name is empty");
  EXPECT_EQ(fault_of("[]").substr(0, 26), "m.json:1: the machine must");
}

TEST(MachineDescription, a_missing_figure_is_named) {
  std::string text = preset_file("asupt1975");
  const std::size_t at = text.find("  \"hither\"");
  text.erase(at, text.find('\n', at) + 1 - at);
  EXPECT_NE(fault_of(text).find("figure hither is missing; add it"), std::string::npos);
}

TEST(MachineDescription, contradictions_are_refused) {
  EXPECT_NE(fault_of(changed("\"value\": 266667", "\"value\": 265979"))
                .find("1023 lines of 260 cycles take 265980 cycles, but a frame has 265979"),
            std::string::npos);
  EXPECT_NE(fault_of(changed("\"elements_per_cycle\": {\"value\": 4",
                             "\"elements_per_cycle\": {\"value\": 3"))
                .find("shows 780 elements at 3 a cycle, but the raster is 1024 wide"),
            std::string::npos);
}

TEST(MachineDescription, more_crossings_than_a_line_has_cycles_are_a_notice) {
  MachineDescription m = machine_preset("asupt1975");
  m.crossing_capacity = 259;
  EXPECT_TRUE(machine_notices(m).empty());
  m.crossing_capacity = 260;
  EXPECT_EQ(machine_notices(m).size(), 1u);
}

TEST(MachineWithRaster, lines_keep_their_time_where_they_fit) {
  const MachineDescription m = machine_preset("asupt1975");
  EXPECT_EQ(with_raster(m, {1024, 1024}).line_cycles, 260);
  EXPECT_EQ(with_raster(m, {512, 512}).line_cycles, 260);
  EXPECT_EQ(with_raster(m, {512, 512}).frame_cycles, 266'667);
  EXPECT_EQ(with_raster(m, {512, 512}).raster.width, 512);
}

TEST(MachineWithRaster, more_lines_are_shorter) {
  const MachineDescription m = with_raster(machine_preset("asupt1975"), {512, 2048});
  EXPECT_EQ(m.line_cycles, 130);
  EXPECT_EQ(m.provenance.at("line_cycles").standing, Standing::kDerived);
}

TEST(MachineWithRaster, lines_too_short_for_their_elements_are_refused) {
  const MachineDescription m = machine_preset("asupt1975");
  EXPECT_THROW(with_raster(m, {1024, 2048}), std::invalid_argument);
  EXPECT_THROW(with_raster(m, {1041, 1023}), std::invalid_argument);
  EXPECT_NO_THROW(with_raster(m, {1040, 1023}));
  EXPECT_THROW(with_raster(m, {0, 10}), std::invalid_argument);
  EXPECT_THROW(with_raster(m, {5000, 10}), std::invalid_argument);
}

TEST(MachineWithRaster, a_machine_without_a_fixed_raster_takes_any) {
  const MachineDescription m = with_raster(machine_preset("unlimited"), {4096, 4096});
  EXPECT_EQ(m.line_cycles, 0);
  EXPECT_EQ(m.raster.height, 4096);
}

}  // namespace
}  // namespace cigsim
