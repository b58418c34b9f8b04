// SPDX-License-Identifier: MIT
// Starting gnuplot (Debian's package gnuplot-nox), which draws plots and heat maps as SVG.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cigsim {

/// Whether gnuplot is there.
bool can_plot();

/// Words as gnuplot's quoted string, as clean_words().
std::string gnuplot_quoted(std::string_view words);

/// The commands that begin a sheet of `count` drawings side by side in rows of `columns`, each of
/// the given size in pixels, as SVG on gnuplot's standard output; "unset multiplot" ends it.
std::string gnuplot_sheet(std::size_t count, int columns, int width, int height);

/// One drawing of a folder: the name of its file, and the commands that draw it.
struct Sheet {
  std::string name, script;
};

/// Draws `script` into `file`, whole or not at all. Throws InputError, naming the package, when
/// gnuplot is missing, and when it or the file system fails.
void draw_by_gnuplot(const std::string& script, const std::filesystem::path& file);

}  // namespace cigsim
