#include "core/base/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas {

namespace {

constexpr std::string_view k_blank = " \t\r";
/// Longest line of a user's table; a few columns take far less.
constexpr std::size_t k_longest_line = 1 << 16;
constexpr std::string_view k_byte_order_mark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(k_blank), text.size()));
  return text.substr(0, text.find_last_not_of(k_blank) + 1);
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
    const std::string bytes = file_bytes(file_, k_most_text_bytes);
    CsvTable table;
    for (std::size_t begin = 0; begin < bytes.size();) {
      const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
      std::string_view text = std::string_view(bytes).substr(begin, end - begin);
      begin = end + 1;
      ++line_;
      if (text.size() > k_longest_line)
        refuse(1, "the line has more than " + std::to_string(k_longest_line) + " bytes");
      if (line_ == 1 && text.starts_with(k_byte_order_mark)) text.remove_prefix(k_byte_order_mark.size());
      const std::size_t first = text.find_first_not_of(k_blank);
      if (first == std::string_view::npos || text[first] == '#') continue;
      fields_.split(text);
      if (place_.empty()) {
        read_header();
      } else {
        table.rows.push_back(read_row());
        table.lines.push_back(line_);
      }
    }
    if (place_.empty()) throw InputError(file_ + ": empty; expected the header " + list(columns_));
    if (table.rows.empty()) throw InputError(file_ + ": no rows below the header");
    return table;
  }

 private:
  std::string_view field(std::size_t k) const { return trimmed(fields_[k]); }
  /// 1-based, of the field's first character that is not blank.
  std::size_t column(std::size_t k) const {
    const std::string_view text = fields_[k];
    return fields_.column(k) + std::min(text.find_first_not_of(k_blank), text.size());
  }

  [[noreturn]] void refuse(std::size_t column, const std::string& message) const {
    throw InputError(file_ + ":" + std::to_string(line_) + ":" + std::to_string(column) + ": " + message);
  }

  void read_header() {
    std::vector<bool> seen(columns_.size(), false);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto found = std::find(columns_.begin(), columns_.end(), field(i));
      if (found == columns_.end()) refuse_name(i);
      const auto k = static_cast<std::size_t>(found - columns_.begin());
      if (seen[k]) refuse(column(i), "column '" + columns_[k] + "' stands twice");
      seen[k] = true;
      place_.push_back(k);
    }
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (!seen[k]) refuse(1, "column '" + columns_[k] + "' is missing; the header must have " + list(columns_));
  }

  [[noreturn]] void refuse_name(std::size_t i) const {
    const std::string name(field(i));
    const std::string nearest = nearest_name(name, columns_);
    refuse(column(i), "unknown column '" + name + "'; the header must have " + list(columns_) +
                          (nearest.empty() ? "" : " (did you mean '" + nearest + "'?)"));
  }

  std::vector<double> read_row() const {
    if (fields_.size() != columns_.size())
      refuse(column(fields_.size() - 1), "found " + std::to_string(fields_.size()) + " fields, expected " +
                                             std::to_string(columns_.size()) + ": " + list(columns_));
    std::vector<double> row(columns_.size());
    for (std::size_t i = 0; i < fields_.size(); ++i) row[place_[i]] = number(i);
    return row;
  }

  double number(std::size_t i) const {
    std::string_view text = field(i);
    if (text.starts_with('+')) text.remove_prefix(1);
    const double value = csv_number(text);
    if (!std::isfinite(value)) refuse(column(i), "'" + std::string(field(i)) + "' is no finite number");
    return value;
  }

  const std::string& file_;
  const std::vector<std::string>& columns_;
  CsvLine fields_;
  std::vector<std::size_t> place_;  ///< column of each of the file's fields in a row of the table
  int line_ = 0;
};

}  // namespace

void CsvLine::split(std::string_view line) {
  text_.clear();
  fields_.clear();
  fields_.push_back({0, 0, 1});
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"')
      text_ += line[++k];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      fields_.push_back({text_.size(), text_.size(), k + 2});
    else
      text_ += c;
    fields_.back().end = text_.size();
  }
}

std::string_view CsvLine::operator[](std::size_t k) const {
  return std::string_view(text_).substr(fields_[k].begin, fields_[k].end - fields_[k].begin);
}

double csv_number(std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  const bool whole = error == std::errc() && end == field.data() + field.size();
  return whole ? value : std::numeric_limits<double>::quiet_NaN();
}

CsvTable read_csv(const std::string& file, const std::vector<std::string>& columns) {
  return CsvReader(file, columns).read();
}

std::vector<std::vector<double>> csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names) {
  demand_file(file);
  std::ifstream in(file);
  std::string line;
  if (!in || !std::getline(in, line)) throw FileError(file.string() + ": cannot be read");
  CsvLine fields;
  fields.split(line);
  const std::size_t width = fields.size();
  std::vector<std::size_t> places;
  for (const auto& name : names) {
    std::size_t k = 0;
    while (k < width && fields[k] != name) ++k;
    if (k == width) throw InputError(file.string() + ": no column '" + name + "'");
    places.push_back(k);
  }
  std::vector<std::vector<double>> columns(names.size());
  while (std::getline(in, line)) {
    if (in.eof()) break;  // without its line end a row is not complete
    fields.split(line);
    if (fields.size() != width) break;
    for (std::size_t k = 0; k < places.size(); ++k) columns[k].push_back(csv_number(fields[places[k]]));
  }
  return columns;
}

CsvRecords csv_records(const std::filesystem::path& file) {
  const std::string text = file_bytes(file);
  CsvRecords records;
  CsvLine fields;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    fields.split(std::string_view(text).substr(begin, end - begin));
    std::vector<std::string> row;
    for (std::size_t k = 0; k < fields.size(); ++k) row.emplace_back(fields[k]);
    if (begin == 0)
      records.header = std::move(row);
    else
      records.rows.push_back(std::move(row));
  }
  records.bytes = static_cast<std::int64_t>(begin);
  return records;
}

}  // namespace nilas
