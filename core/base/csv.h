#pragma once
/// Tables in CSV files: a header row with column names, then one row per line.
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace nilas {

/// The fields of one line, which may stand in quotes (RFC 4180) and then hold commas and doubled quotes. A row never
/// spans several lines.
class CsvLine {
 public:
  /// Replaces the fields by those of `line`.
  void split(std::string_view line);
  std::size_t size() const { return fields_.size(); }
  /// Text of a field, valid until the next split().
  std::string_view operator[](std::size_t k) const;
  /// 1-based column of the field's first character in the line.
  std::size_t column(std::size_t k) const { return fields_[k].column; }

 private:
  struct Field {
    std::size_t begin, end, column;
  };
  std::string text_;  ///< texts of all fields, without quotes
  std::vector<Field> fields_;
};

/// Value of a field that is a number and nothing else; NaN otherwise.
double csv_number(std::string_view field);

struct CsvTable {
  std::vector<std::vector<double>> rows;  ///< each in the order of the columns that were asked for
  std::vector<int> lines;                 ///< 1-based line of each row in its file
};

/// Reads a user's file that has exactly `columns`, in any order; blank lines and lines that begin with # are skipped,
/// blanks around a field too. Throws FileError when the file cannot be read, and InputError "file:line:column: ..." for
/// a missing, unknown or repeated column, a row with too few or too many fields, a field that is no finite number, or a
/// table without rows.
CsvTable read_csv(const std::string& file, const std::vector<std::string>& columns);

/// Reads the named columns of a file that a run wrote, up to its last complete row, since a run may have been killed
/// while it wrote. A field that is no number is NaN. Throws FileError where the file cannot be read and InputError
/// where a column is missing.
std::vector<std::vector<double>> csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names);

/// The complete rows of a file as text.
struct CsvRecords {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< row k stands in line k + 2
  std::int64_t bytes = 0;                      ///< bytes of the header and the complete rows
};
/// Throws FileError where the file cannot be read.
CsvRecords csv_records(const std::filesystem::path& file);

}  // namespace nilas
