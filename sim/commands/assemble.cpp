// SPDX-License-Identifier: MIT
// cigsim assemble: a microprogram to words, as a listing and as an image for $readmemh.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "firmware/assembler/listing.hpp"
#include "firmware/programs.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"

namespace cigsim {
namespace {

struct Options {
  std::string program;
  std::optional<std::string> format, image, names;
  std::vector<std::string> constants;
  bool listing = false;
};

firmware::Overrides overrides(const std::vector<std::string>& constants) {
  firmware::Overrides values;
  for (const std::string& text : constants) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--define: '" + text + "' is not NAME=VALUE");
    const auto value = parse_whole("--define", text.substr(equals + 1), 0, 0xffff'ffff);
    if (!values.emplace(text.substr(0, equals), static_cast<std::int64_t>(value)).second)
      throw UsageError("--define: '" + text.substr(0, equals) + "' is given twice");
  }
  return values;
}

firmware::Program assembled(const Options& options) {
  const firmware::Overrides values = overrides(options.constants);
  const std::vector<std::string> stages = firmware::microcoded_stages();
  const bool stage = std::find(stages.begin(), stages.end(), options.program) != stages.end();
  if (stage && !options.format) return firmware::stage_program(options.program, values);
  if (!options.format)
    throw UsageError(fmt::format("'{}' is not one of the stages {}; for a file give --format too",
                                 options.program, fmt::join(stages, ", ")));
  const firmware::Format format =
      firmware::parse_format(*options.format, read_whole_file(*options.format));
  return firmware::assemble(format, options.program, read_whole_file(options.program), values);
}

int assemble(const Options& options) {
  const firmware::Program program = assembled(options);
  if (options.image) write_file(*options.image, firmware::hex_image(program));
  if (options.names) write_file(*options.names, firmware::address_names(program));
  if (options.listing)
    fmt::print("{}", firmware::listing(program));
  else
    fmt::print("{}: {} words of {} bits, {} costs\n", program.name, program.words.size(),
               program.format.width, program.costs.size());
  return 0;
}

}  // namespace

void add_assemble(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("assemble", "Assemble the microprogram of a stage, or of a file");
  command->footer(fmt::format(
      "Stages: {}\n\n"
      "Examples:\n"
      "  cigsim assemble priority_processor --listing    addresses, words, source, costs\n"
      "  cigsim assemble priority_processor -o pp.hex    the image that $readmemh reads\n"
      "  cigsim assemble my.mas --format my.fmt --define STEPS=12\n",
      fmt::join(firmware::microcoded_stages(), ", ")));
  command->add_option("PROGRAM", options->program, "A stage, or a file with a microprogram")
      ->required()
      ->type_name("");
  command
      ->add_option("--format", options->format,
                   "The format of the microinstructions. Default: the stage's own")
      ->type_name("FILE");
  command
      ->add_option("--define", options->constants,
                   "Another value for a constant of the program; may be given more than once")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  command->add_flag("--listing", options->listing, "Print addresses, words, source and costs");
  command->add_option("-o,--output", options->image, "Write the words in hex, one a line")
      ->type_name("FILE");
  command
      ->add_option("--names", options->names,
                   "Write the names of addresses: what GTKWave calls a translate filter file")
      ->type_name("FILE");
  command->callback([options, &exit_code] { exit_code = assemble(*options); });
}

}  // namespace cigsim
