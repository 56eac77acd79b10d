#include "apps/view/pictures/piped_child.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/base/stop_request.h"

namespace nilas::view {

namespace {

using Moment = std::chrono::steady_clock::time_point;

constexpr int k_listen_ms = 50;  // between two looks for Ctrl-C
constexpr std::size_t k_read_bytes = 1 << 18, k_last_bytes = 600;
/// Descriptors of the child's side are moved above those that it expects.
constexpr int k_above_all = 20;

double seconds_since(Moment start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void demand_no_stop() {
  if (stop_requested()) throw Interruption("The program was interrupted before it had finished.");
}

/// Two connected sockets, both closed in programs that start later. A socket, unlike a pipe, can be written to without
/// a signal where the other side is gone.
std::array<int, 2> connected() {
  std::array<int, 2> pair{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0)
    throw FileError(std::string("no connection to another program can be made: ") + std::strerror(errno));
  return pair;
}

int log_for_child(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) throw FileError(file.string() + ": cannot be written: " + std::strerror(errno));
  return descriptor;
}

/// The child's side of its connections; -1: none.
struct ChildSide {
  int log = -1, reads = -1, writes = -1;
};

/// The environment of this program, with another folder for files that are used for a while.
std::vector<std::string> environment_with(const std::filesystem::path& folder) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with("TMPDIR=")) all.emplace_back(*entry);
  all.push_back("TMPDIR=" + folder.string());
  return all;
}

/// The words as programs take them, while `words` stays as it is.
std::vector<char*> for_program(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Turns the child into the program. It makes only calls that are safe after fork().
[[noreturn]] void become_program(char* const* arguments, char* const* environment, ChildSide side, ChildEnds ends,
                                 pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(k_exit_not_started);
  if (side.reads >= 0) side.reads = ::fcntl(side.reads, F_DUPFD_CLOEXEC, k_above_all);
  if (side.writes >= 0) side.writes = ::fcntl(side.writes, F_DUPFD_CLOEXEC, k_above_all);
  ::dup2(side.log, STDOUT_FILENO);
  ::dup2(side.log, STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing > 0) ::dup2(nothing, STDIN_FILENO);
  if (nothing > STDERR_FILENO) ::close(nothing);
  if (ends.reads >= 0) ::dup2(side.reads, ends.reads);
  if (ends.writes >= 0) ::dup2(side.writes, ends.writes);
  ::signal(SIGINT, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::execve(arguments[0], arguments, environment);
  ::_exit(k_exit_not_started);
}

}  // namespace

PipedChild::PipedChild(std::vector<std::string> command, ChildEnds ends, std::filesystem::path log)
    : name_(std::filesystem::path(command.front()).filename().string()), log_(std::move(log)) {
  const std::vector<char*> arguments = for_program(command);
  // A browser that is ended leaves files behind.
  std::vector<std::string> entries = environment_with(std::filesystem::absolute(log_).parent_path());
  const std::vector<char*> environment = for_program(entries);
  ChildSide side;
  side.log = log_for_child(log_);
  if (ends.reads >= 0) {
    const auto pair = connected();
    to_child_ = pair[0];
    side.reads = pair[1];
  }
  if (ends.writes >= 0) {
    const auto pair = connected();
    from_child_ = pair[0];
    side.writes = pair[1];
  }
  for (const int ours : {to_child_, from_child_})
    if (ours >= 0) ::fcntl(ours, F_SETFL, O_NONBLOCK);
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become_program(arguments.data(), environment.data(), side, ends, parent);
  if (process_ > 0) ::setpgid(process_, process_);  // whoever is first, so that the group is there to be ended
  for (const int theirs : {side.log, side.reads, side.writes})
    if (theirs >= 0) ::close(theirs);
  if (process_ < 0) fail(std::string("cannot be started: ") + std::strerror(errno));
}

PipedChild::~PipedChild() {
  kill_all();
  for (const int ours : {to_child_, from_child_})
    if (ours >= 0) ::close(ours);
}

void PipedChild::kill_all() {
  if (process_ <= 0) return;
  ::kill(-process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
}

std::string PipedChild::last_words() const {
  const std::string all = std::filesystem::exists(log_) ? file_bytes(log_) : "";
  std::string last = all.size() > k_last_bytes ? "..." + all.substr(all.size() - k_last_bytes) : all;
  while (!last.empty() && last.back() == '\n') last.pop_back();
  return last;
}

void PipedChild::fail(const std::string& what) const {
  const std::string said = last_words();
  throw FileError(name_ + " " + what + (said.empty() ? "" : ". It printed:\n" + said));
}

void PipedChild::wait_for(int descriptor, short events, double limit_s) const {
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    demand_no_stop();
    pollfd wanted{descriptor, events, 0};
    if (::poll(&wanted, 1, k_listen_ms) > 0) return;
    if (seconds_since(start) > limit_s) fail(fmt::format("gave no answer for {:g} s", limit_s));
  }
}

void PipedChild::write(std::string_view bytes, double limit_s) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(to_child_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (count < 0 && (errno == EAGAIN || errno == EINTR)) {
      wait_for(to_child_, POLLOUT, limit_s);
    } else {
      fail("has ended before its time");
    }
  }
}

void PipedChild::read(std::string& to, double limit_s) {
  std::array<char, k_read_bytes> part;
  for (;;) {
    wait_for(from_child_, POLLIN, limit_s);
    const ssize_t count = ::read(from_child_, part.data(), part.size());
    if (count > 0) {
      to.append(part.data(), static_cast<std::size_t>(count));
      return;
    }
    if (count == 0 || (errno != EAGAIN && errno != EINTR)) fail("has ended before its time");
  }
}

int PipedChild::finish(double limit_s) {
  if (to_child_ >= 0) ::close(to_child_);
  to_child_ = -1;
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  for (pid_t ended = 0; ended != process_;) {
    ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == process_) break;
    if (ended < 0 && errno != EINTR) fail("has an end that the system does not tell");
    demand_no_stop();
    if (seconds_since(start) > limit_s) fail(fmt::format("has not ended after {:g} s", limit_s));
    std::this_thread::sleep_for(std::chrono::milliseconds(k_listen_ms));
  }
  ::kill(-process_, SIGKILL);  // what it may have left behind
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : k_exit_signal + WTERMSIG(status);
}

}  // namespace nilas::view
