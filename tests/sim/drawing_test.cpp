// SPDX-License-Identifier: MIT
// SVG drawings and plots: well-formed files with every thing in them, whatever the words and
// figures.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "models/environment/input_error.hpp"
#include "sim/drawing/gnuplot.hpp"
#include "sim/drawing/heat_map.hpp"
#include "sim/drawing/plot.hpp"
#include "sim/drawing/svg.hpp"
#include "sim/markup.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

namespace fs = std::filesystem;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

class PlotFile : public ::testing::Test {
 protected:
  const test::Scratch scratch_;
};

TEST(SvgDrawing, HoldsItsPartsAndEscapesWords) {
  SvgDrawing drawing(200, 100, "a < b");
  drawing.line({1, 2}, {3.25, 4}, {.stroke = "#ff0000", .width = 2, .dash = "4 3"});
  const Vec2 corners[] = {{0, 0}, {10, 0}, {0, 10}};
  drawing.polygon(corners, {.fill = "#00ff00"});
  drawing.circle({50, 50}, 5, {});
  drawing.text({10, 20}, "\"S&P\"\n<1>", 12, SvgAnchor::kMiddle);
  const std::string svg = drawing.svg();
  EXPECT_NE(svg.find("<title>a &lt; b</title>"), std::string::npos);
  EXPECT_NE(svg.find("x2=\"3.25\" y2=\"4\" stroke=\"#ff0000\" stroke-width=\"2\" fill=\"none\" "
                     "stroke-dasharray=\"4 3\""),
            std::string::npos);
  EXPECT_NE(svg.find("points=\"0,0 10,0 0,10 \""), std::string::npos);
  EXPECT_NE(svg.find(">&quot;S&amp;P&quot; &lt;1&gt;</text>"), std::string::npos);
  EXPECT_EQ(count_of(svg, "<circle"), 1u);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST_F(PlotFile, DrawsEveryCurveOfEveryPlot) {
  Plot powers{.title = "It's a 'power' law",
              .x_label = "n",
              .y_label = "n^2",
              .log_x = true,
              .log_y = true,
              .notes = {"y = x^2"},
              .curves = {}};
  powers.curves.push_back({"squares", {{1, 1}, {10, 100}, {100, 1e4}}});
  powers.curves.push_back({"bars", {{1, 2}, {10, 3}}, CurveStyle::kBars});
  const Plot linear{.title = "second",
                    .x_label = "",
                    .y_label = "",
                    .curves = {{"marks", {{-1, 2}, {0, 3}}, CurveStyle::kMarks}}};
  const fs::path file = scratch_.path("two.svg");
  draw_by_gnuplot(plot_script({powers, linear}, 2), file);
  const std::string svg = test::bytes_of(file);
  for (const char* words : {"It's a 'power' law", "n^2", "y = x^2", "squares", "bars", "second"})
    EXPECT_TRUE(svg.find(words) != std::string::npos ||
                svg.find(markup_escaped(words)) != std::string::npos)
        << words;
  EXPECT_TRUE(svg.find("width=\"960\" height=\"360\"") != std::string::npos);
  EXPECT_TRUE(svg.find("</svg>") != std::string::npos);
}

TEST_F(PlotFile, LeavesOutWhatAnAxisCannotShow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Plot nothing{.title = "none",
                     .x_label = "",
                     .y_label = "",
                     .log_y = true,
                     .curves = {{"a", {{1, 0}, {2, -1}, {nan, 1}}}, {"b", {}}}};
  const fs::path file = scratch_.path("none.svg");
  draw_by_gnuplot(plot_script({nothing}, 1), file);
  EXPECT_NE(test::bytes_of(file).find("nothing to draw"), std::string::npos);
}

TEST_F(PlotFile, MarksAFrontAndNamesItsPoints) {
  const Plot plot{.title = "front",
                  .log_x = true,
                  .curves = {{.label = "Pareto front",
                              .points = {{1, 3}, {2, 1}, {0, 9}},
                              .style = CurveStyle::kFront,
                              .names = {"a \"quoted\" name", "second", "cannot be drawn"}}}};
  const fs::path file = scratch_.path("front.svg");
  draw_by_gnuplot(plot_script({plot}, 1, {.width = 800, .height = 500}), file);
  const std::string svg = test::bytes_of(file);
  for (const char* words : {"a \"quoted\" name", "second", "Pareto front"})
    EXPECT_TRUE(svg.find(words) != std::string::npos ||
                svg.find(markup_escaped(words)) != std::string::npos)
        << words;
  EXPECT_EQ(svg.find("cannot be drawn"), std::string::npos);
  EXPECT_NE(svg.find("width=\"800\" height=\"500\""), std::string::npos);
}

TEST_F(PlotFile, RowsHaveNamesAndCurvesTheirColours) {
  const Plot plot{.title = "rows",
                  .log_x = true,
                  .rows = {"functional", "rtl"},
                  .curves = {{.label = "levels",
                              .points = {{0.5, 0}, {400, 1}},
                              .style = CurveStyle::kMarks,
                              .names = {"0.5 ms", "400 ms"},
                              .colour = "#123456",
                              .mark = Mark::kDiamond}}};
  const fs::path file = scratch_.path("rows.svg");
  draw_by_gnuplot(plot_script({plot}, 1), file);
  const std::string svg = test::bytes_of(file);
  for (const char* words : {"functional", "rtl", "0.5 ms", "400 ms", "levels"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_TRUE(svg.find("#123456") != std::string::npos ||
              svg.find("rgb( 18,  52,  86)") != std::string::npos);
}

TEST(PlotScript, ABoundHasTheColourOfItsCurveInEveryPlot) {
  const Plot plot{.title = "t",
                  .curves = {{"a", {{1, 1}, {2, 2}}},
                             {"a, bound", {{1, 2}, {2, 3}}, CurveStyle::kBound},
                             {"b", {{1, 1}, {2, 2}}}}};
  const std::string script = plot_script({plot}, 1);
  const std::string first = script.substr(script.find("lc rgb '", script.find("\nplot ")), 16);
  EXPECT_EQ(count_of(script, first), 2u) << first;
}

TEST_F(PlotFile, AHeatMapHasACellAValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const HeatMap map{.title = "wrong decisions",
                    .x_label = "scale",
                    .y_label = "decision",
                    .columns = {"1e-12", "1", "1e12"},
                    .rows = {"side", "clip"},
                    .values = {0.25, 0, 1, nan, 0.5, 0.125},
                    .notes = {"seed 1"}};
  const fs::path file = scratch_.path("map.svg");
  draw_by_gnuplot(heat_map_script({map, HeatMap{.title = "empty"}}, 2), file);
  const std::string svg = test::bytes_of(file);
  for (const char* words : {"1e-12", "1e12", "side", "clip", "0.25", "0.125", "seed 1",
                            "wrong decisions", "nothing to draw"})
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  EXPECT_TRUE(svg.find("NaN") == std::string::npos && svg.find("nan") == std::string::npos);
  EXPECT_THROW(heat_map_script({HeatMap{.columns = {"b"}, .rows = {"a"}}}, 1),
               std::invalid_argument);
}

TEST_F(PlotFile, MissingFolderLeavesNothing) {
  const Plot plot{.title = "t", .x_label = "", .y_label = "", .curves = {{"a", {{1, 1}, {2, 2}}}}};
  EXPECT_THROW(draw_by_gnuplot(plot_script({plot}, 1), scratch_.path("missing/a.svg")), InputError);
  EXPECT_EQ(scratch_.files(), 0u);
}

TEST_F(PlotFile, WithoutGnuplotThePackageIsNamed) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", scratch_.folder().c_str(), 1);
  EXPECT_FALSE(can_plot());
  try {
    draw_by_gnuplot(plot_script({}, 1), scratch_.path("a.svg"));
    ADD_FAILURE() << "drawn";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot-nox"), std::string::npos);
  }
  ::setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace cigsim
