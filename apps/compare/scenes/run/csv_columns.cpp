#include "apps/compare/scenes/run/csv_columns.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

#include "core/base/error.h"

namespace nilas {

namespace {

/// Cells of a line; quoted ones may hold commas.
void split(const std::string& line, std::vector<std::string_view>& cells) {
  cells.clear();
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t k = 0; k <= line.size(); ++k) {
    if (k < line.size() && line[k] == '"') quoted = !quoted;
    if (k < line.size() && (line[k] != ',' || quoted)) continue;
    cells.push_back(std::string_view(line).substr(begin, k - begin));
    begin = k + 1;
  }
}

double number(std::string_view cell) {
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size() ? value : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

std::vector<std::vector<double>> csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names) {
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw FileError(file.string() + ": cannot be read");
  std::vector<std::string_view> cells;
  split(line, cells);
  std::vector<std::size_t> places;
  for (const auto& name : names) {
    const auto found = std::find(cells.begin(), cells.end(), name);
    if (found == cells.end()) throw InputError(file.string() + ": no column '" + name + "'");
    places.push_back(static_cast<std::size_t>(found - cells.begin()));
  }
  const std::size_t width = cells.size();
  std::vector<std::vector<double>> columns(names.size());
  while (std::getline(in, line)) {
    if (in.eof()) break;  // without its line end a row is not whole
    split(line, cells);
    if (cells.size() != width) break;
    for (std::size_t k = 0; k < places.size(); ++k) columns[k].push_back(number(cells[places[k]]));
  }
  return columns;
}

}  // namespace nilas
