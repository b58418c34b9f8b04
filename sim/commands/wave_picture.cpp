// SPDX-License-Identifier: MIT
// cigsim wave-picture: a window of a wave file as a picture for documents.
#include "sim/wave/wave_picture.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/commands/commands.hpp"
#include "sim/wave/signal_names.hpp"
#include "sim/wave/value_names.hpp"
#include "sim/wave/wave_file.hpp"

namespace cigsim {
namespace {

constexpr std::size_t kMostSignals = 100;  // of a file that is shown whole
constexpr double kLongest = 1e15;          // ns or cycles
constexpr double kShortestCycle = 1e-3;    // ns
constexpr int kNarrowest = 400, kWidest = 10000;

struct Options {
  std::string file, output;
  std::optional<std::string> view;
  std::vector<std::string> signals;
  std::optional<double> from, to;
  bool cycles = false;
  WavePictureOptions picture;
};

// What is shown, with places in the file instead of in a wave.
struct Choice {
  std::vector<WavePictureRow> rows;
  std::vector<std::size_t> signals;

  void add(std::size_t signal, std::string label, Radix radix,
           std::shared_ptr<const ValueNames> names = nullptr) {
    rows.push_back(
        {ViewRow::Kind::kSignal, std::move(label), radix, signals.size(), std::move(names)});
    signals.push_back(signal);
  }
};

// The names of a row's values; their file is named from the view's folder.
std::shared_ptr<const ValueNames> names_of(const ViewRow& row, const std::string& view) {
  if (row.names.empty()) return nullptr;
  const std::filesystem::path file = std::filesystem::path(view).parent_path() / row.names;
  return std::make_shared<ValueNames>(ValueNames::parse(read_whole_file(file), file.string()));
}

void add_view(const WaveFile& file, const std::string& view, Choice& choice) {
  const SignalNames names(file.signals());
  for (const ViewRow& row : parse_saved_view(read_whole_file(view), view)) {
    if (row.kind != ViewRow::Kind::kSignal) {
      choice.rows.push_back({row.kind, row.text, row.radix, 0});
      continue;
    }
    try {
      choice.add(names.find(row.text), row.label, row.radix, names_of(row, view));
    } catch (const std::invalid_argument& error) {
      throw InputError(view, row.line, fmt::format("{}: {}", file.name(), error.what()));
    }
  }
}

// NAME or NAME=RADIX.
void add_signal(const WaveFile& file, const std::string& text, Choice& choice) {
  const std::size_t equals = text.rfind('=');
  const Radix radix = equals == std::string::npos
                          ? Radix::kHexadecimal
                          : parse_radix("--signal", text.substr(equals + 1));
  try {
    choice.add(SignalNames(file.signals()).find(text.substr(0, equals)), "", radix);
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("--signal: {}: {}", file.name(), error.what()));
  }
}

// All signals under the names of their scopes.
void add_all(const WaveFile& file, Choice& choice) {
  if (file.signals().size() > kMostSignals)
    throw UsageError(fmt::format("{} has {} signals; choose some with --view or --signal",
                                 file.name(), file.signals().size()));
  std::string scope;
  for (std::size_t i = 0; i < file.signals().size(); ++i) {
    const std::string& name = file.signals()[i].name;
    const std::size_t dot = name.rfind('.');
    if (dot != std::string::npos && name.compare(0, dot, scope) != 0) {
      scope = name.substr(0, dot);
      choice.rows.push_back({ViewRow::Kind::kHeading, scope, Radix::kHexadecimal, 0});
    }
    choice.add(i, name.substr(dot + 1), Radix::kHexadecimal);
  }
}

// Signals that have no label yet are called by what tells them apart.
void label(const WaveFile& file, Choice& choice) {
  std::vector<std::string> names;
  for (const std::size_t signal : choice.signals) names.push_back(file.signals()[signal].name);
  const std::vector<std::string> labels = short_names(names);
  for (WavePictureRow& row : choice.rows)
    if (row.kind == ViewRow::Kind::kSignal && row.label.empty()) row.label = labels[row.trace];
}

int draw(const Options& options) {
  check_ending("--output", options.output, {"svg"});
  const double unit = options.cycles ? options.picture.cycle_ns : 1;
  WaveWindow window;
  if (options.from) window.from = *options.from * unit;
  if (options.to) window.to = *options.to * unit;
  if (window.to && *window.to <= window.from.value_or(0))
    throw UsageError("--to: the window must end after it begins");
  WaveFile file(options.file);
  Choice choice;
  if (options.view) add_view(file, *options.view, choice);
  for (const std::string& signal : options.signals) add_signal(file, signal, choice);
  if (!options.view && options.signals.empty()) add_all(file, choice);
  label(file, choice);
  const Wave wave = file.read(choice.signals, window);
  if (wave.first == wave.last)
    throw InputError(file.name(), 0, "has a single time in the window; make it longer");
  write_file(options.output, wave_picture(wave, choice.rows, options.picture));
  return 0;
}

void add_window_options(CLI::App& command, Options& o) {
  const auto time = [&](const char* name, std::optional<double>& value, const char* text) {
    command
        .add_option_function<std::string>(
            name,
            [name, &value](const std::string& t) { value = parse_number(name, t, 0, kLongest); },
            text)
        ->type_name("T");
  };
  time("--from", o.from, "Begin of the window in ns. Default: that of the file");
  time("--to", o.to, "End of the window in ns. Default: that of the file");
  command.add_flag("--cycles", o.cycles, "--from and --to are cycles: the times they begin");
  command
      .add_option_function<std::string>(
          "--cycle-ns",
          [&o](const std::string& t) {
            o.picture.cycle_ns = parse_number("--cycle-ns", t, kShortestCycle, kLongest);
          },
          "Length of a cycle. Default: 125")
      ->type_name("NS");
}

}  // namespace

void add_wave_picture(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("wave-picture", "Draw a window of a wave file as an SVG picture");
  command->footer(
      "Examples:\n"
      "  cigsim wave-picture wave.vcd --view wave.gtkw --from 1000 --to 5000 -o wave.svg\n"
      "  cigsim wave-picture wave.fst --cycles --from 80 --to 120 -o wave.svg \\\n"
      "      --signal clock --signal priority_resolver.at=dec\n");
  Options& o = *options;
  command->add_option("FILE", o.file, "Wave file, .vcd or .fst")->type_name("")->required();
  command
      ->add_option("--view", o.view,
                   "Saved view of GTKWave: signals, order, headings, radix, names of values")
      ->type_name("FILE");
  command
      ->add_option("--signal", o.signals,
                   "A signal, in hex or in RADIX: bin, oct, hex, dec, signed or text. The last "
                   "parts of its name do where they are unique. Any number of times; without "
                   "--view and --signal all signals are shown")
      ->type_name("NAME[=RADIX]")
      ->expected(1)
      ->take_all();
  add_window_options(*command, o);
  command
      ->add_option_function<std::string>(
          "--width",
          [&o](const std::string& t) {
            o.picture.width = static_cast<int>(parse_whole("--width", t, kNarrowest, kWidest));
          },
          "Width of the picture. Default: 1200")
      ->type_name("PIXELS");
  command->add_option("-o,--output", o.output, "The picture, .svg")->type_name("FILE")->required();
  command->callback([options, &exit_code] { exit_code = draw(*options); });
}

}  // namespace cigsim
