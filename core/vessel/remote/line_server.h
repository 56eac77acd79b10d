#pragma once
/// A local (Unix domain) socket at which one other program connects, to exchange lines of text.
#include <string>

namespace nilas::vessel {

/// The longest path of a socket that the system takes, in bytes without the closing zero.
constexpr int k_longest_socket_path = 107;

/// How a wait at a socket ended: as wanted; after the time allowed; since the user asked the program to stop; since the
/// other program closed the connection; with a line that is too long; or with a fault of the system.
enum class LineStatus { done, timed_out, stopped, closed, too_long, failed };

struct ReceivedLine {
  LineStatus status = LineStatus::done;
  std::string text;  ///< the line without its end; what came of it where the status is not `done`
};

/// Listens from construction on, and removes the socket's file at its end.
class LineServer {
 public:
  /// Creates the socket's file. A file that an earlier run left there is replaced. Throws FileError where another
  /// program listens, where a file that is no socket stands there, or where the system refuses.
  explicit LineServer(std::string path);
  ~LineServer();
  LineServer(const LineServer&) = delete;
  LineServer& operator=(const LineServer&) = delete;

  /// Waits up to `seconds` for the other program to connect.
  LineStatus accept(double seconds);
  /// Sends the text and an end of line. Waits up to `seconds` for the other program to read.
  LineStatus send(const std::string& text, double seconds);
  /// Waits up to `seconds` for the next line, which ends with a line feed; a carriage return before it is left out.
  ReceivedLine receive(double seconds);

 private:
  std::string path_;
  int listener_ = -1, connection_ = -1;
  std::string unread_;  ///< what has come after the last line
};

}  // namespace nilas::vessel
