// SPDX-License-Identifier: MIT
// Levels of detail in scene files.
#include "models/environment/detail.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "models/environment/read.hpp"
#include "models/environment/write.hpp"
#include "tests/support/scratch.hpp"

namespace cigsim {
namespace {

const std::string kFace = R"("vertices": [[0,0,0],[1,0,0],[0,1,0]], "faces": [[0,1,2]])";

std::string object(const std::string& name) {
  return "{\"name\": \"" + name + "\", " + kFace + "}";
}

// Two descriptions of a tower, the second with a choice within; an object before and one after.
std::string tower(const std::string& first = "\"up_to\": 6,\n",
                  const std::string& second = "\"up_to\": 2,\n") {
  return "{\"cigsim\": 1, \"objects\": [" + object("before") +
         ",\n {\"name\": \"tower\", \"descriptions\": [\n  {" + first + "\"objects\": [" +
         object("coarse") + "]},\n  {\"objects\": [" + object("fine") +
         ", {\"name\": \"mast\", \"descriptions\": [\n   {" + second +
         "\"objects\": []},\n   {\"objects\": [" + object("mast") + "]}]}]}]},\n " +
         object("after") + "]}";
}

std::string error_of(const std::string& text) {
  return test::message_of([&] { parse_json(text, "s.json"); });
}

TEST(Detail, IsReadInTheOrderOfTheText) {
  const Environment e = parse_json(tower(), "s.json").environment;
  ASSERT_EQ(e.choices.size(), 2u);
  EXPECT_EQ(e.choices[0], (Choice{"tower", 0, std::nullopt, {6}}));
  EXPECT_EQ(e.choices[1], (Choice{"mast", 0, DescriptionRef{0, 1}, {2}}));
  ASSERT_EQ(e.objects.size(), 5u);
  const char* names[] = {"before", "coarse", "fine", "mast", "after"};
  const std::optional<DescriptionRef> within[] = {
      {}, DescriptionRef{0, 0}, DescriptionRef{0, 1}, DescriptionRef{1, 1}, {}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(e.objects[i].name, names[i]);
    EXPECT_EQ(e.objects[i].within, within[i]) << names[i];
  }
}

TEST(Detail, MissingThresholdsAscendFromEight) {
  const Environment e =
      parse_json(
          "{\"cigsim\": 1, \"objects\": [{\"descriptions\": [{\"objects\": []}, "
          "{\"objects\": []}, {\"up_to\": 100, \"objects\": []}, {\"objects\": []}, "
          "{\"objects\": [" +
              object("o") + "]}]}]}",
          "s")
          .environment;
  EXPECT_EQ(e.choices[0].thresholds, (std::vector<double>{8, 32, 100, 400}));
}

TEST(Detail, OneDescriptionIsAChoiceOfOne) {
  const Environment e =
      parse_json("{\"cigsim\": 1, \"objects\": [{\"descriptions\": [{\"objects\": [" + object("o") +
                     "]}]}]}",
                 "s")
          .environment;
  EXPECT_TRUE(e.choices[0].thresholds.empty());
  EXPECT_TRUE(is_most_detailed(e, e.objects[0]));
}

TEST(Detail, FaultsAreNamedWithTheirLine) {
  const struct {
    std::string text, message;
  } cases[] = {
      {tower("\"up_to\": 0,\n"), "s.json:3: up_to must be above 0"},
      {tower("\"up_to\": -1,\n"), "s.json:3: up_to must be above 0"},
      {tower("\"up_to\": \"6\",\n"), "s.json:3: up_to must be a number, not a text"},
      {tower("\"upto\": 6,\n"), "s.json:3: unknown key \"upto\" in a description"},
      {R"({"cigsim": 1, "objects": [{"descriptions": []}]})",
       "s.json:1: a choice has 1 to 64 descriptions, not 0"},
      {R"({"cigsim": 1, "objects": [{"descriptions": [{}]}]})",
       "s.json:1: key \"objects\" is missing in a description"},
      {R"({"cigsim": 1, "objects": [{"descriptions": [{"objects": []}]}]})",
       "s.json:1: the most detailed description holds no object"},
      {R"({"cigsim": 1, "objects": [{"descriptions": [{"up_to": 5, "objects": []}]}]})",
       "s.json:1: the last description is the most detailed one and has no \"up_to\""},
      {R"({"cigsim": 1, "objects": [{"descriptions": [], "faces": []}]})",
       "s.json:1: unknown key \"faces\" in a choice"},
      {"{\"cigsim\": 1, \"objects\": [{\"descriptions\": [{\"up_to\": 5, \"objects\": []},\n"
       "{\"up_to\": 5, \"objects\": []},{\"objects\": [" +
           object("o") + "]}]}]}",
       "s.json:2: up_to must be above that of the description before"},
      {"{\"cigsim\": 1, \"objects\": [{\"descriptions\": [{\"up_to\": 1e308, \"objects\": []},\n"
       "{\"objects\": []},{\"objects\": [" +
           object("o") + "]}]}]}",
       "s.json:2: the default of \"up_to\" is too large; state it"}};
  for (const auto& [text, message] : cases)
    EXPECT_EQ(error_of(text).substr(0, message.size()), message) << text;
}

TEST(Detail, AtMostSixtyFourDescriptionsAndEightChoicesDeep) {
  const auto many = [](int count) {
    std::string text = "{\"cigsim\": 1, \"objects\": [{\"descriptions\": [";
    for (int i = 1; i < count; ++i)
      text += "{\"up_to\": " + std::to_string(i) + ", \"objects\": []}, ";
    return text + "{\"objects\": [" + object("o") + "]}]}]}";
  };
  EXPECT_EQ(parse_json(many(64), "s").environment.choices[0].thresholds.size(), 63u);
  EXPECT_EQ(error_of(many(65)), "s.json:1: a choice has 1 to 64 descriptions, not 65");
  const auto deep = [](int levels) {
    std::string text = object("o");
    for (int i = 0; i < levels; ++i) text = "{\"descriptions\": [{\"objects\": [" + text + "]}]}";
    return "{\"cigsim\": 1, \"objects\": [" + text + "]}";
  };
  EXPECT_EQ(parse_json(deep(8), "s").environment.choices.size(), 8u);
  EXPECT_EQ(error_of(deep(9)).substr(0, 41), "s.json:1: choices stand more than 8 deep ");
}

TEST(Detail, IsWrittenAndReadBackEqual) {
  const test::Scratch scratch;
  Environment nested = parse_json(tower(), "s").environment;
  Environment flat = nested;  // models that do not follow each other
  flat.models.push_back({"second", 0});
  flat.objects.front().model = 1;
  for (const Environment& e : {nested, flat})
    for (const char* name : {"a.json", "a.cbor"}) {
      write_environment(e, scratch.path(name));
      EXPECT_EQ(read_environment(scratch.path(name)).environment, e) << name;
    }
}

TEST(Detail, MostDetailedKeepsTheNumbers) {
  const test::Scratch scratch;
  const Environment e = parse_json(tower(), "s").environment;
  const Environment plain = most_detailed(e);
  EXPECT_TRUE(plain.choices.empty());
  ASSERT_EQ(plain.objects.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(plain.objects[i].faces.empty(), i == 1);
    EXPECT_FALSE(plain.objects[i].within);
  }
  write_environment(e, scratch.path("a.obj"));
  const Environment obj = read_environment(scratch.path("a.obj")).environment;
  ASSERT_EQ(obj.objects.size(), 5u);
  EXPECT_TRUE(obj.objects[1].faces.empty());
  EXPECT_EQ(obj.objects[3].faces.size(), 1u);
}

TEST(Detail, ChoicesThatMakeNoSenseAreRefused) {
  const test::Scratch scratch;
  const Environment good = parse_json(tower(), "s").environment;
  check_choices(good);
  const auto refused = [&](auto damage) {
    Environment bad = good;
    damage(bad);
    EXPECT_THROW(write_environment(bad, scratch.path("a.json")), std::invalid_argument);
  };
  refused([](Environment& e) { e.objects[0].within = DescriptionRef{2, 0}; });
  refused([](Environment& e) { e.objects[0].within = DescriptionRef{0, 2}; });
  refused([](Environment& e) { e.objects[4].within = DescriptionRef{0, 0}; });  // not together
  refused([](Environment& e) { std::swap(e.objects[1], e.objects[2]); });       // out of order
  refused([](Environment& e) { e.choices[0].within = DescriptionRef{1, 0}; });
  refused([](Environment& e) { e.choices[0].thresholds = {6, 6}; });
  refused([](Environment& e) { e.choices[0].thresholds = {0}; });
  refused([](Environment& e) { e.choices[1].model = 1; });
  refused([](Environment& e) { e.objects[3].within.reset(); });  // the mast is empty
}

}  // namespace
}  // namespace cigsim
