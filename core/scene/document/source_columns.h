#pragma once
/// The XML parser knows lines only; the columns come from the text. Ask in document order.
#include <cstddef>
#include <string>
#include <vector>

namespace nilas {

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
    std::size_t cursor = 0;  ///< what lies before was asked for
  };
  Line* find(int line);
  std::vector<Line> lines_;
};

/// Characters (not bytes) of UTF-8 text before `byte`, plus one.
int column_of(const std::string& line, std::size_t byte);

}  // namespace nilas
