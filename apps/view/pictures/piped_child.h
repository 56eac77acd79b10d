#pragma once
/// A program that runs beside this one and talks with it over sockets.
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nilas::view {

/// Descriptors of the child that are connected with this program; -1: none. Its standard input is empty otherwise, and
/// what it prints goes to the log.
struct ChildEnds {
  int reads = -1;   ///< the descriptor at which it reads what we write
  int writes = -1;  ///< the descriptor at which it writes what we read
};

/// The child and all that it starts end with this object. Ctrl-C on the terminal reaches this program alone. Every wait
/// has a limit, and throws Interruption where the user asks to stop (base/stop_request.h).
class PipedChild {
 public:
  /// `command`: the program's file and its arguments; no shell reads them. `log`: in a folder of this program's own,
  /// where the child also puts what it needs for a while. Throws FileError where it cannot start.
  PipedChild(std::vector<std::string> command, ChildEnds ends, std::filesystem::path log);
  ~PipedChild();
  PipedChild(const PipedChild&) = delete;
  PipedChild& operator=(const PipedChild&) = delete;

  /// Writes all of it. Throws FileError where the child has ended or takes nothing for `limit_s`.
  void write(std::string_view bytes, double limit_s);
  /// Appends what the child has written, at least one byte. Throws FileError as write() does.
  void read(std::string& to, double limit_s);
  /// Ends what the child reads, and waits for its end. Returns its exit code, or 128 and the signal. Throws FileError
  /// where it has not ended after `limit_s`.
  int finish(double limit_s);
  /// The last lines that the child printed, for messages.
  std::string last_words() const;

 private:
  [[noreturn]] void fail(const std::string& what) const;
  void wait_for(int descriptor, short events, double limit_s) const;
  void kill_all();

  std::string name_;
  std::filesystem::path log_;
  pid_t process_ = -1;
  int to_child_ = -1, from_child_ = -1;
};

}  // namespace nilas::view
