// SPDX-License-Identifier: MIT
#include "models/machine/description_json.hpp"

#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "models/environment/document_value.hpp"
#include "models/environment/emitter.hpp"
#include "models/environment/text_file.hpp"
#include "models/machine/figures.hpp"

namespace cigsim {
namespace {

constexpr std::string_view kFormat = "cigsim-machine";

std::string decimal(double value) {
  std::ostringstream text;
  text.precision(15);
  text << value;
  return text.str();
}

Standing read_standing(const DocumentValue& value) {
  const std::string& text = value.text("a standing");
  for (const Standing standing :
       {Standing::kPublished, Standing::kRecalled, Standing::kDerived, Standing::kReconstruction})
    if (name_of(standing) == text) return standing;
  value.fail("there is no standing \"" + text +
             "\"; choose from published, recalled, derived, reconstruction");
}

double read_number(const DocumentValue& value, const FigureKind& kind) {
  const double number = value.number(kind.name);
  const bool whole = kind.fraction || number == std::floor(number);
  if (!whole || !(number >= kind.low && number <= kind.high) ||
      (kind.even && std::fmod(number, 2) != 0))
    value.fail(std::string(kind.name) + " is " + decimal(number) + "; it must be " +
               (kind.fraction ? "a number"
                : kind.even   ? "an even number"
                              : "a whole number") +
               " from " + decimal(kind.low) + " to " + decimal(kind.high) + " (" + kind.unit + ")");
  return number;
}

class MachineReader {
 public:
  explicit MachineReader(const Document& document) : root_(document, 0) {}

  MachineDescription read() {
    check_format();
    const DocumentMembers members(root_, "the machine",
                                  {"format", "version", "name", "title", "figures"});
    machine_.name = members.get("name").text("a name");
    if (machine_.name.empty()) members.get("name").fail("the machine's name is empty; give it one");
    machine_.title = members.get("title").text("a title");
    const DocumentValue figures = members.get("figures");
    for_each_figure(machine_, [&](const FigureKind& kind, const auto&) {
      const std::string_view name = kind.name;
      if (const std::size_t dot = name.find('.'); dot != name.npos)
        groups_.emplace(name.substr(0, dot));
    });
    read_figures(figures, "", "figures");
    for_each_figure(machine_, [&](const FigureKind& kind, const auto&) {
      if (!machine_.provenance.contains(kind.name))
        figures.fail("figure " + std::string(kind.name) +
                     " is missing; add it with its value, standing and source");
    });
    if (const std::string fault = machine_contradiction(machine_); !fault.empty())
      figures.fail(fault);
    return std::move(machine_);
  }

 private:
  void check_format() const {
    root_.require(Document::Kind::object, "the machine");
    std::optional<DocumentValue> format, version;
    root_.for_each_member("the machine", [&](const std::string& key, const DocumentValue&,
                                             const DocumentValue& value) {
      if (key == "format") format = value;
      if (key == "version") version = value;
    });
    if (!format || format->kind() != Document::Kind::string || format->text("format") != kFormat)
      (format ? *format : root_)
          .fail(
              "is no machine description; begin with {\"format\": \"cigsim-machine\", "
              "\"version\": 1, ... or copy one: cigsim machines asupt1975 --json");
    if (!version || version->kind() != Document::Kind::whole ||
        version->whole("version", UINT64_MAX) != 1)
      (version ? *version : root_)
          .fail("this version of the machine format is unknown; this program reads \"version\": 1");
  }

  void read_figures(const DocumentValue& value, const std::string& group, std::string_view what) {
    value.for_each_member(
        what, [&](const std::string& key, const DocumentValue& place, const DocumentValue& figure) {
          if (group.empty() && groups_.contains(key)) {
            read_figures(figure, key + ".", key);
            return;
          }
          read_figure(group + key, place, figure);
        });
  }

  void read_figure(const std::string& name, const DocumentValue& place,
                   const DocumentValue& figure) {
    bool known = false;
    for_each_figure(machine_, [&](const FigureKind& kind, auto& field) {
      if (kind.name != name) return;
      known = true;
      const DocumentMembers members(figure, name, {"value", "standing", "source"});
      field = static_cast<std::remove_reference_t<decltype(field)>>(
          read_number(members.get("value"), kind));
      const std::string& source = members.get("source").text("a source");
      if (source.empty())
        members.get("source").fail("the source of " + name + " is empty; name it");
      if (!machine_.provenance.insert({name, {read_standing(members.get("standing")), source}})
               .second)
        place.fail("figure " + name + " stands twice; keep one of them");
    });
    if (!known)
      place.fail("there is no figure \"" + name +
                 "\"; the figures are those of cigsim machines asupt1975");
  }

  DocumentValue root_;
  MachineDescription machine_;
  std::set<std::string, std::less<>> groups_;
};

}  // namespace

MachineDescription parse_machine(std::string_view text, const std::string& file) {
  const Document document = Document::from_json(text, file);
  return MachineReader(document).read();
}

MachineDescription load_machine(const std::string& preset_or_file) {
  for (const std::string& preset : machine_presets())
    if (preset == preset_or_file) return machine_preset(preset);
  if (!std::filesystem::exists(preset_or_file))
    throw InputError(preset_or_file, 0,
                     "is neither a preset nor a file; cigsim machines lists the presets");
  return parse_machine(read_whole_file(preset_or_file), preset_or_file);
}

std::string machine_json(const MachineDescription& machine) {
  std::ostringstream text;
  const auto out = make_json_emitter(text);
  out->begin_object(5, Layout::lines);
  out->key("format");
  out->text(kFormat);
  out->key("version");
  out->whole(1);
  out->key("name");
  out->text(machine.name);
  out->key("title");
  out->text(machine.title);
  out->key("figures");
  out->begin_object(0, Layout::lines);
  std::string open;
  for (const MachineFigure& figure : machine_figures(machine)) {
    const std::size_t dot = figure.name.find('.');
    const std::string group = dot == std::string::npos ? "" : figure.name.substr(0, dot);
    if (group != open) {
      if (!open.empty()) out->end();
      open = group;
      if (!group.empty()) {
        out->key(group);
        out->begin_object(0, Layout::lines);
      }
    }
    out->key(dot == std::string::npos ? figure.name : figure.name.substr(dot + 1));
    out->begin_object(3, Layout::one_line);
    out->key("value");
    out->number(figure.value);
    out->key("standing");
    out->text(name_of(figure.provenance.standing));
    out->key("source");
    out->text(figure.provenance.source);
    out->end();
  }
  if (!open.empty()) out->end();
  out->end();
  out->end();
  return text.str();
}

}  // namespace cigsim
