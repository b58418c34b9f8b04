// SPDX-License-Identifier: MIT
#include "sim/gates/synthesis.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include "models/environment/text_file.hpp"
#include "models/environment/write.hpp"
#include "sim/arguments.hpp"
#include "sim/gates/parts.hpp"
#include "sim/program_pipe.hpp"
#include "sim/rtl/sources.hpp"

namespace cigsim::gates {
namespace {

namespace fs = std::filesystem;

// Modules of other stages, and those that the circuit does not use, are read and left out again.
std::string script(const Circuit& circuit) {
  std::string sources, parameters;
  for (const EmbeddedFile& file : embedded_rtl()) {
    const bool wanted = file.path.starts_with("rtl/common/") ||
                        file.path.starts_with(fmt::format("rtl/{}/", circuit.stage));
    if (wanted && file.path.ends_with(".sv")) sources += fmt::format(" {}", file.path);
  }
  for (const auto& [name, value] : circuit.parameters)
    parameters += fmt::format(" -set {} {}", name, value);
  const std::string& top = circuit.module;
  return fmt::format("read_verilog -sv -I.{}\n", sources) +
         (parameters.empty() ? "" : fmt::format("chparam{} {}\n", parameters, top)) +
         fmt::format(
             "hierarchy -check -top {}\n"
             "delete -port {}/o:mon_*\n"
             "proc\n",
             top, top) +
         (circuit.keep_modules ? "" : "flatten\n") +
         "opt -full\n"
         "memory -nomap\n"
         "memory_map t:$mem_v2 r:WR_PORTS>1 %i\n"
         "memory_map t:$mem_v2 r:RD_PORTS>2 %i\n"
         "opt -full\n"
         "techmap\n"
         "opt -full\n"
         "dfflegalize -cell $_DFF_P_ x\n"
         "opt -full -nodffe -nosdff\n"
         "abc -genlib parts.genlib -script +strash;dch;map\n"
         "opt_clean -purge\n"
         "write_json netlist.json\n";
}

}  // namespace

Synthesis::Synthesis() {
  if (!has_program("yosys")) throw UsageError("yosys is not installed; apt-get install yosys");
  std::string name = (fs::temp_directory_path() / "cigsim-gates-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(
        fmt::format("no folder can be made in {}", fs::temp_directory_path().string()));
  folder_ = name;
  write_rtl_sources(folder_);
  write_file(folder_ / "parts.genlib", genlib());
}

Synthesis::~Synthesis() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Netlist Synthesis::map(const Circuit& circuit) const {
  write_file(folder_ / "map.ys", script(circuit));
  Pipe yosys({"sh", "-c", "cd \"$1\" && exec yosys -q -s map.ys 2>&1", "sh", folder_.string()},
             Pipe::End::kReads);
  std::string said;
  char line[256];
  while (std::fgets(line, sizeof line, yosys.file()) != nullptr)
    if (said.size() < 1000) said += line;
  if (!yosys.finish())
    throw std::runtime_error(fmt::format("yosys cannot map {}: {}", circuit.module, said));
  return Netlist(read_whole_file((folder_ / "netlist.json").string()));
}

}  // namespace cigsim::gates
