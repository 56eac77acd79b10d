#include "apps/view/end_connections.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <charconv>
#include <filesystem>
#include <string>

namespace nilas::view {

namespace {

/// The TCP port of a socket's own end; -1 where it is no connected TCP socket.
int port_of_connection(int file) {
  sockaddr_storage own{}, other{};
  socklen_t own_size = sizeof own, other_size = sizeof other;
  if (getsockname(file, reinterpret_cast<sockaddr*>(&own), &own_size) != 0) return -1;
  if (getpeername(file, reinterpret_cast<sockaddr*>(&other), &other_size) != 0) return -1;
  if (own.ss_family == AF_INET) return ntohs(reinterpret_cast<const sockaddr_in&>(own).sin_port);
  if (own.ss_family == AF_INET6) return ntohs(reinterpret_cast<const sockaddr_in6&>(own).sin6_port);
  return -1;
}

}  // namespace

void end_connections(int port) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", none)) {
    const std::string name = entry.path().filename().string();
    int file = -1;
    std::from_chars(name.data(), name.data() + name.size(), file);
    if (file >= 0 && port_of_connection(file) == port) shutdown(file, SHUT_RDWR);
  }
}

}  // namespace nilas::view
