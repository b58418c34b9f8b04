// SPDX-License-Identifier: MIT
// Finding the scene that a command names, as a prepared database.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "models/database/database.hpp"
#include "models/environment/read.hpp"

namespace cigsim {

/// The name of the scene where none is given.
inline constexpr const char* kBuiltInScene = "built-in airfield";

/// What preparation does not keep of an environment.
struct SceneFacts {
  std::size_t models = 0;
  bool sun = false;  ///< colours were shaded
};

struct LoadedScene {
  std::string name;  ///< the file as given, or "built-in airfield"
  Database database;
  std::optional<SceneFacts> facts;  ///< none: the scene came prepared
};

/// What the command line says of preparation.
struct PreparationChoices {
  std::optional<Sun> sun;
  std::optional<double> contact_tolerance;
  /// PrepareOptions::most_detailed. A prepared database keeps its levels of detail.
  bool most_detailed = false;
};

/// SCENE.
void add_scene_option(CLI::App& command, std::optional<std::string>& scene);

/// --sun AZ,EL and --contact-tolerance SHARE.
void add_preparation_options(CLI::App& command, PreparationChoices& choices);

/// Several environments as one: objects in the order of the inputs, the background of the first,
/// the first view and sun that an input has. `parts` must not be empty. Throws UsageError when one
/// of several has a separation table.
ReadResult merge(std::vector<ReadResult> parts);

/// Prepares `scene` with a progress bar; what the reader noticed joins the report. `name` stands
/// for the scene in messages.
Database prepare_scene(const ReadResult& scene, const std::string& name,
                       const PreparationChoices& choices);

/// A scene file is prepared in memory, a prepared database is read; without a file, the airfield.
/// Throws InputError, and UsageError for such a choice with a prepared database.
LoadedScene load_scene(const std::optional<std::filesystem::path>& file,
                       const PreparationChoices& choices);

}  // namespace cigsim
