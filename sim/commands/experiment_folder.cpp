// SPDX-License-Identifier: MIT
#include "sim/commands/experiment_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

// Of a run that wrote `file`; none when it was written by anything else.
std::vector<std::string> plots_of_earlier(const path& file, const Json& name) {
  std::ifstream in(file);
  const Json earlier = Json::parse(in, nullptr, false);
  std::vector<std::string> plots;
  if (!earlier.is_object() || earlier.value("experiment", Json()) != name) return plots;
  const Json listed = earlier.value("plots", Json());
  for (const Json& plot : listed) {
    const path plain = plot.is_string() ? path(plot.get<std::string>()) : path();
    if (plain == plain.filename() && plain.extension() == ".svg") plots.push_back(plain);
  }
  return plots;
}

void remove_plot(const path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return;
  if (!std::filesystem::remove(file, error) && error)
    throw InputError(file.string(), 0, "of an earlier run cannot be removed: " + error.message());
}

}  // namespace

void make_out_folder(const std::string& folder) {
  if (!can_plot())
    throw UsageError(
        "--out: graphs cannot be drawn without gnuplot; install Debian's package gnuplot-nox, or "
        "take --json");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw UsageError(fmt::format("--out: {} cannot be made a folder; name another", folder));
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    throw UsageError(fmt::format("--out: nothing can be written into {}; name another", folder));
}

std::vector<path> write_experiment(Json figures, const std::vector<Sheet>& sheets,
                                   const path& folder) {
  const path file = folder / (figures.at("experiment").get<std::string>() + ".json");
  const std::vector<std::string> earlier = plots_of_earlier(file, figures["experiment"]);
  figures["plots"] = Json::array();
  for (const Sheet& sheet : sheets) figures["plots"].push_back(sheet.name);
  write_file(file, dump(figures) + "\n");
  for (const std::string& plot : earlier) remove_plot(folder / plot);
  std::vector<path> files{file};
  for (const Sheet& sheet : sheets) {
    files.push_back(folder / sheet.name);
    draw_by_gnuplot(sheet.script, files.back());
  }
  return files;
}

}  // namespace cigsim
