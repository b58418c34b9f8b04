// SPDX-License-Identifier: MIT
// Wave files by their ending: .vcd is read, .fst is read through the program fst2vcd.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "sim/program_pipe.hpp"
#include "sim/wave/vcd_reader.hpp"

namespace cigsim {

/// Throws UsageError for another ending than .vcd and .fst, and where `program`, needed for the
/// latter, is missing. `what` names the argument.
void check_wave_file(std::string_view what, const std::string& file, const std::string& program);

class WaveFile {
 public:
  /// Reads the declarations. Throws UsageError for another ending or a missing fst2vcd, InputError
  /// for a file that cannot be read.
  explicit WaveFile(const std::filesystem::path& file);
  ~WaveFile();

  const std::string& name() const { return name_; }
  const std::vector<WaveSignal>& signals() const { return reader_->signals(); }
  /// As VcdReader::read.
  Wave read(const std::vector<std::size_t>& wanted, const WaveWindow& window) {
    return reader_->read(wanted, window);
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  ByteSource source();

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;
  std::optional<Pipe> pipe_;
  std::optional<VcdReader> reader_;
};

}  // namespace cigsim
