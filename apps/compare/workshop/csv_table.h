#pragma once
/// CSV tables that both kinds of study write. Each column has its name and the function of its cells together.
#include <functional>
#include <string>
#include <vector>

#include "core/output/file/csv_row.h"

namespace nilas::compare {

/// The cell of a column, on a row that is being written. A number that is not finite leaves its cell empty.
class CsvCell {
 public:
  explicit CsvCell(output::CsvRow& row) : row_(row) {}
  void operator=(double value);
  void operator=(int value) { row_.integer(value); }
  void operator=(bool value) { row_.integer(value ? 1 : 0); }
  void operator=(const std::string& text) { row_.text(text); }
  void operator=(const char* text) { row_.text(text); }

 private:
  output::CsvRow& row_;
};

template <class Row>
struct CsvColumn {
  std::string name;
  std::function<void(const Row&, CsvCell)> write;
};

template <class Row>
std::string csv_text(const std::vector<CsvColumn<Row>>& columns, const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const auto& column : columns) names.push_back(column.name);
  std::string text = output::csv_header(names);
  for (const auto& row : rows) {
    output::CsvRow cells;
    for (const auto& column : columns) column.write(row, CsvCell(cells));
    text += cells.line();
  }
  return text;
}

/// The sentence with semicolons for commas, for programs that do not know quoted cells.
std::string without_commas(std::string sentence);
/// The numbers as a list: "0;1".
std::string list_text(const std::vector<int>& numbers);

}  // namespace nilas::compare
