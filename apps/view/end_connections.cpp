#include "apps/view/end_connections.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <charconv>
#include <filesystem>
#include <string>

namespace nilas::view {

namespace {

int port_of(const sockaddr_storage& address) {
  if (address.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(address).sin_port);
  if (address.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(address).sin6_port);
  return -1;
}

/// The TCP ports of a socket's both ends; -1 where it is no connected TCP socket.
struct Ends {
  int own = -1, other = -1;
};

Ends ends_of(int file) {
  sockaddr_storage own{}, other{};
  socklen_t own_size = sizeof own, other_size = sizeof other;
  if (getsockname(file, reinterpret_cast<sockaddr*>(&own), &own_size) != 0) return {};
  if (getpeername(file, reinterpret_cast<sockaddr*>(&other), &other_size) != 0) return {};
  return {port_of(own), port_of(other)};
}

/// Calls a function with each open file of this program and its ends, where the own one is this port.
void each_connection(int port, const std::function<void(int file, int other)>& call) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    const std::string name = entry.path().filename().string();
    int file = -1;
    std::from_chars(name.data(), name.data() + name.size(), file);
    if (file < 0) continue;
    if (const Ends ends = ends_of(file); ends.own == port) call(file, ends.other);
  }
}

}  // namespace

void end_connections(int port) {
  each_connection(port, [](int file, int) { shutdown(file, SHUT_RDWR); });
}

void SlowConnections::end(const std::function<bool(int port)>& may_stay) {
  const auto now = std::chrono::steady_clock::now();
  std::map<unsigned long, std::chrono::steady_clock::time_point> still;
  each_connection(port_, [&](int file, int other) {
    struct stat found {};
    if (fstat(file, &found) != 0) return;
    const auto before = seen_.find(found.st_ino);
    const auto first = before == seen_.end() ? now : before->second;
    still.emplace(found.st_ino, first);
    if (now - first > longest_ && !may_stay(other)) shutdown(file, SHUT_RDWR);
  });
  seen_ = std::move(still);
}

}  // namespace nilas::view
