// SPDX-License-Identifier: MIT
#include "sim/report/report.hpp"

#include "models/environment/input_error.hpp"
#include "models/environment/write.hpp"
#include "sim/report/experiment_section.hpp"
#include "sim/report/page.hpp"
#include "sim/stats.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

void append(std::vector<std::string>& notes, const Json& more) {
  for (const Json& note : more) notes.push_back(note.get<std::string>());
}

// What was found instead, in brackets.
std::string words_of(const std::vector<std::string>& notes) {
  std::string words;
  for (const std::string& note : notes) words += (words.empty() ? " (" : "; ") + note;
  return words.empty() ? words : words + ")";
}

// What the page is about: the scene, the experiment or else the folder.
std::string title_of(const Json& data, const std::filesystem::path& folder) {
  if (!data["run"].is_null()) return data["run"]["scene"].get<std::string>();
  if (const Json& all = data["experiments"]["experiments"]; all.size() == 1)
    if (const Json& name = all[0]["figures"]["experiment"]; name.is_string())
      return name.get<std::string>();
  return folder.string();
}

}  // namespace

Report write_report(const ReportOptions& options) {
  const std::filesystem::path& folder = options.folder;
  if (!std::filesystem::is_directory(folder))
    throw InputError(folder.string(), 0,
                     "is no folder; name the one that a run or an experiment wrote");
  Report report;
  Json data{{"cigsim", version()}, {"run", nullptr}};
  const std::filesystem::path stats = folder / "stats.json";
  if (std::filesystem::exists(stats)) {
    const RecordedRun run = read_recorded_run(stats);
    data["run"] = run_section(run, folder, options.run);
    report.frames = data["run"]["shown"].size();
    report.frames_of = run.frames.size();
    append(report.notes, data["run"]["notes"]);
  }
  data["experiments"] = experiment_section(folder);
  report.experiments = data["experiments"]["experiments"].size();
  report.drawings = data["experiments"]["drawings"].size();
  append(report.notes, data["experiments"]["notes"]);
  if (data["run"].is_null() && report.experiments + report.drawings == 0)
    throw InputError(
        folder.string(), 0,
        "holds neither a run nor an experiment; write one with --out, then its report" +
            words_of(report.notes));
  data["title"] = title_of(data, folder);
  const std::string page = report_page(data["title"].get<std::string>(), data);
  report.bytes = page.size();
  write_file(options.file, page);
  return report;
}

}  // namespace cigsim
