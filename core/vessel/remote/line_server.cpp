#include "core/vessel/remote/line_server.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include "core/base/error.h"
#include "core/base/stop_request.h"

namespace nilas::vessel {

namespace {

using Clock = std::chrono::steady_clock;

/// Longest wait between two looks at a request to stop, which may come just before a wait begins [s].
constexpr double k_look = 0.1;
/// Longest line [bytes]: far more than commands need, so that a program that sends no lines is noticed.
constexpr std::size_t k_longest_line = 1 << 20;

sockaddr_un address_of(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  NILAS_DEMAND(path.size() < sizeof address.sun_path);
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return address;
}

int new_socket() { return ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0); }

std::string reason() { return std::strerror(errno); }

bool listens(const std::string& path) {
  const sockaddr_un address = address_of(path);
  const int probe = new_socket();
  const bool answered = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(probe);
  return answered;
}

/// Removes a socket's file that no program listens at.
void make_room(const std::string& path) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return;
  if (!S_ISSOCK(there.st_mode)) throw FileError(path + ": a file stands there that is no socket; choose another path");
  if (listens(path)) throw FileError(path + ": another program listens at this socket; choose another path");
  ::unlink(path.c_str());
}

/// Waits until the descriptor is ready for `events`. Looks at the user's request to stop in between.
LineStatus wait_for(int descriptor, short events, Clock::time_point until) {
  while (true) {
    if (stop_requested()) return LineStatus::stopped;
    const double left = std::chrono::duration<double>(until - Clock::now()).count();
    constexpr double k_milli = 1e3;
    pollfd one{descriptor, events, 0};
    const int ready = ::poll(&one, 1, static_cast<int>(k_milli * std::clamp(left, 0.0, k_look)) + (left > 0 ? 1 : 0));
    if (ready > 0) return LineStatus::done;
    if (ready < 0 && errno != EINTR) return LineStatus::failed;
    if (left <= 0) return stop_requested() ? LineStatus::stopped : LineStatus::timed_out;
  }
}

Clock::time_point in(double seconds) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

LineServer::LineServer(std::string path) : path_(std::move(path)) {
  make_room(path_);
  const sockaddr_un address = address_of(path_);
  listener_ = new_socket();
  if (listener_ < 0) throw FileError(path_ + ": no socket can be made: " + reason());
  if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      ::listen(listener_, 1) != 0) {
    const std::string why = reason();
    ::close(listener_);
    throw FileError(path_ + ": no socket can be made there: " + why);
  }
}

LineServer::~LineServer() {
  if (connection_ >= 0) ::close(connection_);
  ::close(listener_);
  ::unlink(path_.c_str());
}

LineStatus LineServer::accept(double seconds) {
  const LineStatus waited = wait_for(listener_, POLLIN, in(seconds));
  if (waited != LineStatus::done) return waited;
  connection_ = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  return connection_ >= 0 ? LineStatus::done : LineStatus::failed;
}

LineStatus LineServer::send(const std::string& text, double seconds) {
  NILAS_DEMAND(connection_ >= 0);
  const auto until = in(seconds);
  const std::string line = text + "\n";
  for (std::size_t sent = 0; sent < line.size();) {
    const LineStatus waited = wait_for(connection_, POLLOUT, until);
    if (waited != LineStatus::done) return waited;
    const ssize_t count = ::send(connection_, line.data() + sent, line.size() - sent, MSG_NOSIGNAL);
    if (count >= 0)
      sent += static_cast<std::size_t>(count);
    else if (errno == EPIPE || errno == ECONNRESET)
      return LineStatus::closed;
    else if (errno != EAGAIN && errno != EINTR)
      return LineStatus::failed;
  }
  return LineStatus::done;
}

ReceivedLine LineServer::receive(double seconds) {
  NILAS_DEMAND(connection_ >= 0);
  const auto until = in(seconds);
  const auto given_up = [&](LineStatus status) { return ReceivedLine{status, std::exchange(unread_, {})}; };
  while (true) {
    if (const auto end = unread_.find('\n'); end != std::string::npos) {
      std::string line = unread_.substr(0, end);
      unread_.erase(0, end + 1);
      if (!line.empty() && line.back() == '\r') line.pop_back();
      return {LineStatus::done, std::move(line)};
    }
    if (unread_.size() > k_longest_line) return given_up(LineStatus::too_long);
    const LineStatus waited = wait_for(connection_, POLLIN, until);
    if (waited != LineStatus::done) return given_up(waited);
    char part[4096];
    const ssize_t count = ::recv(connection_, part, sizeof part, 0);
    if (count > 0)
      unread_.append(part, static_cast<std::size_t>(count));
    else if (count == 0 || errno == ECONNRESET)
      return given_up(LineStatus::closed);
    else if (errno != EAGAIN && errno != EINTR)
      return given_up(LineStatus::failed);
  }
}

}  // namespace nilas::vessel
