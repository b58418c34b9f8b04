// SPDX-License-Identifier: MIT
#include "sim/rtl/library.hpp"

#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>

#include "sim/arguments.hpp"
#include "sim/program_pipe.hpp"
#include "sim/progress.hpp"
#include "sim/rtl/sources.hpp"

namespace cigsim {
namespace {

namespace fs = std::filesystem;

// Of the environment; nothing when it is not set, or empty.
std::optional<fs::path> folder_of(const char* name) {
  const char* folder = std::getenv(name);
  if (folder == nullptr || *folder == '\0') return {};
  return folder;
}

// Absolute, because the loader looks for a bare name elsewhere.
fs::path cache_folder() {
  if (const auto folder = folder_of("CIGSIM_RTL_CACHE")) return fs::absolute(*folder);
  if (const auto folder = folder_of("XDG_CACHE_HOME")) return fs::absolute(*folder) / "cigsim/rtl";
  const auto home = folder_of("HOME");
  return fs::absolute(home ? *home : fs::temp_directory_path()) / ".cache/cigsim/rtl";
}

// One process builds at a time; the others find what it built.
class Lock {
 public:
  explicit Lock(const fs::path& file) : file_(std::fopen(file.c_str(), "we")) {
    if (file_ != nullptr) ::flock(::fileno(file_), LOCK_EX);
  }
  bool held() const { return file_ != nullptr; }
  ~Lock() {
    if (file_ != nullptr) std::fclose(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  std::FILE* file_;
};

// "Name=Value-Name=Value" of a file that ships.
std::optional<RtlVariant> parse_name(const RtlVariant& like, std::string_view name) {
  RtlVariant variant{like.stage, like.module, {}};
  if (!name.starts_with(like.module + "-")) return {};
  name.remove_prefix(like.module.size());
  while (!name.empty()) {
    name.remove_prefix(1);
    const std::size_t end = std::min(name.find('-'), name.size()), equals = name.find('=');
    if (equals >= end) return {};
    variant.parameters.push_back(
        {std::string(name.substr(0, equals)),
         static_cast<std::uint32_t>(std::strtoul(
             std::string(name.substr(equals + 1, end - equals - 1)).c_str(), nullptr, 10))});
    name.remove_prefix(end);
  }
  return variant;
}

double size(const RtlVariant& variant) {
  double product = 1;
  for (const RtlVariant::Parameter& p : variant.parameters) product *= p.value;
  return product;
}

fs::path shipped(const RtlVariant& variant) {
  return fs::path(CIGSIM_RTL_LIBRARIES) / (variant.name() + ".so");
}

// What builds left behind that were ended half way; to be called with the lock held.
void remove_left_behind(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("sources-") || name.ends_with(".part") || name.ends_with(".part.work"))
      old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove_all(path, error);
}

// The steps that the build's script tells.
constexpr const char* kSteps[] = {"verilator", "compiler", "link"};

}  // namespace

bool build_rtl_library(const RtlVariant& variant, const fs::path& library, const fs::path& log) {
  const fs::path folder = library.parent_path();
  const fs::path sources = folder / fmt::format("sources-{}.{}", rtl_hash(variant.stage), getpid());
  write_rtl_sources(sources);
  const fs::path part = fmt::format("{}.{}.part", library.string(), getpid());
  std::vector<std::string> words{"sh",
                                 "-c",
                                 "log=$1; shift; exec sh \"$@\" 2>\"$log\"",
                                 "sh",
                                 log.string(),
                                 (sources / "rtl/common/build_library.sh").string(),
                                 sources.string(),
                                 variant.stage,
                                 variant.module,
                                 part.string(),
                                 (folder / "runtime").string()};
  for (const RtlVariant::Parameter& p : variant.parameters)
    words.push_back(fmt::format("{}={}", p.name, p.value));
  bool built = false;
  {
    Progress progress("building " + variant.name());
    Pipe pipe(words, Pipe::End::kReads);
    char line[256];
    for (double step = 0; std::fgets(line, sizeof line, pipe.file()) != nullptr; ++step)
      progress.show((step + 0.5) / static_cast<double>(std::size(kSteps)));
    built = pipe.finish();
  }
  std::error_code error;
  if (built) fs::rename(part, library, error);
  fs::remove_all(sources);
  fs::remove_all(part.string() + ".work");
  if (built) fs::remove(log);
  return built && !error;
}

std::optional<RtlVariant> shipped_rtl(const RtlVariant& wanted) {
  std::optional<RtlVariant> best;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(CIGSIM_RTL_LIBRARIES, error)) {
    if (entry.path().extension() != ".so") continue;
    const auto found = parse_name(wanted, entry.path().stem().string());
    if (found && found->covers(wanted) && (!best || size(*found) < size(*best))) best = found;
  }
  return best;
}

void say_on_stderr(const std::string& line) { fmt::print(stderr, "{}\n", line); }

RtlLibrary rtl_library(const RtlVariant& variant, const Say& say) {
  if (fs::exists(shipped(variant))) return {shipped(variant), variant};
  const fs::path folder = cache_folder();
  const fs::path library =
      folder / fmt::format("{}-{}.so", variant.name(), rtl_hash(variant.stage));
  if (fs::exists(library)) return {library, variant};

  std::string reason;
  for (const char* program : {"verilator", "g++"})
    if (reason.empty() && !has_program(program))
      reason = fmt::format("{} is not installed", program);
  if (reason.empty() && folder.string().find(' ') != std::string::npos)
    reason =
        fmt::format("Verilator takes no blanks in '{}'; set CIGSIM_RTL_CACHE", folder.string());
  std::error_code error;
  fs::create_directories(folder, error);
  if (reason.empty() && error)
    reason = fmt::format("{} cannot be made: {}", folder.string(), error.message());
  if (reason.empty()) {
    const Lock lock(folder / "lock");
    if (fs::exists(library)) return {library, variant};
    say(fmt::format("RTL       building {} for this scene, once", variant.name()));
    const fs::path log = fmt::format("{}.log", library.string());
    try {
      if (lock.held()) remove_left_behind(folder);
      if (build_rtl_library(variant, library, log)) return {library, variant};
      reason = fmt::format("its build failed, see {}", log.string());
    } catch (const std::runtime_error& error) {
      reason = fmt::format("it cannot be built: {}", error.what());
    }
  }
  if (const auto larger = shipped_rtl(variant)) {
    say(fmt::format("RTL       {}: {}; {}, which ships, takes its place", variant.name(), reason,
                    larger->name()));
    return {shipped(*larger), *larger};
  }
  throw UsageError(
      fmt::format("RTL {}: {}, and no size that ships is large enough; apt-get install "
                  "verilator g++",
                  variant.name(), reason));
}

}  // namespace cigsim
