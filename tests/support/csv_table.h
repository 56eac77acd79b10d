#pragma once
/// Reads CSV files whose cells hold no commas.
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/file_text.h"

namespace nilas::test {

/// Returns the cells of a row.
inline std::vector<std::string> cells_of(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

/// A CSV file as columns by name. Cells that are not numbers read as NaN.
class Table {
 public:
  /// Throws std::runtime_error for an empty file and for a row with another number of cells than the header.
  explicit Table(const std::filesystem::path& file) {
    const std::vector<std::string> lines = lines_of(file);
    if (lines.empty()) throw std::runtime_error(file.string() + ": empty");
    header_ = cells_of(lines[0]);
    columns_.resize(header_.size());
    text_.resize(header_.size());
    for (std::size_t row = 1; row < lines.size(); ++row) {
      const std::vector<std::string> cells = cells_of(lines[row]);
      if (cells.size() != header_.size()) throw std::runtime_error(file.string() + ": ragged row: " + lines[row]);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        char* end = nullptr;
        const double x = std::strtod(cells[i].c_str(), &end);
        columns_[i].push_back(end == cells[i].c_str() ? std::numeric_limits<double>::quiet_NaN() : x);
        text_[i].push_back(cells[i]);
      }
    }
  }
  bool has(const std::string& name) const { return find(name) < header_.size(); }
  const std::vector<double>& operator[](const std::string& name) const { return columns_[demand(name)]; }
  const std::vector<std::string>& text(const std::string& name) const { return text_[demand(name)]; }
  std::size_t rows() const { return columns_.empty() ? 0 : columns_[0].size(); }
  const std::vector<std::string>& header() const { return header_; }

 private:
  std::size_t find(const std::string& name) const {
    for (std::size_t i = 0; i < header_.size(); ++i)
      if (header_[i] == name) return i;
    return header_.size();
  }
  std::size_t demand(const std::string& name) const {
    const std::size_t i = find(name);
    if (i == header_.size()) throw std::runtime_error("no column " + name);
    return i;
  }
  std::vector<std::string> header_;
  std::vector<std::vector<double>> columns_;
  std::vector<std::vector<std::string>> text_;
};

}  // namespace nilas::test
