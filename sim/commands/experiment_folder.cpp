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

// A link, or whatever else stands in its place, is none of ours.
void remove_plot(const path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, error))) return;
  if (!std::filesystem::remove(file, error))
    throw InputError(file.string(), 0, "of an earlier run cannot be removed: " + error.message());
}

}  // namespace

ExperimentFolder::ExperimentFolder(const std::optional<std::string>& folder,
                                   const std::string& experiment) {
  if (!folder) return;
  folder_ = *folder;
  figures_ = folder_ / (experiment + ".json");
  make_folder(folder_);
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(figures_, error))) return;
  const std::optional<Json> figures = figures_of(figures_, experiment);
  if (!figures)
    throw UsageError(
        fmt::format("--out: {} was not written by an earlier run of this experiment, and would be "
                    "overwritten; name another folder",
                    figures_.string()));
  const auto plots = figures->find("plots");
  if (plots == figures->end() || !plots->is_array()) return;
  for (const Json& name : *plots)
    if (is_plot(name)) earlier_.push_back(name.get<std::string>());
}

bool ExperimentFolder::attempt(const path& file, const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    if (fault_.empty())
      fault_ = file == figures_
                   ? error.what()
                   : fmt::format("{}: has the figures, but {}", figures_.string(), error.what());
    return false;
  }
}

bool ExperimentFolder::write_figures(Json& figures, const std::vector<std::string>& plots) {
  figures["plots"] = plots;
  return attempt(figures_, [&] { write_file(figures_, dump(figures) + "\n"); });
}

void ExperimentFolder::write(Json figures, const std::vector<Sheet>& sheets) {
  if (folder_.empty()) return;
  std::vector<std::string> plots;
  for (const Sheet& sheet : sheets) plots.push_back(sheet.name);
  // Earlier ones stay on the list until they are gone, so that a later run removes what is left.
  std::vector<std::string> with_earlier = plots;
  for (const std::string& plot : earlier_)
    if (std::find(plots.begin(), plots.end(), plot) == plots.end()) with_earlier.push_back(plot);
  if (!write_figures(figures, with_earlier)) return;
  written_.push_back(figures_);
  bool gone = true;
  for (const std::string& plot : earlier_)
    gone = attempt(folder_ / plot, [&] { remove_plot(folder_ / plot); }) && gone;
  if (gone && with_earlier.size() > plots.size()) write_figures(figures, plots);
  for (const Sheet& sheet : sheets) {
    const path file = folder_ / sheet.name;
    if (attempt(file, [&] { draw_by_gnuplot(sheet.script, file); })) written_.push_back(file);
  }
}

void ExperimentFolder::tell(bool json) const {
  if (!json)
    for (const path& file : written_) fmt::print("{} written\n", file.string());
  if (!fault_.empty()) throw std::runtime_error(fault_);
}

}  // namespace cigsim
