#pragma once
/// The messages of a study on the terminal while it runs.
#include <string>

namespace nilas::compare {

class Narrator {
 public:
  /// `json`: messages go to standard error, because standard output is for JSON alone. `quiet`: only warnings are
  /// printed.
  Narrator(bool json, bool quiet) : json_(json), quiet_(quiet) {}

  /// Prints one line as it is.
  void line(const std::string& text) const;
  /// Prints sentences, one per line. They are wrapped to the width of a terminal, but not for a file or a pipe. A
  /// command, which begins with two blanks, is not wrapped.
  void sentences(const std::string& text) const;
  /// Prints a warning on standard error, even if the study is quiet.
  static void warning(const std::string& sentence);
  bool quiet() const { return quiet_; }

 private:
  bool json_, quiet_;
};

}  // namespace nilas::compare
