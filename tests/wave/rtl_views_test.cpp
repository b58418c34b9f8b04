// SPDX-License-Identifier: MIT
// The saved views of the RTL, held to what its libraries declare; and the view that is saved beside
// a wave.
#include <gtest/gtest.h>

#include <sstream>

#include "rtl/edge_orderer/edge_orderer.pins.hpp"
#include "rtl/priority_processor/priority_processor.pins.hpp"
#include "rtl/priority_processor/so_engine.pins.hpp"
#include "rtl/priority_resolver/priority_resolver.pins.hpp"
#include "sim/wave/embedded_views.hpp"
#include "sim/wave/saved_view.hpp"
#include "sim/wave/signal_names.hpp"
#include "sim/wave/stage_view.hpp"
#include "sim/wave/vcd_reader.hpp"
#include "sim/wave/vcd_writer.hpp"

namespace cigsim {
namespace {

struct Library {
  std::string module, parameters;
  std::size_t pins_size;
};

/// What a wave with the RTL, and nothing else, has in it.
std::vector<WaveSignal> signals_of(const Library& library) {
  RtlModel model(
      std::string(CIGSIM_RTL_LIBRARIES) + "/" + library.module + "-" + library.parameters + ".so",
      library.pins_size, 1);
  std::ostringstream out;
  VcdWriter writer(out, 125, "cigsim.clock");
  writer.add_part("cigsim." + library.module + ".rtl", std::make_unique<RtlWave>(model, [] {}));
  writer.declare();
  writer.end(0);
  const std::string text = out.str();
  VcdReader reader(
      [&text, at = std::size_t{0}](char* block, std::size_t size) mutable {
        const std::size_t count = text.copy(block, size, at);
        at += count;
        return count;
      },
      "dump");
  return reader.signals();
}

class RtlView : public testing::TestWithParam<Library> {};

TEST_P(RtlView, NamesSignalsThatThereAre) {
  const std::vector<WaveSignal> signals = signals_of(GetParam());
  const std::string file = GetParam().module + ".rtl.gtkw";
  const std::string scope = "cigsim." + GetParam().module + ".rtl.";
  std::size_t found = 0;
  for (const ViewRow& row : parse_saved_view(embedded_text(embedded_views(), file), file)) {
    if (row.kind != ViewRow::Kind::kSignal || !row.text.starts_with(scope)) continue;
    EXPECT_NO_THROW({
      const std::string& name = signals[SignalNames(signals).find(row.text)].name;
      EXPECT_TRUE(row.text.starts_with(name)) << row.text << " is taken for " << name;
    }) << row.text;
    ++found;
  }
  EXPECT_GT(found, 10u);
}

// GTKWave wants the range that the file declares.
TEST_P(RtlView, HasTheRangesOfTheWaveThatItIsSavedWith) {
  const std::vector<WaveSignal> signals = signals_of(GetParam());
  const StageView view = stage_view(GetParam().module, signals, "/folder/wave.");
  const std::string scope = "cigsim." + GetParam().module + ".rtl.";
  for (const ViewRow& row : parse_saved_view(view.text, "view")) {
    if (row.kind != ViewRow::Kind::kSignal) continue;
    EXPECT_NE(row.text, "cigsim.clock");
    if (row.text.starts_with(scope)) {
      EXPECT_TRUE(std::any_of(signals.begin(), signals.end(), [&](const WaveSignal& signal) {
        return signal.name + signal.range == row.text;
      })) << row.text;
    }
    if (!row.names.empty()) {
      ASSERT_TRUE(row.names.starts_with("/folder/wave."));
      EXPECT_EQ(view.names.count(row.names.substr(13)), 1u) << row.names;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, RtlView,
    testing::Values(
        Library{"edge_orderer", "Edges=100-Lines=16-Crossings=16", sizeof(rtl::edge_orderer::Pins)},
        Library{"edge_orderer", "Edges=4096-Lines=1024-Crossings=256",
                sizeof(rtl::edge_orderer::Pins)},
        Library{"priority_resolver", "Faces=64", sizeof(rtl::priority_resolver::Pins)},
        Library{"priority_resolver", "Faces=1024", sizeof(rtl::priority_resolver::Pins)},
        Library{"priority_processor", "Members=5-Levels=3", sizeof(rtl::priority_processor::Pins)},
        Library{"priority_processor", "Members=64-Levels=64",
                sizeof(rtl::priority_processor::Pins)},
        Library{"so_engine", "Objects=5-Planes=4", sizeof(rtl::so_engine::Pins)},
        Library{"so_engine", "Objects=64-Planes=64", sizeof(rtl::so_engine::Pins)}),
    [](const auto& info) { return info.param.module + std::to_string(info.index); });

}  // namespace
}  // namespace cigsim
