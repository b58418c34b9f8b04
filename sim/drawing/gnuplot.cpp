// SPDX-License-Identifier: MIT
#include "sim/drawing/gnuplot.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/markup.hpp"
#include "sim/program_pipe.hpp"

namespace cigsim {
namespace {

// A file in memory that the program which we start can read by the name path().
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view contents) : file_(::memfd_create("plot", 0)) {
    if (file_ < 0) throw std::runtime_error("no memory for a plot");
    while (!contents.empty()) {
      const ssize_t written = ::write(file_, contents.data(), contents.size());
      if (written <= 0) throw std::runtime_error("no memory for a plot");
      contents.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return fmt::format("/proc/self/fd/{}", file_); }

 private:
  int file_;
};

}  // namespace

bool can_plot() { return has_program("gnuplot"); }

// Within single quotes only these count.
std::string gnuplot_quoted(std::string_view words) {
  std::string out = "'";
  for (const char c : clean_words(words)) {
    if (c == '\'') out += '\'';
    out += c;
  }
  return out + "'";
}

std::string gnuplot_sheet(std::size_t count, int columns, int width, int height) {
  const int rows = (static_cast<int>(count) + columns - 1) / columns;
  return fmt::format(
      "set terminal svg size {},{} font 'Helvetica,11' background rgb '#ffffff'\n"
      "set multiplot layout {},{}\n",
      columns * width, rows * height, rows, columns);
}

void draw_by_gnuplot(const std::string& script, const std::filesystem::path& file) {
  if (!can_plot())
    throw InputError(file.string(), 0,
                     "cannot be drawn without gnuplot; install Debian's package gnuplot-nox");
  const MemoryFile commands(script);
  Pipe gnuplot({"gnuplot", commands.path()}, Pipe::End::kReads);
  std::string svg;
  char block[1 << 14];
  while (const std::size_t got = std::fread(block, 1, sizeof block, gnuplot.file()))
    svg.append(block, got);
  if (!gnuplot.finish() || svg.empty())
    throw InputError(file.string(), 0, "was not drawn: gnuplot failed; is its installation whole?");
  write_file(file, svg);
}

}  // namespace cigsim
