#pragma once
/// What a study says on the terminal while it runs.
#include <string>

namespace nilas {

class Narrator {
 public:
  /// `json`: standard output is for JSON alone, so that words go to standard error. `quiet`: no words but warnings.
  Narrator(bool json, bool quiet) : json_(json), quiet_(quiet) {}

  /// One line as it is.
  void line(const std::string& text) const;
  /// Sentences, one a line: broken to the width of a terminal, left whole for a file or a pipe; a command, which begins
  /// with two blanks, stays whole.
  void sentences(const std::string& text) const;
  /// On standard error, whatever was asked for.
  static void warning(const std::string& sentence);
  bool quiet() const { return quiet_; }

 private:
  bool json_, quiet_;
};

}  // namespace nilas
