#pragma once
/// Words of a mesh file in text form.
#include <string>
#include <string_view>

namespace nilas {

/// Gives the words of a text one after the other and knows their line. Keeps references to text and file name.
class MeshWords {
 public:
  /// From the mark `comment` to the end of its line is left out; 0: there are no comments.
  MeshWords(std::string_view text, const std::string& file, char comment = 0, int first_line = 1)
      : text_(text), file_(file), comment_(comment), line_(first_line) {}

  /// Next word as written, "" at the end.
  std::string_view next();
  /// Next word on the current line, "" where none is left.
  std::string_view next_on_line();
  /// Next word in small letters: writers disagree on the case of keywords.
  std::string next_keyword();
  void expect(const std::string& keyword);
  /// A finite number. Throws InputError naming file and line, as do the two below.
  double number() { return number(next()); }
  double number(std::string_view word) const;
  long long integer() { return integer(next()); }
  long long integer(std::string_view word) const;
  void skip_line();
  [[noreturn]] void fail(const std::string& expected, std::string_view found) const;

 private:
  /// To the next word; stops at the end of the line where `within_line`.
  void skip_blanks(bool within_line);
  std::string_view word();

  std::string_view text_;
  const std::string& file_;
  char comment_;
  std::size_t place_ = 0;
  int line_;
};

}  // namespace nilas
