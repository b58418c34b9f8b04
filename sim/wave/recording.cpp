// SPDX-License-Identifier: MIT
#include "sim/wave/recording.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <streambuf>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/program_pipe.hpp"
#include "sim/wave/embedded_views.hpp"
#include "sim/wave/stage_view.hpp"
#include "sim/wave/vcd_writer.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

// Into a pipe.
class PipeBuffer : public std::streambuf {
 public:
  explicit PipeBuffer(std::FILE* file) : file_(file) {}

 protected:
  int_type overflow(int_type c) override {
    return traits_type::eq_int_type(c, traits_type::eof()) ? 0 : std::fputc(c, file_);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    return static_cast<std::streamsize>(
        std::fwrite(text, 1, static_cast<std::size_t>(size), file_));
  }

 private:
  std::FILE* file_;
};

// A file that is removed unless it was renamed.
struct Part {
  std::filesystem::path file;
  ~Part() {
    std::error_code error;
    std::filesystem::remove(file, error);
  }
};

// vcd2fst does not tell of a full disk, nor of a wave without a cycle; fst2vcd cannot read what it
// leaves then, or never ends. The file is a row of blocks, each a byte for its kind and eight for
// its length, which counts these too; the last one is the hierarchy.
bool complete_fst(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  constexpr std::uintmax_t kLengthBytes = 8;
  const auto hierarchy = [](int kind) { return kind == 4 || kind == 6 || kind == 7; };
  int kind = -1;
  std::uintmax_t at = 0;
  while (!error && at < size) {
    in.seekg(static_cast<std::streamoff>(at));
    kind = in.get();
    std::uintmax_t length = 0;
    for (std::uintmax_t i = 0; i < kLengthBytes; ++i)
      length = length << 8 | static_cast<unsigned char>(in.get());
    if (!in || length < kLengthBytes || length > size - at - 1) return false;
    at += 1 + length;
  }
  return !error && hierarchy(kind);
}

void write_packed(const std::filesystem::path& file,
                  const std::function<void(std::ostream&)>& record) {
  std::signal(SIGPIPE, SIG_IGN);  // a program that ended early is an error of writing
  const Part part{fmt::format("{}.{}.part", file.string(), ::getpid())};
  write_file(part.file, "");  // finds out now whether the folder can be written to
  Pipe pipe({"vcd2fst", "-v", "-", "-f", part.file.string()}, Pipe::End::kWrites);
  PipeBuffer buffer(pipe.file());
  std::ostream out(&buffer);
  record(out);
  std::error_code error;
  const bool complete = pipe.finish() && out.good() && complete_fst(part.file);
  if (complete) std::filesystem::rename(part.file, file, error);
  if (!complete || error)
    throw InputError(
        file.string(), 0,
        "is left incomplete by vcd2fst: the disk is full, or the run ended ahead of the window");
}

// The 26 named markers, which stand nowhere.
constexpr const char* kNoMarkers =
    " -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1 -1";

// The whole of a window in view, and the marker at a spot; without one, the file's beginning.
std::string opened_at(const WaveRequest& request) {
  if (!request.spot) return "[timestart] 0\n";
  constexpr double kPixels = 1000;
  const double cycle = request.spot->cycle_ns / vcd_unit_ns(request.spot->cycle_ns);
  const auto [first, last] = request.window;
  const double wide = static_cast<double>(last - first + 1) * cycle;
  return fmt::format("[timestart] {:.0f}\n*{:.6f} {:.0f}{}\n", static_cast<double>(first) * cycle,
                     -std::log2(wide / kPixels), static_cast<double>(request.spot->cycle) * cycle,
                     kNoMarkers);
}

// The stages' views one below the other, the clock once, under the name of the file. Writes the
// names of values that they use, each file beside the wave.
std::string saved_view(const WaveRequest& request) {
  constexpr std::string_view kClock = "@28\ncigsim.clock\n";
  std::string text =
      fmt::format("[dumpfile] \"{}\"\n{}{}", std::filesystem::absolute(request.file).string(),
                  opened_at(request), kClock);
  const WaveFile file(request.file);
  const std::string folder =
      std::filesystem::absolute(request.file).replace_extension().string() + ".";
  for (const Stage stage : request.stages) {
    const StageView view = stage_view(name_of(stage), file.signals(), folder);
    text += view.text;
    for (const std::string& names : view.names)
      write_file(folder + names, embedded_text(embedded_views(), names));
  }
  return text;
}

}  // namespace

void write_wave(const WaveRequest& request, const std::function<void(std::ostream&)>& record) {
  if (lower_ending(request.file) == "fst")
    write_packed(request.file, record);
  else
    write_file(request.file, record);
  write_file(view_file(request), saved_view(request));
}

std::string view_file(const WaveRequest& request) {
  return std::filesystem::path(request.file).replace_extension(".gtkw").string();
}

std::string view_command(const WaveRequest& request) {
  return fmt::format("gtkwave {} {}", shell_word(request.file), shell_word(view_file(request)));
}

}  // namespace cigsim
