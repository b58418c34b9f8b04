// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "sim/markup.hpp"
#include "sim/path.hpp"
#include "sim/report/base64.hpp"
#include "sim/report/faces_json.hpp"
#include "sim/report/frame_repeat.hpp"
#include "sim/report/page.hpp"
#include "sim/report/spread.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;

TEST(Base64, OfTheVectorsOfRfc4648) {
  const char* cases[][2] = {{"", ""},
                            {"f", "Zg=="},
                            {"fo", "Zm8="},
                            {"foo", "Zm9v"},
                            {"foob", "Zm9vYg=="},
                            {"fooba", "Zm9vYmE="},
                            {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : cases) EXPECT_EQ(base64(bytes), text);
  EXPECT_EQ(base64(std::string("\0\xff\xfe", 3)), "AP/+");
  EXPECT_EQ(data_uri("image/png", "foo"), "data:image/png;base64,Zm9v");
}

TEST(Page, DataCannotBreakOutOfTheScript) {
  const std::string words =
      "</script><!--<script>&\"'\\ \xe2\x80\xa8\xe2\x80\xa9 {{style}} \xc3\xa4";
  const Json data{{"title", words}, {words, 1}};
  const std::string text = script_json(data);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(text.find("\xe2\x80"), std::string::npos);
  EXPECT_EQ(Json::parse(text), data);
  const std::string page = report_page(words, data);
  EXPECT_NE(page.find(text), std::string::npos);
  EXPECT_NE(page.find("<title>" + markup_escaped(words) + " "), std::string::npos);
}

TEST(Page, BytesThatAreNotTextDoNotStopIt) {
  EXPECT_NE(script_json({{"name", "\xff"}}).find("name"), std::string::npos);
}

TEST(Page, NamesNothingOutsideItself) {
  const std::string page = report_page("t", Json::object());
  for (const char* words : {"http:", "https:", "src=\"", "@import", "url("}) {
    // The name of SVG's elements is no address that is asked.
    std::string rest = page;
    const std::string svg = "http://www.w3.org/2000/svg";
    rest.replace(rest.find(svg), svg.size(), "");
    EXPECT_EQ(rest.find(words), std::string::npos) << words;
  }
}

TEST(SpreadEvenly, FromTheFirstToTheLast) {
  EXPECT_EQ(spread_evenly(3, 12), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(spread_evenly(100, 4), (std::vector<std::size_t>{0, 33, 66, 99}));
  EXPECT_EQ(spread_evenly(100, 1), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(spread_evenly(0, 5).empty());
}

TEST(ReadIds, RefusesWhatIsNoPictureOfNumbers) {
  const test::Scratch scratch;
  const auto message = [&](const std::string& bytes) {
    return test::message_of([&] { read_ids(scratch.write("ids", bytes), {2, 1}); });
  };
  EXPECT_EQ(read_ids(scratch.write("ids", std::string("P5\n2 1\n65535\n\0\1\2\3", 17)), {2, 1}),
            (std::vector<std::uint16_t>{1, 0x203}));
  for (const std::string& bytes :
       {std::string("P5\n2 1\n65535\nabc"), std::string("P5\n2 1\n65535\nabcde"),
        std::string("P5\n1 2\n65535\nabcd"), std::string("P6")})
    EXPECT_NE(message(bytes).find("holds no 2 x 1"), std::string::npos) << message(bytes);
  EXPECT_NE(message("").find("empty"), std::string::npos);
}

TEST(DifferencePicture, TellsObjectsFromColours) {
  Picture a;
  a.fit({3, 1});
  a.colours = {0xff000000, 0xff0000ff, 0xffffffff};
  a.numbers = {1, 1, 2};
  Picture b = a;
  b.numbers[0] = 7;
  b.colours[1] = 0xff00ff00;
  const Picture out = difference_picture(a, b);
  EXPECT_EQ(out.colours[0], 0xff3d26d7u);
  EXPECT_EQ(out.colours[1], 0xff3aa3f2u);
  EXPECT_EQ(out.colours[2] & 0xff, out.colours[2] >> 16 & 0xff);  // grey
}

// The rule as the page has it, worked out from its data alone.
struct PageRule {
  Json faces, limits;
  int width;

  int element(const Json& edge, int line) const {
    if (edge.size() > 5)
      for (std::size_t i = 0; i < edge[5].size(); i += 2)
        if (edge[5][i] == line) return edge[5][i + 1].get<int>();
    const double at = edge[3].get<double>() + edge[4].get<double>() * (line - edge[0].get<int>());
    return static_cast<int>(std::clamp(std::ceil(at), 0.0, static_cast<double>(width)));
  }

  // Elements of each line and what they show.
  std::vector<std::uint16_t> numbers(int height) const {
    std::vector<std::uint16_t> out(static_cast<std::size_t>(width) *
                                   static_cast<std::size_t>(height));
    std::vector<std::uint32_t> face_limit(static_cast<std::size_t>(height), kNone);
    std::vector<int> element_limit(static_cast<std::size_t>(height), width);
    for (const Json& limit : limits) {
      const auto line = limit[0].get<std::size_t>();
      if (!limit[1].is_null()) face_limit[line] = limit[1].get<std::uint32_t>();
      if (!limit[2].is_null()) element_limit[line] = limit[2].get<int>();
    }
    for (std::size_t f = faces.size(); f-- > 0;) {  // each over those of lower priority
      std::vector<int> from(static_cast<std::size_t>(height), 0), to(from);
      for (const Json& edge : faces[f][2])
        for (int r = edge[0].get<int>(); r < edge[1].get<int>(); ++r)
          (edge[2] == 1 ? from : to)[static_cast<std::size_t>(r)] = element(edge, r);
      for (std::size_t r = 0; r < from.size(); ++r)
        for (int c = from[r]; c < std::min(to[r], element_limit[r]) && f < face_limit[r]; ++c)
          out[r * static_cast<std::size_t>(width) + static_cast<std::size_t>(c)] =
              faces[f][0].get<std::uint16_t>();
    }
    return out;
  }
};

struct Case {
  const char* name;
  NumberType number;
  std::uint32_t crossings = 0;  // of a line; 0: no limit
  OverloadPolicy policy = OverloadPolicy::kDrop;
};

class ShownFaces : public testing::TestWithParam<Case> {};

MachineOptions options_of(const Case& chosen, const Raster& raster) {
  MachineOptions options;
  options.number = chosen.number;
  options.raster = raster;
  if (chosen.number != NumberType::kMachine) return options;
  options.description = with_raster(machine_preset("unlimited"), raster);
  options.description.crossing_capacity = chosen.crossings;
  options.overload = chosen.policy;
  options.resolver = ResolverMethod::kActiveList;
  return options;
}

// The machine's own resolver is the oracle; the machine never sees the page's data.
TEST_P(ShownFaces, AreThoseOfThePictureByThePagesRule) {
  const LoadedScene scene = load_scene(std::nullopt, {});
  const Raster raster{157, 118};
  const MachineOptions options = options_of(GetParam(), raster);
  FunctionalMachine machine(scene.database, options);
  ViewOptions view;
  view.path = "builtin";
  view.frames = 5;
  std::size_t limited = 0;
  for (const FrameView& at : frame_views(view, load_path(view), scene.database)) {
    SCOPED_TRACE(at.position);
    const Picture& picture = machine.compute(at.viewpoint, at.position);
    const FrameFaces faces = machine.faces();
    const auto limits = line_limits(faces, raster.height, GetParam().crossings, GetParam().policy);
    const Picture shown = shown_picture(faces, limits, scene.database.background, raster);
    EXPECT_EQ(shown.numbers, picture.numbers);
    EXPECT_EQ(shown.colours, picture.colours);
    const PageRule rule{faces_json(faces, raster.width), limits_json(limits), raster.width};
    EXPECT_EQ(rule.numbers(raster.height), picture.numbers);
    limited += rule.limits.size();
    const auto crossings = crossings_by_line(faces, raster.height);
    EXPECT_EQ(std::accumulate(crossings.begin(), crossings.end(), std::uint64_t{0}),
              machine.stats().crossings);
    EXPECT_EQ(*std::max_element(crossings.begin(), crossings.end()),
              machine.stats().worst_line_crossings);
  }
  EXPECT_EQ(limited > 0, GetParam().crossings > 0);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, ShownFaces,
    testing::Values(Case{"float", NumberType::kFloat}, Case{"double", NumberType::kDouble},
                    Case{"certified", NumberType::kCertified}, Case{"exact", NumberType::kExact},
                    Case{"machine", NumberType::kMachine}, Case{"drop", NumberType::kMachine, 14},
                    Case{"cut", NumberType::kMachine, 14, OverloadPolicy::kCut}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(ShownFaces, TheFirstFacesAreKept) {
  const LoadedScene scene = load_scene(std::nullopt, {});
  MachineOptions options;
  options.raster = {64, 48};
  FunctionalMachine machine(scene.database, options);
  machine.compute({scene.database.view.eye, scene.database.view.fov}, 0);
  const FrameFaces all = machine.faces();
  for (const std::size_t count : {std::size_t{0}, all.faces.size() / 2, all.faces.size() + 9}) {
    FrameFaces kept = all;
    keep_first(kept, count);
    ASSERT_EQ(kept.faces.size(), std::min(count, all.faces.size()));
    std::size_t edges = 0;
    for (std::size_t f = 0; f < kept.faces.size(); ++f) edges += kept.edges_of(f).size();
    EXPECT_EQ(kept.edges.size(), edges);
  }
}

TEST(FacesJson, RoundingIsToldApart) {
  FrameFaces faces;
  faces.faces.resize(1);
  faces.faces[0].object = 5;
  faces.faces[0].edge_count = 1;
  // The exact crossing of line 11 is at 4, where doubles come out a little above.
  faces.edges.push_back({10, 14, true, 3.9, 0.1, 0});
  faces.elements = {4, 4, 5, 5};
  const Json expected = Json::parse(R"([[5, "#000000", [[10, 14, 1, 3.9, 0.1]]]])");
  EXPECT_EQ(faces_json(faces, 100), expected);
  faces.elements = {4, 5, 5, 5};
  EXPECT_EQ(faces_json(faces, 100)[0][2][0][5], Json({11, 5}));
  faces.edges[0].x = std::nan("");
  EXPECT_EQ(faces_json(faces, 100)[0][2][0],
            Json::parse("[10, 14, 1, 0.0, 0.1, [10, 4, 11, 5, 12, 5, 13, 5]]"));
}

}  // namespace
}  // namespace cigsim
