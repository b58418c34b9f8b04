// SPDX-License-Identifier: MIT
// Work in a process of its own, and how it can fail.
#include "sim/measure/child.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

#include "sim/arguments.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

std::string message(const std::function<Json()>& work, double limit_s = 60) {
  try {
    in_child("float at 64 x 64", limit_s, work);
  } catch (const MeasureError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Child, GivesBackWhatItsWorkReturnsAndKeepsInfinity) {
  const pid_t parent = ::getpid();
  const Json result = in_child("x", 60, [&] {
    return Json{{"other", ::getpid() != parent},
                {"far", std::numeric_limits<double>::infinity()},
                {"third", 1.0 / 3}};
  });
  EXPECT_TRUE(result["other"].get<bool>());
  EXPECT_EQ(result["far"].get<double>(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(result["third"].get<double>(), 1.0 / 3);
}

TEST(Child, GivesBackMoreThanAPipeHolds) {
  const std::string long_text(3'000'000, 'x');
  EXPECT_EQ(in_child("x", 60, [&] { return Json(long_text); }).get<std::string>(), long_text);
}

TEST(Child, AnErrorNamesWhatWasMeasured) {
  EXPECT_EQ(message([]() -> Json { throw UsageError("the raster is wrong"); }),
            "float at 64 x 64: the raster is wrong");
  EXPECT_EQ(message([]() -> Json { throw std::bad_alloc(); }),
            "float at 64 x 64: there is not enough memory; try a smaller scene or raster");
  EXPECT_EQ(message([]() -> Json { throw 7; }), "float at 64 x 64: failed without a message");
}

TEST(Child, ACrashIsAnErrorThatNamesTheSignal) {
  EXPECT_EQ(message([]() -> Json {
              std::signal(SIGUSR1, SIG_DFL);
              std::raise(SIGUSR1);
              return {};
            }),
            "float at 64 x 64: its process ended by signal 10 (User defined signal 1)");
}

TEST(Child, AnEarlyEndIsAnError) {
  EXPECT_EQ(message([]() -> Json { ::_exit(3); }),
            "float at 64 x 64: its process ended early, with code 3");
}

TEST(Child, WhatTakesTooLongIsEndedAndSaid) {
  const auto begin = std::chrono::steady_clock::now();
  const std::function<Json()> sleep = []() -> Json {
    std::this_thread::sleep_for(std::chrono::minutes(10));
    return {};
  };
  EXPECT_THROW(in_child("x", 0.05, sleep), MeasureError);
  EXPECT_EQ(message(sleep, 0.05), "float at 64 x 64: not done within 0.05 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::minutes(5));
}

TEST(Child, AnErrorLeavesTheParentAsItWas) {
  EXPECT_NE(message([]() -> Json { throw std::runtime_error("x"); }), "nothing");
  EXPECT_EQ(in_child("x", 60, [] { return Json(5); }), Json(5));
}

}  // namespace
}  // namespace cigsim
