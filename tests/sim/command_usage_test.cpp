// SPDX-License-Identifier: MIT
// Exit codes and messages of every subcommand.
#include <nlohmann/json.hpp>

#include "tests/sim/process.hpp"

namespace cigsim {
namespace {

using Words = std::vector<std::string>;

TEST_F(CommandTest, HelpAndVersionSucceed) {
  for (const Words& words : {Words{"--help"},
                             {"-h"},
                             {"run", "--help"},
                             {"prepare", "--help"},
                             {"requirements", "--help"},
                             {"generate", "--help"},
                             {"machines", "--help"},
                             {"gates", "--help"},
                             {"wave-picture", "--help"},
                             {"assemble", "--help"}}) {
    const Outcome outcome = cigsim(words);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("Usage: cigsim"), std::string::npos);
    EXPECT_NE(outcome.out.find("  cigsim "), std::string::npos) << "an example";
  }
  const Outcome version = cigsim({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("cigsim ", 0), 0u);
}

TEST_F(CommandTest, HelpLinesFitAScreen) {
  for (const char* command : {"run", "prepare", "requirements", "generate", "machines", "gates",
                              "assemble", "wave-picture"}) {
    std::istringstream help(cigsim({command, "--help"}).out);
    for (std::string line; std::getline(help, line);) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST_F(CommandTest, WrongUsageSaysSoInOneLine) {
  expect_unusable({}, "choose from run, prepare");
  expect_unusable({"rnu"}, "'rnu' is no command");
  expect_unusable({"--foo"}, "'--foo' is no command");
  expect_unusable({"run", "--foo"}, "--foo; see cigsim run --help");
  expect_unusable({"run", "--raster"}, "--raster");
  expect_unusable({"run", "a.json", "b.json"}, "b.json");
  expect_unusable({"prepare"}, "cigsim prepare --help");
  expect_unusable({"prepare", "a.json"}, "--output is required");
  expect_unusable({"generate"}, "cigsim generate --help");
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, ImpossibleViewsAreRefused) {
  expect_unusable({"run", "--raster", "0x0"}, "--raster: '0' is not a whole number");
  expect_unusable({"run", "--raster", "16385x1"}, "--raster");
  expect_unusable({"run", "--fov", "180"}, "--fov");
  expect_unusable({"run", "--eye", "1,2"}, "--eye");
  expect_unusable({"run", "--eye", "1,2,nan"}, "--eye");
  expect_unusable({"run", "--eye", "1,2,3", "--look-at", "1,2,3"}, "--look-at");
  expect_unusable({"run", "--attitude", "1,2,3", "--look-at", "1,2,3"}, "excludes");
  expect_unusable({"run", "--eye", "1,2,3", "--path", "builtin"}, "excludes");
  expect_unusable({"run", "--frames", "0"}, "--frames");
  expect_unusable({"run", "--repeat", "1.5"}, "--repeat");
  expect_unusable({"run", "--number", "half"},
                  "choose from float, double, certified, machine, exact");
  expect_unusable({"run", "--priority", "z-buffer"}, "choose from counters, so");
  expect_unusable({"run", "--resolver", "x"}, "choose from auto, painter, coverage, active-list");
  expect_unusable({"run", "--sun", "1"}, "--sun");
  expect_unusable({"run", "--contact-tolerance", "-1"}, "--contact-tolerance: -1 must lie from 0");
  EXPECT_TRUE(files().empty());
}

TEST_F(CommandTest, UnusableFilesAreNamed) {
  put("broken.json", "{\"cigsim\": 1, \"objects\": [");
  put("empty.obj", "");
  put("bad.csv", "x,y,z,heading,pitch,roll\n1,2,3,4,5,6\n1,2,3,4,5\n");
  const std::vector<std::string> before = files();
  expect_unusable({"run", "absent.json"}, "absent.json: ");
  expect_unusable({"run", "."}, ".: ");
  expect_unusable({"run", "scene.xyz"}, "scene.xyz: ");
  expect_unusable({"run", "broken.json"}, "broken.json:");
  expect_unusable({"run", "empty.obj"}, "empty.obj:");
  expect_unusable({"run", "--path", "bad.csv"}, "bad.csv:3: has 5 fields");
  expect_unusable({"run", "--path", "absent.csv"}, "absent.csv: ");
  expect_unusable({"run", "--path", "."}, ".: ");
  expect_unusable({"requirements", "broken.json"}, "broken.json:");
  expect_unusable({"prepare", "broken.json", "-o", "db.json"}, "broken.json:");
  EXPECT_EQ(files(), before);
}

TEST_F(CommandTest, AnOutputThatCannotBeWrittenIsNoSuccess) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
  const std::string command = std::string("\"") + CIGSIM_COMMAND + "\" requirements >/dev/full 2>" +
                              (logs_ / "err").string();
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
}  // namespace cigsim
