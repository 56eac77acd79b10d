#pragma once
/// One line of a CSV file, independent of the locale.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nilas::output {

class CsvRow {
 public:
  /// Writes fixed-point with k_decimals digits after the point. A value that rounds to zero has no sign.
  CsvRow& fixed(double x);
  /// Writes the fewest digits that read back to the same bits.
  CsvRow& shortest(double x);
  /// Writes 17 significant digits, which read back to the same bits.
  CsvRow& full(double x);
  CsvRow& integer(std::int64_t n);
  /// Writes 16 hexadecimal digits.
  CsvRow& hexadecimal(std::uint64_t n);
  /// Writes a text, quoted when it contains a comma, a quote or a line break (RFC 4180).
  CsvRow& text(std::string_view word);
  /// Returns the row with its line end. After clear(), the next value starts a new row.
  std::string_view line();
  void clear() { line_.clear(); }

  /// Decimals of fixed(): at 0.01 s steps and 1500 kg, rounding a velocity shifts m dv/dt by 1.5e-7 N only.
  static constexpr int k_decimals = 12;

 private:
  void separate();
  std::string line_;
};

/// Comma-separated names with a line end.
std::string csv_header(const std::vector<std::string>& names);

}  // namespace nilas::output
