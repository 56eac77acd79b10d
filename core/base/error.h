#pragma once
/// Error types of the program's edge; see docs/reference/conventions.md for the exit codes they map to.
#include <stdexcept>
#include <string>
#include <vector>

namespace nilas {

/// Exit codes of every command.
enum ExitCode { exit_done = 0, exit_bad_input = 2, exit_numerics = 3, exit_file = 4, exit_interrupted = 130 };
/// Exit codes of a child process as a shell has them: it could not be started, or ended by a signal whose number is
/// added.
constexpr int k_exit_not_started = 127, k_exit_signal = 128;

/// One fault in a scene or input file.
struct Fault {
  std::string file;
  int line = 0;             ///< 1-based, 0 when the fault has no place
  int column = 0;           ///< 1-based, 0 when unknown
  std::string where;        ///< element or attribute path, e.g. "<vessel><mass value>"
  std::string message;      ///< found value, allowed values, nearest name
  bool unreadable = false;  ///< a file named there cannot be opened

  /// "file:line:column: where: message"
  std::string text() const;
};

/// Wrong input: every fault found, thrown together. Exit code 2, or 4 where all of them are files that cannot be
/// opened.
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }
  bool only_unreadable_files() const;

 private:
  std::vector<Fault> faults_;
};

/// Wrong content of an input file or wrong usage, without a scene position. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that cannot be opened, read or written. Exit code 4.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The numerics failed (a body left finite numbers, a solver stopped under on_failure="stop"). Exit code 3.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user asked the program to stop while it waited for something outside. Exit code 130.
class Interruption : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A broken contract between our own functions; a defect of the program.
class ContractError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] void contract_failed(const char* expression, const char* file, int line);

/// Nearest of `candidates` to `word` by edit distance, or "" when none is close: about one edit in three letters
/// of the word, rounded, and none in a single letter.
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace nilas

/// Cheap check that stays on in every build; throws ContractError with expression and place.
#define NILAS_DEMAND(expression) ((expression) ? void(0) : ::nilas::contract_failed(#expression, __FILE__, __LINE__))
