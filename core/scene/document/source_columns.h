#pragma once
/// Finds columns in the text, because the XML parser knows only lines. Call in document order.
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
  };
  Line* find(int line);
  std::vector<Line> lines_;
};

/// Column of the character at `byte` in UTF-8 text: the number of characters before it plus one.
int column_of(const std::string& line, std::size_t byte);

}  // namespace nilas::scene
