// SPDX-License-Identifier: MIT
#include "sim/wave/wave_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "sim/arguments.hpp"

namespace cigsim {
namespace {

constexpr const char* kUnpacker = "fst2vcd";

std::FILE* open_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw InputError(file.string(), 0, "is a folder; name a wave file inside it");
  std::FILE* opened = std::fopen(file.c_str(), "rb");
  if (opened == nullptr && errno == ENOENT)
    throw InputError(file.string(), 0, "no such file; check the name and the folder");
  if (opened == nullptr)
    throw InputError(file.string(), 0, fmt::format("cannot be opened ({})", std::strerror(errno)));
  return opened;
}

}  // namespace

void check_wave_file(std::string_view what, const std::string& file, const std::string& program) {
  check_ending(what, file, {"vcd", "fst"});
  if (lower_ending(file) == "fst" && !has_program(program))
    throw UsageError(
        fmt::format("{}: .fst files need the program {}; install the Debian package gtkwave, or "
                    "take .vcd",
                    what, program));
}

WaveFile::WaveFile(const std::filesystem::path& file) : name_(file.string()) {
  check_wave_file("FILE", name_, kUnpacker);
  file_.reset(open_file(file));
  if (lower_ending(file) == "fst")
    pipe_.emplace(std::vector<std::string>{kUnpacker, "-f", name_}, Pipe::End::kReads);
  reader_.emplace(source(), name_);
}

WaveFile::~WaveFile() = default;

ByteSource WaveFile::source() {
  return [this, none = true, ended = false](char* block, std::size_t size) mutable -> std::size_t {
    if (ended) return 0;
    std::FILE* input = pipe_ ? pipe_->file() : file_.get();
    const std::size_t got = std::fread(block, 1, size, input);
    if (got == 0 && std::ferror(input) != 0)
      throw InputError(name_, 0, fmt::format("cannot be read ({})", std::strerror(errno)));
    ended = got == 0;
    if (ended && pipe_ && !pipe_->finish())
      throw InputError(name_, 0,
                       fmt::format("{} cannot read it; it is damaged or cut short", kUnpacker));
    if (ended && none) throw InputError(name_, 0, "is empty; record the wave again");
    none = false;
    return got;
  };
}

}  // namespace cigsim
