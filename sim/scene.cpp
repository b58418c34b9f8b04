// SPDX-License-Identifier: MIT
#include "sim/scene.hpp"

#include <algorithm>
#include <iterator>

#include "models/database/database_file.hpp"
#include "models/database/prepare.hpp"
#include "models/environment/input_error.hpp"
#include "sim/arguments.hpp"
#include "sim/embedded.hpp"
#include "sim/progress.hpp"

namespace cigsim {
namespace {

void append(Environment& whole, Environment&& part) {
  // System 0 is the environment's own in every part; the others follow one another.
  const auto systems = static_cast<std::uint32_t>(whole.systems.size() - 1);
  const auto models = static_cast<std::uint32_t>(whole.models.size());
  for (Model& model : part.models) {
    if (model.system != 0) model.system += systems;
    whole.models.push_back(std::move(model));
  }
  const auto choices = static_cast<std::uint32_t>(whole.choices.size());
  for (Choice& choice : part.choices) {
    choice.model += models;
    if (choice.within) choice.within->choice += choices;
    whole.choices.push_back(std::move(choice));
  }
  for (Object& object : part.objects) {
    object.model += models;
    if (object.within) object.within->choice += choices;
    whole.objects.push_back(std::move(object));
  }
  std::move(part.systems.begin() + 1, part.systems.end(), std::back_inserter(whole.systems));
  std::move(part.ground.begin(), part.ground.end(), std::back_inserter(whole.ground));
  if (!whole.view) whole.view = part.view;
  if (!whole.sun) whole.sun = part.sun;
}

void append(std::vector<Notice>& whole, const std::vector<Notice>& part) {
  for (const Notice& notice : part) {
    const auto same = std::find_if(whole.begin(), whole.end(),
                                   [&](const Notice& n) { return n.what == notice.what; });
    if (same == whole.end())
      whole.push_back(notice);
    else
      same->count += notice.count;
  }
}

LoadedScene prepared(std::string name, const ReadResult& scene, const PreparationChoices& choices) {
  const SceneFacts facts{scene.environment.models.size(), choices.sun || scene.environment.sun};
  Database database = prepare_scene(scene, name, choices);
  return {std::move(name), std::move(database), facts};
}

}  // namespace

void add_scene_option(CLI::App& command, std::optional<std::string>& scene) {
  command
      .add_option("SCENE", scene, "Scene file or prepared database. Default: the built-in airfield")
      ->type_name("");
}

void add_preparation_options(CLI::App& command, PreparationChoices& choices) {
  command
      .add_option_function<std::string>(
          "--sun", [&choices](const std::string& text) { choices.sun = parse_sun("--sun", text); },
          "Shade faces by a sun at this azimuth (clockwise from north) and elevation, in degrees. "
          "Default: the scene's own sun, or colours as given")
      ->type_name("AZ,EL");
  command
      .add_option_function<std::string>(
          "--contact-tolerance",
          [&choices](const std::string& text) {
            choices.contact_tolerance = parse_number("--contact-tolerance", text, 0, 1);
          },
          "Bodies that overlap by no more than this share of their largest coordinate count as "
          "touching and are not cut; 0 cuts every overlap. Default: 2^-28")
      ->type_name("SHARE");
}

ReadResult merge(std::vector<ReadResult> parts) {
  for (const ReadResult& part : parts)
    if (parts.size() > 1 && !part.environment.separation.empty())
      throw UsageError("scene \"" + part.environment.name +
                       "\" brings a separation table, which orders its own objects alone; prepare "
                       "it by itself");
  ReadResult whole = std::move(parts.front());
  for (std::size_t i = 1; i < parts.size(); ++i) {
    append(whole.environment, std::move(parts[i].environment));
    append(whole.notices, parts[i].notices);
  }
  return whole;
}

Database prepare_scene(const ReadResult& scene, const std::string& name,
                       const PreparationChoices& choices) {
  Progress progress("preparing");
  PrepareOptions options;
  options.file = name;
  options.sun = choices.sun;
  if (choices.contact_tolerance) options.contact_tolerance = *choices.contact_tolerance;
  options.most_detailed = choices.most_detailed;
  options.progress = [&](double share) { progress.show(share); };
  Database database = prepare(scene.environment, options);
  std::vector<Notice> notices = scene.notices;
  append(notices, database.report.notices);
  database.report.notices = std::move(notices);
  return database;
}

LoadedScene load_scene(const std::optional<std::filesystem::path>& file,
                       const PreparationChoices& choices) {
  if (!file) {
    const std::string_view airfield = embedded_text(embedded_scenes(), "airfield.json");
    return prepared(kBuiltInScene, parse_json(airfield, kBuiltInScene), choices);
  }
  if (!is_database(*file)) return prepared(file->string(), read_environment(*file), choices);
  if (choices.sun)
    throw UsageError("--sun: " + file->string() +
                     " is prepared and its shades are fixed; prepare the scene with this sun");
  if (choices.contact_tolerance)
    throw UsageError("--contact-tolerance: " + file->string() +
                     " is prepared already; prepare the scene with this tolerance");
  return {file->string(), read_database(*file), std::nullopt};
}

}  // namespace cigsim
