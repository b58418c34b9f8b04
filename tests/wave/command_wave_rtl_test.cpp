// SPDX-License-Identifier: MIT
// Waves of RTL stages, by the command as a process of its own.
#include <algorithm>

#include "sim/wave/saved_view.hpp"
#include "sim/wave/wave_file.hpp"
#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

// As GTKWave looks for signals: by the whole name with its range.
TEST_F(CommandTest, TheViewSavedWithAWaveOfRtlNamesItsSignals) {
  const Outcome outcome =
      cigsim({"run", "--machine", "asupt1975", "--level",
              "priority_processor=rtl,edge_orderer=rtl,priority_resolver=rtl", "--wave", "w.vcd",
              "--wave-cycles", "266660:266760", "--out", "pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const WaveFile file(folder_ / "w.vcd");
  std::size_t rtl = 0, named = 0;
  for (const ViewRow& row : parse_saved_view(contents("w.gtkw"), "w.gtkw")) {
    if (row.kind != ViewRow::Kind::kSignal) continue;
    EXPECT_TRUE(std::any_of(
        file.signals().begin(), file.signals().end(),
        [&](const WaveSignal& signal) { return signal.name + signal.range == row.text; }))
        << row.text;
    rtl += row.text.find(".rtl.") != std::string::npos ? 1 : 0;
    named += row.names.empty() ? 0 : 1;
  }
  EXPECT_GT(rtl, 60u);
  EXPECT_EQ(named, 3u);

  ASSERT_EQ(cigsim({"wave-picture", "w.vcd", "--view", "w.gtkw", "--width", "9000", "-o", "w.svg"})
                .exit_code,
            0);
  EXPECT_NE(contents("w.svg").find(">CJP<"), std::string::npos) << "an instruction by name";
}

}  // namespace
}  // namespace cigsim
