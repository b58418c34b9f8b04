// SPDX-License-Identifier: MIT
#include "sim/commands/experiment_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/json_file.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{32} << 20;  // far more than any writes

void make_folder(const path& folder) {
  if (!can_plot())
    throw UsageError(
        "--out: graphs cannot be drawn without gnuplot; install Debian's package gnuplot-nox, or "
        "take --json");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder, error))
    throw UsageError(
        fmt::format("--out: '{}' cannot be made a folder; name another", folder.string()));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw UsageError(
        fmt::format("--out: nothing can be written into {}; name another", folder.string()));
}

// None when the experiment did not write the file.
std::optional<Json> figures_of(const path& file, const std::string& experiment) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) ||
      std::filesystem::file_size(file, error) > kLargestFile)
    return {};
  try {
    Json figures = JsonFile(file).value();
    const auto name = figures.find("experiment");
    if (name != figures.end() && *name == experiment) return figures;
  } catch (const InputError&) {
  }
  return {};
}

// A name of a drawing in the same folder.
bool is_plot(const Json& name) {
  if (!name.is_string()) return false;
  const auto& text = name.get_ref<const std::string&>();
  return text.find('\0') == std::string::npos && path(text) == path(text).filename() &&
         path(text).extension() == ".svg";
}

// Whether it is gone. A link, or whatever else stands in its place, is none of ours.
bool remove_plot(const path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error))) return true;
  return std::filesystem::remove(file, error);
}

}  // namespace

ExperimentFolder::ExperimentFolder(path folder, const std::string& experiment)
    : folder_(std::move(folder)), figures_(folder_ / (experiment + ".json")) {
  make_folder(folder_);
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(figures_, error))) return;
  const std::optional<Json> figures = figures_of(figures_, experiment);
  if (!figures)
    throw UsageError(
        fmt::format("--out: {} is not of an earlier {} and would be overwritten; name "
                    "another folder",
                    figures_.string(), experiment));
  const auto plots = figures->find("plots");
  if (plots == figures->end() || !plots->is_array()) return;
  for (const Json& name : *plots)
    if (is_plot(name)) earlier_.push_back(name.get<std::string>());
}

std::vector<path> ExperimentFolder::write(Json figures, const std::vector<Sheet>& sheets) const {
  std::string fault;
  std::vector<std::string> plots;
  for (const Sheet& sheet : sheets) plots.push_back(sheet.name);
  for (const std::string& plot : earlier_) {
    if (remove_plot(folder_ / plot)) continue;
    fault = fmt::format("{}, of an earlier run, cannot be removed", (folder_ / plot).string());
    // It stays on the list, for the next run to remove.
    if (std::find(plots.begin(), plots.end(), plot) == plots.end()) plots.push_back(plot);
  }
  figures["plots"] = std::move(plots);
  write_file(figures_, dump(figures) + "\n");
  std::vector<path> files{figures_};
  for (const Sheet& sheet : sheets) {
    try {
      draw_by_gnuplot(sheet.script, folder_ / sheet.name);
      files.push_back(folder_ / sheet.name);
    } catch (const InputError& error) {
      fault = error.what();
    }
  }
  if (!fault.empty()) throw InputError(figures_.string(), 0, "has the figures, but " + fault);
  return files;
}

void tell_written(const std::vector<path>& files, bool json) {
  if (json) return;
  for (const path& file : files) fmt::print("{} written\n", file.string());
}

}  // namespace cigsim
