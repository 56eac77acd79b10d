/// The server of the live view, reached through its port.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "apps/view/live_server.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

namespace {

/// Sends bytes to a port of this machine and reads the answer until the server closes the connection, or until more
/// came than any refusal has.
void converse(int port, std::string_view bytes) {
  const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
    ::send(connection, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    ::shutdown(connection, SHUT_WR);
    char part[1 << 14];
    ::recv(connection, part, sizeof part, 0);
  }
  // at once, so that ports do not wait for late packets
  const linger none{1, 0};
  ::setsockopt(connection, SOL_SOCKET, SO_LINGER, &none, sizeof none);
  ::close(connection);
}

}  // namespace

void live_requests(std::string_view bytes) {
  static const std::filesystem::path replay = file_with("replay.bin", "NILASRP4");
  static view::LiveServer server({}, "fuzz", replay);
  static const std::string token = server.address().substr(server.address().find("token=") + 6);
  static const int port = [] {
    const std::string& shown = server.address();
    return std::stoi(shown.substr(shown.rfind(':') + 1));
  }();
  std::string request(bytes);
  const std::string place = "TOKEN";
  for (auto at = request.find(place); at != std::string::npos; at = request.find(place, at + token.size()))
    request.replace(at, place.size(), token);
  converse(port, request);
}

}  // namespace nilas::fuzz
