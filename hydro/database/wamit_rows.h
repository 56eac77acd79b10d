#pragma once
/// Rows of numbers in WAMIT's result files.
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace nilas::hydro {

struct WamitRow {
  int line = 0;  ///< 1-based
  std::vector<double> values;
};

/// One file as rows of finite numbers. A first line that does not begin with a number is WAMIT's heading; empty lines
/// are passed over. Exponents may be written as Fortran does, 1.0D-05 and 1.0-105. Throws FileError where the file
/// cannot be read. Throws InputError with file and line for anything else, also for a row whose number of columns is
/// not among `columns`, and for a file without a row.
class WamitRows {
 public:
  WamitRows(const std::filesystem::path& file, std::initializer_list<int> columns);
  const std::vector<WamitRow>& rows() const { return rows_; }
  /// Refuses a row: "FILE:LINE: fault".
  [[noreturn]] void refuse(int line, const std::string& fault) const;
  /// The mode 0 to 5 of column `column`, which holds 1 to 6.
  int mode(const WamitRow& row, int column) const;

 private:
  void add(const std::string& text, int line, std::initializer_list<int> columns);

  std::string file_;
  std::vector<WamitRow> rows_;
};

}  // namespace nilas::hydro
