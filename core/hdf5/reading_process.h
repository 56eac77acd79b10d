#pragma once
/// A child process that reads a file for this one. A library that crashes at a damaged file, or that asks for too much
/// memory, then ends or fails there.
#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <span>
#include <string>

namespace nilas::hdf5 {

/// Sends all bytes; false where nobody reads at the other end.
bool send_bytes(int socket, std::span<const char> bytes);

/// What the child may use.
struct ReadingLimits {
  std::size_t memory = 0;  ///< more than this process has at the start [bytes]
  unsigned seconds = 0;    ///< processor time [s]
};

/// The child lives as long as the object. It is a fork: it calls nothing of this process but what `serve` calls, and
/// ends without its destructors. One thread at a time may use the object.
class ReadingProcess {
 public:
  /// Starts the child, which calls `serve` with its end of a socket. `path` is for messages. Throws FileError where no
  /// process can be started.
  ReadingProcess(std::string path, ReadingLimits limits, const std::function<void(int)>& serve);
  ~ReadingProcess();
  ReadingProcess(const ReadingProcess&) = delete;
  ReadingProcess& operator=(const ReadingProcess&) = delete;

  /// Sends to the child, or fills the bytes with what it sends. Both throw InputError where the child crashed or took
  /// too long, and FileError where another process ended it or it waits for ever.
  void send(std::span<const char> bytes);
  void receive(std::span<char> bytes);

  /// Ends the child since it sent what makes no sense, and throws InputError.
  [[noreturn]] void refuse_answer();

 private:
  [[noreturn]] void tell_end();
  void await();
  int end();

  std::string path_;
  ReadingLimits limits_;
  int socket_ = -1;
  pid_t child_ = -1;
};

}  // namespace nilas::hdf5
