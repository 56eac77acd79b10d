#include "core/output/file/csv_row.h"

#include <array>
#include <charconv>

namespace nilas::output {

namespace {

/// Buffer for one number: the longest fixed-point double has 309 digits before the point.
using NumberText = std::array<char, 400>;

std::string_view view(const NumberText& text, const char* end) {
  return {text.data(), static_cast<std::size_t>(end - text.data())};
}

}  // namespace

void CsvRow::separate() {
  if (!line_.empty()) line_ += ',';
}

CsvRow& CsvRow::fixed(double x) {
  separate();
  NumberText text;
  auto* end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed, k_decimals).ptr;
  std::string_view digits = view(text, end);
  if (digits.front() == '-' && digits.find_first_not_of("-0.") == std::string_view::npos) digits.remove_prefix(1);
  line_ += digits;
  return *this;
}

CsvRow& CsvRow::shortest(double x) {
  separate();
  NumberText text;
  line_ += view(text, std::to_chars(text.data(), text.data() + text.size(), x).ptr);
  return *this;
}

CsvRow& CsvRow::full(double x) {
  constexpr int k_round_trip_digits = 17;
  separate();
  NumberText text;
  const auto result =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, k_round_trip_digits);
  line_ += view(text, result.ptr);
  return *this;
}

CsvRow& CsvRow::integer(std::int64_t n) {
  separate();
  line_ += std::to_string(n);
  return *this;
}

CsvRow& CsvRow::hexadecimal(std::uint64_t n) {
  constexpr int k_base = 16;
  constexpr std::size_t k_digits = 16;
  separate();
  NumberText text;
  const std::string_view digits = view(text, std::to_chars(text.data(), text.data() + text.size(), n, k_base).ptr);
  line_.append(k_digits - digits.size(), '0').append(digits);
  return *this;
}

CsvRow& CsvRow::text(std::string_view word) {
  separate();
  if (word.find_first_of(",\"\r\n") == std::string_view::npos) {
    line_ += word;
    return *this;
  }
  line_ += '"';
  for (const char c : word) line_.append(c == '"' ? 2 : 1, c);
  line_ += '"';
  return *this;
}

std::string_view CsvRow::line() {
  line_ += '\n';
  return line_;
}

std::string csv_header(const std::vector<std::string>& names) {
  CsvRow row;
  for (const auto& name : names) row.text(name);
  return std::string(row.line());
}

}  // namespace nilas::output
