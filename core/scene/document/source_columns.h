#pragma once
/// Finds columns in the text, because the XML parser knows only lines. Call in document order. The columns of lines
/// longer than 64 kB are not known: to search in them for thousands of elements takes long.
#include <cstddef>
#include <string>
#include <vector>

namespace nilas::scene {

class SourceColumns {
 public:
  explicit SourceColumns(const std::string& text);
  /// Column of the next "<name" of a line, 0 when there is none.
  int tag(int line, const std::string& name);
  /// Column of the next `name=` of a line, 0 when there is none.
  int attribute(int line, const std::string& name);

 private:
  struct Line {
    std::string text;        ///< comments blanked out
    std::size_t cursor = 0;  ///< everything before it was already requested
    std::size_t byte = 0;    ///< newest place whose column was asked for
    int column = 1;          ///< its column
  };
  Line* find(int line);
  static int column_in(Line& line, std::size_t byte);
  std::vector<Line> lines_;
};

/// Column of the character at `byte` in UTF-8 text: the number of characters before it plus one.
int column_of(const std::string& line, std::size_t byte);

}  // namespace nilas::scene
