// SPDX-License-Identifier: MIT
#include "tests/sim/process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace cigsim {
namespace {

void limit(int what, const std::optional<std::uint64_t>& bytes) {
  if (!bytes) return;
  const rlimit value{*bytes, *bytes};
  setrlimit(what, &value);
}

void redirect(int descriptor, const char* file) {
  const int opened = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
  close(opened);
}

// The address sanitizer says so where an exception passes through one of SystemC's threads.
std::string without_sanitizer_warning(std::string text) {
#ifdef __SANITIZE_ADDRESS__
  const std::size_t from = text.find("==WARNING: ASan is ignoring");
  if (from == std::string::npos) return text;
  const std::size_t begin = text.rfind('\n', from) + 1, link = text.find("issues/189\n", from);
  if (link != std::string::npos) text.erase(begin, text.find('\n', link) + 1 - begin);
#endif
  return text;
}

}  // namespace

pid_t CommandTest::start(const std::vector<std::string>& arguments, const Limits& limits) {
  std::vector<char*> words{const_cast<char*>(CIGSIM_COMMAND)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const std::string out = logs_ / "out", err = logs_ / "err";
  const pid_t child = fork();
  if (child != 0) return child;
  redirect(STDOUT_FILENO, out.c_str());
  redirect(STDERR_FILENO, err.c_str());
  limit(RLIMIT_FSIZE, limits.file_size);
  limit(RLIMIT_AS, limits.memory);
  if (chdir(folder_.c_str()) == 0) execv(words[0], words.data());
  _exit(127);
}

Outcome CommandTest::finish(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          test::bytes_of(logs_ / "out"), without_sanitizer_warning(test::bytes_of(logs_ / "err"))};
}

Outcome CommandTest::cigsim(const std::vector<std::string>& arguments, const Limits& limits) {
  return finish(start(arguments, limits));
}

void CommandTest::expect_unusable(const std::vector<std::string>& arguments,
                                  const std::string& part_of_message, const Limits& limits) {
  std::string line;
  for (const std::string& word : arguments) line += " " + word;
  SCOPED_TRACE("cigsim" + line);
  const Outcome outcome = cigsim(arguments, limits);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("cigsim: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find(part_of_message), std::string::npos) << outcome.err;
}

std::filesystem::path CommandTest::put(const std::string& name, const std::string& contents) const {
  return scratch_.write(name, contents);
}

std::string CommandTest::contents(const std::string& name) const {
  return test::bytes_of(folder_ / name);
}

std::vector<std::string> CommandTest::files() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
    names.push_back(std::filesystem::relative(entry.path(), folder_).string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace cigsim
