#pragma once
/// A run of the program that continues while a test inspects it, and that the test may kill.
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/support/program.h"

namespace nilas_test {

/// A program that was started without waiting for its end.
class Started {
 public:
  Started(const std::string& arguments, const fs::path& folder) {
    const std::string command =
        "cd '" + folder.string() + "' && exec '" NILAS_PROGRAM "' " + arguments + " >out.txt 2>err.txt </dev/null";
    process_ = ::fork();
    if (process_ == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
  }
  ~Started() { stop(SIGKILL); }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;

  bool runs() {
    if (process_ > 0 && ::waitpid(process_, &status_, WNOHANG) == process_) process_ = 0;
    return process_ > 0;
  }
  /// Waits until a file has so many lines; false when the program ends before.
  bool reaches(const fs::path& file, std::size_t lines) {
    while (runs()) {
      if (lines_of(file).size() >= lines) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
  /// Sends the signal and waits. Returns the exit code, or 128 plus the signal.
  int stop(int signal) {
    if (runs()) {
      ::kill(process_, signal);
      ::waitpid(process_, &status_, 0);
      process_ = 0;
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }

 private:
  pid_t process_ = 0;
  int status_ = 0;
};

}  // namespace nilas_test
