#pragma once
/// Tables of numbers in CSV files: a header row with column names, then rows of numbers.
#include <string>
#include <vector>

namespace nilas {

struct CsvTable {
  std::vector<std::vector<double>> rows;  ///< each in the order of the columns that were asked for
  std::vector<int> lines;                 ///< 1-based line of each row in its file
};

/// Reads a file that has exactly `columns`, in any order; blank lines and lines that begin with # are skipped, blanks
/// around a field too. Throws FileError when the file cannot be read, and InputError "file:line:column: ..." for a
/// missing, unknown or repeated column, a row with too few or too many fields, a field that is no finite number, or a
/// table without rows.
CsvTable read_csv(const std::string& file, const std::vector<std::string>& columns);

}  // namespace nilas
