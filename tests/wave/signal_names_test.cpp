// SPDX-License-Identifier: MIT
#include "sim/wave/signal_names.hpp"

#include <gtest/gtest.h>

namespace cigsim {
namespace {

const std::vector<WaveSignal> kSignals{{"top.clock", "", 1, false},
                                       {"top.resolver.at", "[15:0]", 16, false},
                                       {"top.resolver.start", "[15:0]", 16, false},
                                       {"top.orderer.at", "[15:0]", 16, false},
                                       {"top.orderer.format", "[3:0]", 4, false}};

std::string error_of(const std::string& name) {
  try {
    SignalNames(kSignals).find(name);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing";
}

TEST(SignalNames, TheLastPartsDoWhereTheyAreUnique) {
  const SignalNames names(kSignals);
  EXPECT_EQ(names.find("top.orderer.at"), 3u);
  EXPECT_EQ(names.find("top.orderer.at[15:0]"), 3u);
  EXPECT_EQ(names.find("resolver.at"), 1u);
  EXPECT_EQ(names.find("start[15:0]"), 2u);
  EXPECT_EQ(names.find("clock"), 0u);
}

TEST(SignalNames, OthersAreToldWithTheirNeighbours) {
  EXPECT_EQ(error_of("at"),
            "2 signals are called 'at', such as top.resolver.at, top.orderer.at; name more of "
            "one's scopes");
  EXPECT_EQ(error_of("resolver.stat"),
            "there is no signal 'resolver.stat'; near it are top.resolver.start, top.resolver.at, "
            "top.orderer.at, top.orderer.format");
  EXPECT_NE(error_of("mat"), "nothing") << "parts are whole";
}

}  // namespace
}  // namespace cigsim
