// SPDX-License-Identifier: MIT
#include "sim/separation_input.hpp"

#include "models/database/database_file.hpp"
#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "sim/arguments.hpp"

namespace cigsim {

bool is_deck(const std::filesystem::path& file) { return lower_ending(file) == "deck"; }

SeparationInput read_separation_input(const std::filesystem::path& file) {
  if (is_database(file))
    throw UsageError(file.string() +
                     " is prepared and has its planes; give the scene that it was made from");
  ReadResult read = read_environment(file);
  SeparationInput input{{}, std::move(read.environment), std::move(read.notices)};
  if (is_deck(file)) input.deck.planes = read_stump_deck(file).planes;
  for (std::size_t s = 1; s < input.scene.systems.size(); ++s)
    if (!input.scene.systems[s].motion.empty() ||
        !(input.scene.systems[s].placement == Placement{}))
      throw UsageError(file.string() + ": system \"" + input.scene.systems[s].name +
                       "\" is placed by itself or moves; separation planes need objects in the "
                       "environment's own axes");
  for (std::size_t o = 0; o < input.scene.objects.size(); ++o)
    if (input.scene.objects[o].faces.empty())
      throw InputError(file.string(), 0,
                       "object " + std::to_string(o + 1) + " has no faces; remove it");
  if (input.scene.objects.empty())
    throw InputError(file.string(), 0, "holds no object to separate; add one");
  if (input.scene.objects.size() > kMostSeparated)
    throw InputError(file.string(), 0,
                     "holds " + std::to_string(input.scene.objects.size()) + " objects; at most " +
                         std::to_string(kMostSeparated) +
                         " are separated whole, use cigsim prepare");
  input.deck.objects = input.scene.objects;
  return input;
}

}  // namespace cigsim
