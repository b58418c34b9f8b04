// SPDX-License-Identifier: MIT
// Other programs that cigsim starts and reads from or writes to.
#pragma once

#include <sys/types.h>

#include <cstdio>
#include <string>
#include <vector>

namespace cigsim {

/// Whether PATH leads to `program`.
bool has_program(const std::string& program);

/// `text` as one word of a shell's command line: as it is, or in quotes.
std::string shell_word(const std::string& text);

/// A program whose standard output, or input, is a file of ours. Throws std::runtime_error when it
/// cannot be started.
class Pipe {
 public:
  enum class End { kReads, kWrites };  ///< what we do

  /// `words`: the program, looked for in PATH, and its arguments.
  Pipe(const std::vector<std::string>& words, End end);
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  std::FILE* file() { return file_; }

  /// Closes our end and waits for the program: whether it ended with success. A program that we
  /// read from and that we left before its end counts as a failure.
  bool finish();

 private:
  std::FILE* file_ = nullptr;
  pid_t child_ = -1;
};

}  // namespace cigsim
