// SPDX-License-Identifier: MIT
// The cigsim command run as a process of its own, in a folder of its own.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/scratch.hpp"

namespace cigsim {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when a signal ended it
  std::string out, err;
};

struct Limits {
  std::optional<std::uint64_t> file_size, memory;  ///< bytes
};

class CommandTest : public testing::Test {
 protected:
  /// Runs `cigsim arguments…` in the folder and waits for it.
  Outcome cigsim(const std::vector<std::string>& arguments, const Limits& limits = {});

  /// The two halves of that.
  pid_t start(const std::vector<std::string>& arguments, const Limits& limits = {});
  Outcome finish(pid_t child);

  /// Expects exit code 2, nothing on standard output and one line on standard error.
  void expect_unusable(const std::vector<std::string>& arguments,
                       const std::string& part_of_message, const Limits& limits = {});

  std::filesystem::path put(const std::string& name, const std::string& contents) const;
  std::string contents(const std::string& name) const;
  /// Names of everything below the folder, sorted.
  std::vector<std::string> files() const;

  const test::Scratch scratch_, logs_scratch_;
  const std::filesystem::path& folder_ = scratch_.folder();
  const std::filesystem::path& logs_ = logs_scratch_.folder();
};

}  // namespace cigsim
