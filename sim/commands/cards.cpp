// SPDX-License-Identifier: MIT
// cigsim cards: Pfister's program, with his function keys from a script or typed.
#include "models/environment/cards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "models/environment/input_error.hpp"
#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "models/hidden_line/galimberti_montanari.hpp"
#include "sim/arguments.hpp"
#include "sim/cards_screen.hpp"
#include "sim/commands/commands.hpp"
#include "sim/interrupt.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

namespace hl = hidden_line;
using Json = nlohmann::ordered_json;

constexpr std::uint64_t kMostFrames = 100000;

struct Options {
  std::string deck, folder = "out";
  std::optional<std::string> keys;
  std::optional<std::size_t> frames;
  bool live = false, as_published = false, json = false;
};

struct KeyPress {
  std::size_t frame = 0;  // of the animation, from 0
  int key = 0;
};

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line) {
    if (c == '#') break;
    if (c == ' ' || c == '\t' || c == '\r') {
      if (!word.empty()) words.push_back(std::move(word));
      word.clear();
    } else {
      word += c;
    }
  }
  if (!word.empty()) words.push_back(word);
  return words;
}

// A line KEY is for the next frame (0: no key), a line FRAME KEY for that one.
std::vector<KeyPress> read_keys(const std::string& file) {
  const std::string text = read_whole_file(file);
  std::vector<KeyPress> presses;
  std::size_t next = 0;
  int line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<std::string> words = words_of(std::string_view(text).substr(at, end - at));
    at = end + 1;
    ++line_number;
    if (words.empty()) continue;
    const auto number = [&](const std::string& word, std::size_t most) {
      double value = 0;
      if (!to_number(word, value) || value < 0 || value > static_cast<double>(most) ||
          value != static_cast<double>(static_cast<std::size_t>(value)))
        throw InputError(file, line_number,
                         fmt::format("\"{}\" is no whole number from 0 to {}; write KEY or FRAME "
                                     "KEY, with keys 2 to 14 or 0 for none",
                                     word, most));
      return static_cast<std::size_t>(value);
    };
    if (words.size() > 2)
      throw InputError(file, line_number, "more than two words; write KEY or FRAME KEY");
    const std::size_t frame = words.size() == 2 ? number(words[0], kMostFrames - 1) : next;
    const auto key = static_cast<int>(number(words.back(), 14));
    if (key == 1)
      throw InputError(file, line_number,
                       "key 1 only waits for the next key; leave it out, or write 0");
    presses.push_back({frame, key});
    next = frame + 1;
  }
  std::stable_sort(presses.begin(), presses.end(),
                   [](const KeyPress& a, const KeyPress& b) { return a.frame < b.frame; });
  return presses;
}

struct Drawing {
  CardsDeck deck;
  std::vector<hl::SolvedStructure> solved;
  std::vector<std::pair<std::uint32_t, CardsView>> frames;  // structure and view

  hl::HiddenEdges edges(std::uint32_t structure, const CardsView& view) const {
    return hl::hide(deck.structures[structure], solved[structure], view);
  }
};

Drawing prepare_drawing(const Options& options) {
  Drawing drawing;
  drawing.deck = read_cards_deck(options.deck);
  for (const CardsStructure& structure : drawing.deck.structures)
    drawing.solved.push_back(hl::solve(structure, options.deck));
  for (const CardsPlot& plot : drawing.deck.plots)
    drawing.frames.emplace_back(plot.structure, plot.view);
  if (drawing.frames.empty())
    throw InputError(options.deck, 0, "draws nothing; add 'VIEW DATA' and 'PLOT'");
  return drawing;
}

// After the deck's own pictures: each frame takes its keys, steps, and is drawn.
void add_animation(Drawing& drawing, const Options& options) {
  const std::vector<KeyPress> presses =
      options.keys ? read_keys(*options.keys) : std::vector<KeyPress>();
  const std::size_t count = options.frames.value_or(presses.empty() ? 0 : presses.back().frame + 1);
  auto [structure, view] = drawing.frames.back();
  std::size_t next = 0;
  for (std::size_t frame = 0; frame < count; ++frame) {
    for (; next < presses.size() && presses[next].frame == frame; ++next)
      hl::press(presses[next].key, view, options.as_published);
    hl::step(view, options.as_published);
    drawing.frames.emplace_back(structure, view);
  }
}

Json frame_json(const std::string& file, const CardsView& view, const hl::HiddenEdges& edges) {
  return {{"file", file},
          {"r", view.r + view.dr},
          {"d", view.d + view.dd},
          {"theta", view.theta},
          {"phi", view.phi},
          {"lines", edges.drawn.size()},
          {"dropped", edges.dropped},
          {"dropped_concave", edges.dropped_concave},
          {"behind_eye", edges.behind_eye},
          {"off_view_faces", edges.off_view_faces}};
}

Json structures_json(const Drawing& drawing) {
  Json out = Json::array();
  for (std::size_t s = 0; s < drawing.solved.size(); ++s) {
    const auto& edges = drawing.solved[s].edges;
    const auto concave = std::count_if(edges.begin(), edges.end(),
                                       [](const hl::SolvedEdge& e) { return e.concave; });
    out.push_back({{"vertices", drawing.deck.structures[s].vertices.size()},
                   {"faces", drawing.deck.structures[s].faces.size()},
                   {"edges", edges.size()},
                   {"concave_edges", concave}});
  }
  return out;
}

void print_summary(const Options& options, const Drawing& drawing, const Json& structures,
                   const Json& frames) {
  for (const std::string& report : drawing.deck.reports) fmt::print("{}\n", report);
  for (const Json& s : structures)
    fmt::print("structure: {} vertices, {} faces, {} edges, {} of them concave\n",
               s["vertices"].dump(), s["faces"].dump(), s["edges"].dump(),
               s["concave_edges"].dump());
  for (const Json& s : structures)
    if (s["concave_edges"] != 0) {
      fmt::print(
          "not convex: edges that other faces cover are drawn too; cigsim hidden-line {} "
          "leaves them out\n",
          options.deck);
      break;
    }
  const Json& last = frames.back();
  fmt::print("{} {} in {}; the last has {} lines, {} edges dropped, {} of them concave\n",
             frames.size(), frames.size() == 1 ? "picture" : "pictures", options.folder,
             last["lines"].dump(),
             last["dropped"].get<std::size_t>() + last["dropped_concave"].get<std::size_t>(),
             last["dropped_concave"].dump());
}

int write_frames(const Options& options) {
  Drawing drawing = prepare_drawing(options);
  add_animation(drawing, options);
  std::error_code error;
  std::filesystem::create_directories(options.folder, error);
  if (error)
    throw InputError(options.folder, 0,
                     "cannot be made: " + error.message() + "; name another folder");
  Json frames = Json::array();
  for (std::size_t f = 0; f < drawing.frames.size(); ++f) {
    const auto& [structure, view] = drawing.frames[f];
    const hl::HiddenEdges edges = drawing.edges(structure, view);
    const std::filesystem::path file =
        std::filesystem::path(options.folder) / fmt::format("frame-{:04}.svg", f);
    write_file(file, cards_svg(edges, fmt::format("{}, picture {}", options.deck, f)));
    frames.push_back(frame_json(file.string(), view, edges));
  }
  const Json structures = structures_json(drawing);
  if (options.json) {
    const Json all{{"deck", options.deck},
                   {"reports", drawing.deck.reports},
                   {"structures", structures},
                   {"frames", frames}};
    fmt::print("{}\n", dump(all));
  } else {
    print_summary(options, drawing, structures, frames);
  }
  return 0;
}

int live(const Options& options) {
  const Drawing drawing = prepare_drawing(options);
  auto [structure, view] = drawing.frames.back();
  const Interrupt interrupt;
  LiveTerminal terminal;
  std::string legend = LiveTerminal::legend();
  const int legend_lines = static_cast<int>(std::count(legend.begin(), legend.end(), '\n'));
  for (std::size_t frame = 0; interrupt.signal() == 0; ++frame) {
    if (options.frames && frame >= *options.frames) break;
    const int rows = std::max(4, terminal.rows() - legend_lines - 2);
    terminal.show(
        cards_dots(drawing.edges(structure, view), std::max(4, terminal.columns() - 1), rows),
        fmt::format("R {:.2f}  D {:.2f}  THETA {:.0f}  PHI {:.0f}\x1b[K\n{}", view.r + view.dr,
                    view.d + view.dd, view.theta, view.phi, legend));
    const int key = terminal.key(100);
    if (key == LiveTerminal::kQuit) break;
    hl::press(key, view, options.as_published);
    hl::step(view, options.as_published);
  }
  return 0;
}

}  // namespace

void add_cards(CLI::App& program, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "cards", "Run a deck of Pfister's hidden-line program, with its function keys");
  command->footer(
      "Keys: 3, 4, 5 turn theta by +2, -2, 0 degrees a picture; 6, 7, 8 phi; 9, 10, 11 move the\n"
      "eye by +0.25, -0.25, 0; 12, 13, 14 the view plane by +0.2, -0.2, 0; 2 stops all.\n\n"
      "Examples:\n"
      "  cigsim cards scenes/pfister-block.cards --out block\n"
      "  cigsim cards scenes/pfister-block.cards --keys turn.keys --frames 90\n"
      "  cigsim cards scenes/pfister-notch.cards --live\n");
  command->add_option("DECK", options->deck, "Deck of cards")->type_name("")->required();
  CLI::Option* keys =
      command
          ->add_option("--keys", options->keys,
                       "Script of keys: a line KEY for the next picture (0: none) or FRAME KEY; # "
                       "begins a remark")
          ->type_name("FILE");
  CLI::Option* live_option =
      command->add_flag("--live", options->live, "Draw in the terminal and type the keys");
  CLI::Option* out =
      command
          ->add_option("--out", options->folder, "Folder for frame-0000.svg and on. Default: out")
          ->type_name("DIR");
  command
      ->add_option_function<std::string>(
          "--frames",
          [options](const std::string& text) {
            options->frames = parse_whole("--frames", text, 0, kMostFrames);
          },
          "Pictures after the deck's own. Default: as many as the script has")
      ->type_name("N");
  command->add_flag("--as-published", options->as_published,
                    "Keys of distances move them once, as in the listing, instead of going on");
  CLI::Option* json = command->add_flag("--json", options->json, "Print what was drawn as JSON");
  live_option->excludes(keys)->excludes(out)->excludes(json);
  command->callback([options, &exit_code] {
    exit_code = options->live ? live(*options) : write_frames(*options);
  });
}

}  // namespace cigsim
