// SPDX-License-Identifier: MIT
#include "sim/experiments/rtl_size.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "sim/arguments.hpp"
#include "sim/cosim/so_vectors.hpp"
#include "sim/host_time.hpp"
#include "sim/program_pipe.hpp"
#include "sim/rtl/library.hpp"

namespace cigsim {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kFixed = 256;

// A folder that is there as long as this object.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "cigsim-rtl-size-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw UsageError(
          fmt::format("--rtl: no folder can be made in {}", fs::temp_directory_path().string()));
    path_ = name;
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Each in a folder of its own, so that neither finds parts that the other has built.
fs::path build(const Folder& folder, const std::string& name, RtlSizeSide& side) {
  const fs::path own = folder.path() / name, library = own / "engine.so", log = own / "log";
  fs::create_directories(own);
  HostTime time;
  if (!build_rtl_library(side.variant, library, log))
    throw UsageError(fmt::format("--rtl: {} cannot be built; apt-get install verilator g++",
                                 side.variant.name()));
  side.build_s = time.lap() * 1e-3;
  side.library_mib = static_cast<double>(fs::file_size(library)) / (1 << 20);
  return library;
}

cosim::SoVectorOptions vectors_of(const RtlSizeSide& side, const fs::path& library,
                                  std::uint64_t rows, std::uint64_t seed) {
  cosim::SoVectorOptions options;
  options.library = library;
  options.objects = side.variant.parameters[0].value;
  options.planes = side.variant.parameters[1].value;
  options.vectors = rows;
  options.seed = static_cast<std::uint32_t>(seed % 0xffffffffu) + 1;
  return options;
}

}  // namespace

RtlSize measure_rtl_size(const Database& database, std::uint64_t rows, std::size_t rounds,
                         std::uint64_t seed, const std::function<void(const std::string&)>& say) {
  for (const char* program : {"verilator", "g++"})
    if (!has_program(program))
      throw UsageError(fmt::format("--rtl: {} is not installed; apt-get install it", program));
  // Verilator compiles through ccache where there is one, and a build that it remembers takes no
  // time.
  ::setenv("CCACHE_DISABLE", "1", 1);
  RtlSize size;
  size.sized.variant = so_engine_variant(RtlNeeds::of(database));
  size.fixed.variant = so_engine_variant(kFixed, kFixed);
  const Folder folder;
  RtlSizeSide* const sides[] = {&size.sized, &size.fixed};
  fs::path libraries[2];
  for (std::size_t s = 0; s < 2; ++s) {
    say(fmt::format("building {}", sides[s]->variant.name()));
    libraries[s] = build(folder, std::to_string(s), *sides[s]);
  }
  for (std::size_t s = 0; s < 2; ++s)
    size.golden =
        size.golden && !run_so_vectors(vectors_of(*sides[s], libraries[s], rows, seed)).mismatch;
  std::vector<double> row_us[2];
  for (const std::size_t s : interleaved(2, rounds, seed)) {
    cosim::SoVectorOptions options = vectors_of(*sides[s], libraries[s], rows, seed);
    options.compare = false;
    const cosim::SoVectorResult result = run_so_vectors(options);
    row_us[s].push_back(result.seconds * 1e6 / static_cast<double>(result.cycles));
  }
  for (std::size_t s = 0; s < 2; ++s) sides[s]->row_us = spread(std::move(row_us[s]));
  return size;
}

}  // namespace cigsim
