#pragma once
/// Ends what clients of a server of this program keep open.
#include <chrono>
#include <functional>
#include <map>

namespace nilas::view {

/// Ends all connections of this program whose own end is this TCP port. Whoever waits for their bytes goes on at once.
/// Linux only; elsewhere it does nothing.
void end_connections(int port);

/// Ends connections that take too long. One thread at a time may use it.
class SlowConnections {
 public:
  SlowConnections(int port, std::chrono::milliseconds longest) : port_(port), longest_(longest) {}
  /// Ends those that were seen first so long ago, but those whose other end has a port that may stay. Call it often.
  void end(const std::function<bool(int port)>& may_stay);

 private:
  int port_;
  std::chrono::milliseconds longest_;
  std::map<unsigned long, std::chrono::steady_clock::time_point> seen_;  ///< by the number of the socket
};

}  // namespace nilas::view
