// SPDX-License-Identifier: MIT
// Which economies there are (economies.hpp).

#include "models/machine/description.hpp"
#include "sim/arguments.hpp"
#include "sim/experiments/economies.hpp"

namespace cigsim {
namespace {

// Both sides alike, on doubles.
Economy functional(const char* name, const char* with, const char* without,
                   const EconomyScene& scene, const EconomyOptions& options) {
  Economy economy;
  economy.name = name;
  economy.with = with;
  economy.without = without;
  economy.database_with = economy.database_without = scene.database;
  economy.setting_with.name = std::string(name) + ": " + with;
  economy.setting_without.name = std::string(name) + ": " + without;
  economy.setting_with.machine.raster = economy.setting_without.machine.raster = options.raster;
  return economy;
}

// The painter needs no crossings, active list and spans; those who ask for the machine's own way
// have them all.
Economy stages(const EconomyScene& scene, const EconomyOptions& options) {
  Economy e = functional("stages", "painter: four", "all six", scene, options);
  e.setting_with.machine.resolver = ResolverMethod::kPainter;
  e.setting_without.machine.resolver = ResolverMethod::kActiveList;
  return e;
}

// Who studies one stage needs the cycles of the others, not their registers.
Economy clocked_stages(const EconomyScene& scene, const EconomyOptions& options) {
  Economy e = functional("clocked stages", "edge_orderer", "all that can be", scene, options);
  e.setting_with.levels = LevelChoice::parse("edge_orderer=clocked");
  e.setting_without.levels = LevelChoice::parse("clocked");
  for (Setting* setting : {&e.setting_with, &e.setting_without}) {
    MachineOptions& machine = setting->machine;
    machine.number = NumberType::kMachine;
    machine.resolver = ResolverMethod::kActiveList;
    try {
      machine.description = with_raster(load_machine("unlimited"), options.raster);
    } catch (const std::invalid_argument& error) {
      throw UsageError(std::string("--raster: ") + error.what());
    }
    machine.eye_reach = eye_reach(scene.views);
  }
  e.same_cycles = true;
  return e;
}

Economy retrieval(const EconomyScene& scene, const EconomyOptions& options) {
  Economy e = functional("retrieval", "spheres", "everything active", scene, options);
  e.setting_without.machine.retrieval = false;
  e.stage = {Stage::kFrameCalculator, &StageTimes::frame_calculator};
  return e;
}

Economy coherence(const EconomyScene& scene, const EconomyOptions& options) {
  Economy e = functional("coherence", "orders kept", "every frame anew", scene, options);
  e.setting_without.machine.coherence = false;
  e.stage = {Stage::kPriorityProcessor, &StageTimes::priority_processor};
  return e;
}

Economy less_detail(const EconomyScene& scene, const EconomyOptions& options) {
  Economy e = functional("levels of detail", "by size", "most", scene, options);
  e.setting_without.machine.detail = 0;
  e.same_pictures = false;
  return e;
}

Economy attribute(const char* name, const Database& lean, const EconomyScene& scene,
                  const EconomyOptions& options) {
  Economy e = functional(name, "none", "as in the scene", scene, options);
  e.database_with = &lean;
  e.same_pictures = false;
  return e;
}

}  // namespace

std::vector<Economy> economies_of(const EconomyScene& scene, const EconomyOptions& options,
                                  LeanDatabases& lean) {
  const Database& database = *scene.database;
  std::vector<Economy> out{stages(scene, options), clocked_stages(scene, options),
                           retrieval(scene, options), coherence(scene, options)};
  if (has_choices(database)) out.push_back(less_detail(scene, options));
  if (database.systems.size() > 1) {
    lean.without_moving = database;
    lean.without_moving->systems.resize(1);
    out.push_back(attribute("no moving models", *lean.without_moving, scene, options));
  }
  if (!database.ground.faces.empty()) {
    lean.without_ground = database;
    lean.without_ground->ground.clear();
    out.push_back(attribute("no ground", *lean.without_ground, scene, options));
  }
  return out;
}

}  // namespace cigsim
