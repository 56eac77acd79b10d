#include "core/hdf5/reading_process.h"

#include <fcntl.h>
#include <hdf5.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>

#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::hdf5 {

namespace {

/// Signals by which a program ends that goes wrong by itself.
constexpr std::array k_crashes{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGTRAP, SIGSYS};

/// The address space of this process [bytes]; 0 where the system does not tell.
std::size_t address_space() {
  std::array<char, 64> text{};
  const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  unsigned long pages = 0;
  if (length <= 0 || std::sscanf(text.data(), "%lu", &pages) != 1) return 0;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// Lowers a limit of this process; one that is lower already stays.
void lower_limit(__rlimit_resource what, rlim_t to) {
  rlimit now{};
  if (::getrlimit(what, &now) != 0) return;
  now.rlim_cur = std::min(now.rlim_cur, to);
  ::setrlimit(what, &now);
}

/// Makes the child ready: it is silent, leaves no memory dump, and ends where it goes wrong.
void prepare_child(const ReadingLimits& limits) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing >= 0)
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  sigset_t own;
  sigemptyset(&own);
  for (const int crash : k_crashes) sigaddset(&own, crash);
  sigaddset(&own, SIGXCPU);
  for (int number = 1; number < NSIG; ++number)
    if (sigismember(&own, number) == 1) ::signal(number, SIG_DFL);
  ::pthread_sigmask(SIG_UNBLOCK, &own, nullptr);
  ::prctl(PR_SET_DUMPABLE, 0);
  lower_limit(RLIMIT_CORE, 0);
  lower_limit(RLIMIT_CPU, limits.seconds);
  if (const std::size_t now = address_space(); now > 0) lower_limit(RLIMIT_AS, now + limits.memory);
}

struct Start {
  const std::function<void(int)>& serve;
  const ReadingLimits& limits;
  int own_end, child_end;  ///< of the socket
  pid_t child = -1;
  int error = 0;
};

/// HDF5 calls this with its lock held, so that no other thread is within HDF5 while the process is copied.
herr_t fork_child(hid_t, const char*, void* data) {
  auto& start = *static_cast<Start*>(data);
  start.child = ::fork();
  start.error = errno;
  if (start.child != 0) return 1;
  ::close(start.own_end);  // so that the child sees the end of this process
  prepare_child(start.limits);
  try {
    start.serve(start.child_end);
  } catch (...) {
    ::_exit(1);
  }
  ::_exit(0);
}

/// The processor time of a child [s]; negative where it cannot be told.
double processor_time(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return -1;
  constexpr double k_nano = 1e-9;
  return static_cast<double>(time.tv_sec) + k_nano * static_cast<double>(time.tv_nsec);
}

/// Whether a child sleeps: neither computes, nor waits for a disk, nor was stopped.
bool sleeps(pid_t child) {
  std::array<char, 512> text{};
  const int file = ::open(("/proc/" + std::to_string(child) + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const ssize_t length = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  const char* const name_end = length > 0 ? std::strrchr(text.data(), ')') : nullptr;
  return name_end != nullptr && std::strncmp(name_end, ") S", 3) == 0;
}

}  // namespace

bool send_bytes(int socket, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

ReadingProcess::ReadingProcess(std::string path, ReadingLimits limits, const std::function<void(int)>& serve)
    : path_(std::move(path)), limits_(limits) {
  std::array<int, 2> sockets{};
  const auto fail = [&](int error) {
    throw FileError(path_ + ": cannot be read: no process could be started for it: " + std::strerror(error));
  };
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) fail(errno);
  socket_ = sockets[0];
  Start start{serve, limits_, sockets[0], sockets[1]};
  {
    // Here a command that resumes calls HDF5 first, whose handler at the end crashes where a file could not be written.
    const Hdf5Silence silence;
    // Any list with a property will do for the call.
    const Hdf5Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Piterate(list.get(), nullptr, fork_child, &start);
  }
  ::close(sockets[1]);
  child_ = start.child;
  if (child_ < 0) {
    ::close(socket_);
    fail(start.error);
  }
}

ReadingProcess::~ReadingProcess() { end(); }

/// Ends the child, and returns how it ended; -1 where somebody else has asked for that already. A child that ends by
/// itself keeps its own signal.
int ReadingProcess::end() {
  if (child_ < 0) return -1;
  ::kill(child_, SIGKILL);
  ::close(socket_);
  int status = -1;
  pid_t ended = -1;
  while ((ended = ::waitpid(child_, &status, 0)) < 0 && errno == EINTR) {
  }
  child_ = socket_ = -1;
  return ended < 0 ? -1 : status;
}

void ReadingProcess::tell_end() {
  const int status = end();
  const std::string damaged = path_ + ": is damaged: HDF5 itself ";
  if (status < 0 || !WIFSIGNALED(status)) throw InputError(damaged + "ended at it");
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU)
    throw InputError(damaged + "took more than " + std::to_string(limits_.seconds) + " s of processor time for it");
  if (std::find(k_crashes.begin(), k_crashes.end(), signal) != k_crashes.end())
    throw InputError(damaged + "crashed at it (signal " + std::to_string(signal) + ")");
  throw FileError(path_ + ": cannot be read: the process that read it was ended by signal " + std::to_string(signal));
}

void ReadingProcess::refuse_answer() {
  end();
  throw InputError(path_ + ": is damaged: HDF5 itself went wrong at it");
}

/// Waits until the child has sent something or has ended. A child that sleeps for long waits for what never comes.
void ReadingProcess::await() {
  constexpr int k_look = 1000, k_patience = 60;  // [ms] and looks
  double used = -1;
  for (int idle = 0;;) {
    pollfd one{socket_, POLLIN, 0};
    const int ready = ::poll(&one, 1, k_look);
    if (ready > 0) return;
    if (ready < 0) continue;
    const double now = processor_time(child_);
    idle = now == used && sleeps(child_) ? idle + 1 : 0;
    used = now;
    if (idle < k_patience) continue;
    end();
    throw FileError(path_ + ": cannot be read: the process that read it waited without end");
  }
}

void ReadingProcess::send(std::span<const char> bytes) {
  if (child_ < 0) refuse_answer();
  if (!send_bytes(socket_, bytes)) tell_end();
}

void ReadingProcess::receive(std::span<char> bytes) {
  if (child_ < 0) refuse_answer();
  while (!bytes.empty()) {
    await();
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) tell_end();
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

}  // namespace nilas::hdf5
