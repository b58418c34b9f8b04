// SPDX-License-Identifier: MIT
// Value change dumps (IEEE 1364-2005, section 18), read strictly and as a stream: of a file of any
// size only the signals and the window that are asked for are kept.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "sim/wave/wave.hpp"

namespace cigsim {

/// Puts up to `size` bytes into `block` and tells how many; 0 at the end.
using ByteSource = std::function<std::size_t(char* block, std::size_t size)>;

/// Beyond the standard: strings (`s`), the nine values of VHDL (taken as 0, 1, x, z), and values
/// ahead of the first time (which count from the beginning), as several programs write them.
class VcdReader {
 public:
  /// Reads the declarations. `name` is the file in messages. Everything throws InputError with the
  /// line.
  VcdReader(ByteSource source, std::string name);

  /// In the order of the file.
  const std::vector<WaveSignal>& signals() const { return signals_; }

  /// Reads the rest, at most once. `wanted`: places in signals(), any order, also repeated. Stops
  /// at the window's end. Throws also for a window in which the file has nothing.
  Wave read(const std::vector<std::size_t>& wanted, const WaveWindow& window);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };
  struct Code {
    std::uint32_t width = 0;
    bool real = false;
    std::vector<std::size_t> signals, traces;  // of the same value
  };

  [[noreturn]] void fail(const std::string& what) const;
  bool fill();
  bool next(std::string& token);
  void need(std::string& token, const char* what);
  void skip_to_end(const char* command);
  std::string text_to_end(const char* command);

  void read_timescale();
  void read_scope();
  void read_variable();

  Code& code_of(std::string_view code);
  void change(Code& code, const std::string& value, Wave& wave);
  WaveTime in_units(double ns, double (*round)(double)) const;
  void take_scalar(const std::string& token, Wave& wave);
  void take_vector(const std::string& token, Wave& wave);
  bool take_time(const std::string& token, Wave& wave);

  ByteSource source_;
  std::string name_;
  std::vector<char> block_;
  std::size_t at_ = 0, end_ = 0;
  std::uint64_t line_ = 1;

  double unit_ns_ = 0;
  std::vector<std::string> scopes_;
  std::vector<WaveSignal> signals_;
  std::unordered_map<std::string, Code, Hash, std::equal_to<>> codes_;

  WaveTime now_ = 0, from_ = 0, to_ = 0;
  bool timed_ = false;  // a time has been read
  std::string value_, code_text_;
};

}  // namespace cigsim
