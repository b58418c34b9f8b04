// SPDX-License-Identifier: MIT
#include "sim/measure/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace cigsim {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

constexpr double kLongestPoll_s = 3600;

// {"result": …} or {"error": …}
Json outcome_of(const std::function<Json()>& work) {
  try {
    return {{"result", work()}};
  } catch (const std::bad_alloc&) {
    return {{"error", "there is not enough memory; try a smaller scene or raster"}};
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  } catch (...) {
    return {{"error", "failed without a message"}};
  }
}

[[noreturn]] void be_child(int pipe, pid_t parent, const std::function<Json()>& work) {
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  // CBOR keeps infinities, which JSON does not.
  const Bytes bytes = Json::to_cbor(outcome_of(work));
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t n = ::write(pipe, bytes.data() + sent, bytes.size() - sent);
    if (n < 0 && errno != EINTR) ::_exit(1);
    if (n > 0) sent += static_cast<std::size_t>(n);
  }
  // Nothing of the parent's is flushed or destroyed a second time.
  ::_exit(0);
}

// A child and our end of its pipe; ended with this object if it still runs.
class Child {
 public:
  Child(const std::string& name, const std::function<Json()>& work) : name_(name) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) fail("has no pipe");
    std::fflush(nullptr);
    const pid_t parent = ::getpid();
    pid_ = ::fork();
    if (pid_ == 0) {
      ::close(ends[0]);
      be_child(ends[1], parent, work);
    }
    const int why = errno;
    ::close(ends[1]);
    if (pid_ < 0) {
      ::close(ends[0]);
      errno = why;
      fail("cannot be started");
    }
    pipe_ = ends[0];
  }
  ~Child() {
    if (pipe_ >= 0) ::close(pipe_);
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // What it sent until it closed the pipe.
  Bytes read(double limit_s) {
    const auto end = Clock::now() + std::chrono::duration<double>(limit_s);
    Bytes bytes;
    for (;;) {
      const double left_s = std::chrono::duration<double>(end - Clock::now()).count();
      if (left_s <= 0)
        throw MeasureError(fmt::format("{}: not done within {:g} s", name_, limit_s));
      pollfd file{pipe_, POLLIN, 0};
      const int ready =
          ::poll(&file, 1, static_cast<int>(std::min(left_s, kLongestPoll_s) * 1e3) + 1);
      if (ready < 0 && errno != EINTR) fail("cannot be watched");
      if (ready <= 0) continue;
      std::uint8_t part[65536];
      const ssize_t n = ::read(pipe_, part, sizeof part);
      if (n == 0) return bytes;
      if (n > 0) bytes.insert(bytes.end(), part, part + n);
      if (n < 0 && errno != EINTR) fail("cannot be read");
    }
  }

  // Its wait status.
  int wait() {
    int status = 0;
    while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

 private:
  [[noreturn]] void fail(const char* what) const {
    throw MeasureError(fmt::format("{}: its process {}: {}", name_, what, std::strerror(errno)));
  }

  std::string name_;
  pid_t pid_ = -1;
  int pipe_ = -1;
};

}  // namespace

Json in_child(const std::string& name, double limit_s, const std::function<Json()>& work) {
  Child child(name, work);
  const Bytes bytes = child.read(limit_s);
  const int status = child.wait();
  if (WIFSIGNALED(status))
    throw MeasureError(fmt::format("{}: its process ended by signal {} ({})", name,
                                   WTERMSIG(status), ::strsignal(WTERMSIG(status))));
  if (WEXITSTATUS(status) != 0 || bytes.empty())
    throw MeasureError(
        fmt::format("{}: its process ended early, with code {}", name, WEXITSTATUS(status)));
  Json outcome = Json::from_cbor(bytes);
  if (outcome.contains("error"))
    throw MeasureError(fmt::format("{}: {}", name, outcome["error"].get<std::string>()));
  return std::move(outcome["result"]);
}

}  // namespace cigsim
