#include "hydro/database/wamit_rows.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace nilas::hydro {

/// The word as C++ writes it: D as E, and an E before an exponent of three digits that has none.
static std::string plain_exponent(std::string word) {
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == 'D' || c == 'd' || c == 'E'; }, 'e');
  if (!word.empty() && word.front() == '+') word.erase(0, 1);
  const std::size_t sign = word.find_last_of("+-");
  if (sign != std::string::npos && sign > 0 && word[sign - 1] != 'e') word.insert(sign, "e");
  return word;
}

static std::optional<double> number_in(const std::string& written) {
  const std::string word = plain_exponent(written);
  double value = 0;
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  // A number too small for a double is zero to every use that is made of it.
  const bool too_small = fault == std::errc::result_out_of_range && word.find("e-") != std::string::npos;
  if (too_small) return 0.0;
  if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

WamitRows::WamitRows(const std::filesystem::path& file, std::initializer_list<int> columns) : file_(file.string()) {
  std::istringstream text(file_bytes(file, k_most_text_bytes));
  std::string line;
  for (int n = 1; std::getline(text, line); ++n) add(line, n, columns);
  if (rows_.empty()) throw InputError(file_ + ": holds no rows of numbers");
}

void WamitRows::refuse(int line, const std::string& fault) const {
  throw InputError(file_ + ":" + std::to_string(line) + ": " + fault);
}

void WamitRows::add(const std::string& text, int line, std::initializer_list<int> columns) {
  std::istringstream words(text);
  WamitRow row{line, {}};
  for (std::string word; words >> word;) {
    const auto value = number_in(word);
    if (!value && row.values.empty() && line == 1) return;
    if (!value) refuse(line, "found '" + word + "'; allowed: a finite number");
    row.values.push_back(*value);
  }
  if (row.values.empty()) return;
  const int found = static_cast<int>(row.values.size());
  if (std::find(columns.begin(), columns.end(), found) == columns.end()) {
    std::string allowed;
    for (const int n : columns) allowed += (allowed.empty() ? "" : " or ") + std::to_string(n);
    refuse(line, "found " + std::to_string(found) + " columns; allowed: " + allowed);
  }
  rows_.push_back(std::move(row));
}

int WamitRows::mode(const WamitRow& row, int column) const {
  constexpr int k_modes = 6;
  const double value = row.values[column];
  if (value != std::round(value) || value < 1 || value > k_modes) {
    std::ostringstream found;
    found << value;
    refuse(row.line, "found mode " + found.str() + "; allowed: 1 to 6, the modes of one rigid body");
  }
  return static_cast<int>(value) - 1;
}

}  // namespace nilas::hydro
