// SPDX-License-Identifier: MIT
#include "sim/report/experiment_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "sim/json_file.hpp"
#include "sim/report/base64.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kLargestFile = std::uintmax_t{32} << 20;

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  std::error_code error;
  std::filesystem::directory_iterator at(folder, error);
  for (; !error && at != std::filesystem::directory_iterator(); at.increment(error))
    if (at->is_regular_file(error)) out.push_back(at->path());
  if (error) throw InputError(folder.string(), 0, "cannot be read: " + error.message());
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

Json experiment_section(const std::filesystem::path& folder) {
  Json experiments = Json::array(), drawings = Json::array(), notes = Json::array();
  for (const std::filesystem::path& file : files_of(folder)) {
    const std::string name = file.filename().string(), ending = lower_ending(file);
    if ((ending != "json" && ending != "svg") || name == "stats.json") continue;
    if (std::filesystem::file_size(file) > kLargestFile) {
      notes.push_back(fmt::format("{} is larger than 32 MiB and left out.", name));
      continue;
    }
    try {
      if (ending == "svg") {
        drawings.push_back(
            {{"file", name}, {"uri", data_uri("image/svg+xml", read_whole_file(file))}});
        continue;
      }
      Json figures = JsonFile(file).value();
      if (figures.is_object() && figures.contains("experiment"))
        experiments.push_back({{"file", name}, {"figures", std::move(figures)}});
      else
        notes.push_back(fmt::format("{} tells of no experiment and is left out.", name));
    } catch (const InputError& error) {
      notes.push_back(fmt::format("Left out: {}", error.what()));
    }
  }
  return {{"experiments", std::move(experiments)},
          {"drawings", std::move(drawings)},
          {"notes", std::move(notes)}};
}

}  // namespace cigsim
