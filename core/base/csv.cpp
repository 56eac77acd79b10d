#include "core/base/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "core/base/error.h"

namespace nilas {

namespace {

constexpr std::string_view k_blank = " \t\r";
constexpr std::string_view k_byte_order_mark = "\xEF\xBB\xBF";

struct Field {
  std::string_view text;
  std::size_t column = 1;  ///< 1-based, of its first character
};

std::vector<Field> split(std::string_view line) {
  std::vector<Field> fields;
  for (std::size_t start = 0;;) {
    const std::size_t end = std::min(line.find(',', start), line.size());
    const std::size_t first = std::min(line.find_first_not_of(k_blank, start), end);
    std::string_view text = line.substr(first, end - first);
    text = text.substr(0, text.find_last_not_of(k_blank) + 1);
    fields.push_back({text, first + 1});
    if (end == line.size()) return fields;
    start = end + 1;
  }
}

std::string list(const std::vector<std::string>& names) {
  std::string s;
  for (const auto& name : names) s += (s.empty() ? "" : ",") + name;
  return s;
}

class CsvReader {
 public:
  CsvReader(const std::string& file, const std::vector<std::string>& columns) : file_(file), columns_(columns) {}

  CsvTable read() {
    std::ifstream in(file_);
    if (!in) throw FileError(file_ + ": cannot be opened");
    CsvTable table;
    std::string line;
    while (std::getline(in, line)) {
      ++line_;
      std::string_view text = line;
      if (line_ == 1 && text.starts_with(k_byte_order_mark)) text.remove_prefix(k_byte_order_mark.size());
      const std::size_t first = text.find_first_not_of(k_blank);
      if (first == std::string_view::npos || text[first] == '#') continue;
      if (place_.empty()) {
        read_header(split(text));
      } else {
        table.rows.push_back(read_row(split(text)));
        table.lines.push_back(line_);
      }
    }
    if (in.bad()) throw FileError(file_ + ": cannot be read");
    if (place_.empty()) throw InputError(file_ + ": empty; expected the header " + list(columns_));
    if (table.rows.empty()) throw InputError(file_ + ": no rows below the header");
    return table;
  }

 private:
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const {
    throw InputError(file_ + ":" + std::to_string(line_) + ":" + std::to_string(column) + ": " + message);
  }

  void read_header(const std::vector<Field>& fields) {
    std::vector<bool> seen(columns_.size(), false);
    for (const auto& field : fields) {
      const auto found = std::find(columns_.begin(), columns_.end(), field.text);
      if (found == columns_.end()) refuse_name(field);
      const auto k = static_cast<std::size_t>(found - columns_.begin());
      if (seen[k]) refuse(field.column, "column '" + columns_[k] + "' stands twice");
      seen[k] = true;
      place_.push_back(k);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (!seen[k]) refuse(1, "column '" + columns_[k] + "' is missing; the header must have " + list(columns_));
  }

  [[noreturn]] void refuse_name(const Field& field) const {
    const std::string name(field.text);
    const std::string nearest = nearest_name(name, columns_);
    refuse(field.column, "unknown column '" + name + "'; the header must have " + list(columns_) +
                             (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)"));
  }

  std::vector<double> read_row(const std::vector<Field>& fields) const {
    if (fields.size() != columns_.size())
      refuse(fields.back().column, "found " + std::to_string(fields.size()) + " fields, expected " +
                                       std::to_string(columns_.size()) + ": " + list(columns_));
    std::vector<double> row(columns_.size());
    for (std::size_t i = 0; i < fields.size(); ++i) row[place_[i]] = number(fields[i]);
    return row;
  }

  double number(const Field& field) const {
    std::string_view text = field.text;
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value))
      refuse(field.column, "'" + std::string(field.text) + "' is no finite number");
    return value;
  }

  const std::string& file_;
  const std::vector<std::string>& columns_;
  std::vector<std::size_t> place_;  ///< of each of the file's fields in a row of the table
  int line_ = 0;
};

}  // namespace

CsvTable read_csv(const std::string& file, const std::vector<std::string>& columns) {
  return CsvReader(file, columns).read();
}

}  // namespace nilas
