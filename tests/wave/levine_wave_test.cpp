// SPDX-License-Identifier: MIT
// The SO engine at work on Levine's example of five objects and four planes (1975, ch. VI.E): the
// wave so-levine.vcd, in the folder in which the test runs, which docs/waves.md draws.
#include <gtest/gtest.h>

#include <bit>
#include <fstream>

#include "rtl/priority_processor/so_engine.pins.hpp"
#include "sim/wave/signal_names.hpp"
#include "sim/wave/vcd_writer.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

using rtl::so_engine::Pins;

/// Bit n of a row for the n-th sign.
std::uint32_t bits(const std::string& row, const std::string& which) {
  std::uint32_t result = 0;
  for (std::size_t n = 0; n < row.size(); ++n)
    if (which.find(row[n]) != std::string::npos) result |= 1u << n;
  return result;
}

TEST(LevineWave, ShowsTheMatrixWorkedByHand) {
  const std::vector<std::string> sepl{"0++-", "-+--", "++--", "-+-+", "--0-"};
  const std::string eye = "---+";
  const std::vector<std::string> so{".----", "+.+--", "+-.--", "+++.0", "+++0."};
  RtlModel model(std::string(CIGSIM_RTL_LIBRARIES) + "/so_engine-Objects=5-Planes=4.so",
                 sizeof(Pins), 1);
  Pins& pins = model.pins<Pins>();
  pins.cfg_last_row_i = static_cast<std::uint32_t>(sepl.size() - 1);
  pins.rst_i = true;
  model.edge();
  pins.rst_i = false;

  std::ofstream out("so-levine.vcd");
  VcdWriter writer(out, 125, "cigsim.clock");
  writer.add_part("cigsim.so_engine.rtl", std::make_unique<RtlWave>(model, [] {}));
  writer.declare();
  Cycle now = 0;
  const auto cycle = [&] {
    writer.sample(now++);
    model.edge();
  };
  for (std::uint32_t row = 0; row < sepl.size(); ++row) {
    pins.row_valid_i = true;
    pins.row_index_i = row;
    pins.row_tells_i[0] = bits(sepl[row], "+-");
    pins.row_plus_i[0] = bits(sepl[row], "+");
    cycle();
  }
  pins.row_valid_i = false;
  pins.start_valid_i = true;
  pins.start_eye_i[0] = bits(eye, "+");
  pins.start_active_i[0] = (1u << sepl.size()) - 1;
  cycle();
  pins.start_valid_i = false;
  const Cycle first = now;
  for (std::size_t row = 0; row <= sepl.size(); ++row) cycle();
  writer.end(now);
  out.close();
  ASSERT_TRUE(out.good());

  WaveFile file("so-levine.vcd");
  const SignalNames names(file.signals());
  std::vector<std::size_t> wanted;
  for (const char* name : {"rtl.answer_hidden_o", "rtl.answer_hides_o", "rtl.answer_count_o",
                           "rtl.answer_valid_o", "rtl.answer_resolved_o"})
    wanted.push_back(names.find(name));
  const Wave wave = file.read(wanted, {});
  const auto value = [&](std::size_t signal, Cycle at) {
    std::string text;
    for (const WaveChange& change : wave.traces[signal].changes)
      if (static_cast<double>(change.time) * wave.unit_ns <= static_cast<double>(at) * 125)
        text = change.value;
    std::uint32_t number = 0;
    for (const char digit : text) number = 2 * number + (digit == '1' ? 1 : 0);
    return number;
  };
  for (std::uint32_t row = 0; row < so.size(); ++row) {
    SCOPED_TRACE("row " + std::to_string(row + 1));
    const Cycle at = first + row;
    EXPECT_EQ(value(0, at), bits(so[row], "-"));
    EXPECT_EQ(value(1, at), bits(so[row], "+"));
    EXPECT_EQ(value(2, at), static_cast<std::uint32_t>(std::popcount(bits(so[row], "-"))));
    EXPECT_EQ(value(3, at), 1u);
  }
  EXPECT_EQ(value(4, first + 4), 1u);
  EXPECT_EQ(value(3, first + 5), 0u);
}

}  // namespace
}  // namespace cigsim
