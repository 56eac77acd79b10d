#pragma once
/// Words of a mesh file in text form.
#include <string>
#include <string_view>

namespace nilas::geometry {

/// Where a text begins in its file, and what in it is no word.
struct WordRules {
  char comment = 0;     ///< mark that starts a comment to the end of its line; 0: there are no comments
  bool joined = false;  ///< a backslash at the end of a line, but for a comment's, joins it to the next
  int first_line = 1;
};

/// Gives the words of a text one after the other and knows their line. Keeps references to text and file name. A byte
/// order mark before the first line is left out.
class MeshWords {
 public:
  MeshWords(std::string_view text, const std::string& file, const WordRules& rules = {});

  /// Next word as written, "" at the end.
  std::string_view next();
  /// Next word on the current line and those joined to it, "" where none is left.
  std::string_view next_on_line();
  /// Next word in small letters: writers disagree on the case of keywords.
  std::string next_keyword();
  /// Takes the next word. Throws InputError naming file and line unless it is the keyword, in any case.
  void expect(const std::string& keyword);
  /// A finite number. Throws InputError naming file and line, as do the two below.
  double number() { return number(next()); }
  double number(std::string_view word) const;
  long long integer() { return integer(next()); }
  long long integer(std::string_view word) const;
  /// Skips to the end of the line, with any content: free text is not joined to the next line.
  void skip_line();
  /// Skips to the end of the line and of those joined to it.
  void skip_joined_lines();
  /// Throws InputError naming file, line, what was expected and what was found there ("": the end).
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const;

 private:
  /// Skips to the next word; stops at the end of the line if `within_line`.
  void skip_blanks(bool within_line);
  std::string_view word();
  /// Bytes of the mark here that joins a line to the next; 0 where there is none.
  std::size_t joint() const;

  std::string_view text_;
  const std::string& file_;
  WordRules rules_;
  std::size_t place_ = 0;
  int line_;
};

}  // namespace nilas::geometry
