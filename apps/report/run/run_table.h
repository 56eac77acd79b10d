#pragma once
/// A table of a run, as far as it was written.
#include <filesystem>
#include <string>
#include <vector>

namespace nilas::report {

/// The columns of a CSV file of a run up to its last complete row.
class RunTable {
 public:
  RunTable() = default;
  /// Throws FileError where the file cannot be read, InputError where it has no column time_s.
  explicit RunTable(const std::filesystem::path& file);

  std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  const std::vector<std::string>& names() const { return names_; }
  bool has(const std::string& name) const;
  /// The values of a column; cells that are no number are NaN. Throws InputError where there is no such column.
  const std::vector<double>& operator[](const std::string& name) const;
  /// The texts of a column. Throws as above.
  std::vector<std::string> texts(const std::string& name) const;
  const std::vector<double>& time() const { return (*this)["time_s"]; }

 private:
  std::filesystem::path file_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
  std::size_t place_of(const std::string& name) const;
};

}  // namespace nilas::report
