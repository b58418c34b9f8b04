// SPDX-License-Identifier: MIT
#include "sim/budget/cache.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/budget/database_digest.hpp"
#include "sim/measure/digest.hpp"
#include "sim/measure/host.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::optional<fs::path> folder_of(const char* name) {
  const char* folder = std::getenv(name);
  if (folder == nullptr || *folder == '\0') return {};
  return folder;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

std::string digest_of(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return fmt::format("{:016x}-{}", digest.value(), bytes.size());
}

Json views_json(const std::vector<FrameView>& views) {
  Json out = Json::array();
  for (const FrameView& view : views) {
    const Placement& eye = view.viewpoint.eye;
    out.push_back({eye.position.x, eye.position.y, eye.position.z, eye.heading, eye.pitch, eye.roll,
                   view.viewpoint.fov, view.position});
  }
  return out;
}

Json settings_json(const std::vector<Setting>& settings) {
  Json out = Json::array();
  for (const Setting& setting : settings) {
    const MachineOptions& m = setting.machine;
    const bool words = m.number == NumberType::kMachine;
    out.push_back({setting.name, setting_json(setting), m.eye_reach,
                   words ? Json(digest_of(machine_json(m.description))) : Json()});
  }
  return out;
}

}  // namespace

fs::path budget_cache_folder() {
  if (const auto folder = folder_of("CIGSIM_BUDGET_CACHE")) return fs::absolute(*folder);
  if (const auto folder = folder_of("XDG_CACHE_HOME"))
    return fs::absolute(*folder) / "cigsim/budget";
  const auto home = folder_of("HOME");
  return fs::absolute(home ? *home : fs::temp_directory_path()) / ".cache/cigsim/budget";
}

Json evidence_key(const Database& database, const std::vector<FrameView>& views,
                  const std::vector<Setting>& settings, Level referee) {
  return {{"version", version()},          {"program", digest_of(bytes_of("/proc/self/exe"))},
          {"processor", processor_name()}, {"database", database_digest(database)},
          {"views", views_json(views)},    {"settings", settings_json(settings)},
          {"referee", name_of(referee)}};
}

fs::path evidence_file(const Json& key) {
  return budget_cache_folder() / (digest_of(key.dump()) + ".json");
}

std::optional<std::vector<Evidence>> read_evidence(const fs::path& file, const Json& key) {
  const Json json = Json::parse(bytes_of(file), nullptr, false);
  if (!json.is_object() || !json.contains("key") || json["key"] != key) return {};
  try {
    if (json.at("digest") != digest_of(json.at("evidence").dump())) return {};
    std::vector<Evidence> evidence;
    for (const Json& one : json.at("evidence")) evidence.push_back(evidence_from_json(one));
    if (evidence.size() != key.at("settings").size()) return {};
    return evidence;
  } catch (const Json::exception&) {
    return {};
  }
}

void write_evidence(const fs::path& file, const Json& key, const std::vector<Evidence>& evidence) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    throw InputError(file.parent_path().string(), 0, "cannot make this folder: " + error.message());
  Json list = Json::array();
  for (const Evidence& one : evidence) list.push_back(evidence_json(one));
  const std::string digest = digest_of(list.dump());
  write_file(file, dump({{"key", key}, {"evidence", std::move(list)}, {"digest", digest}}) + "\n");
}

}  // namespace cigsim
