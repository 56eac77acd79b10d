#pragma once
/// One line of a CSV file, independent of the locale.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace nilas {

class CsvRow {
 public:
  /// Fixed-point with k_decimals digits after the point; what rounds to zero is written without a sign.
  CsvRow& fixed(double x);
  /// Fewest digits that read back to the same bits.
  CsvRow& shortest(double x);
  /// 17 significant digits, which read back to the same bits.
  CsvRow& full(double x);
  CsvRow& integer(std::int64_t n);
  /// 16 hexadecimal digits.
  CsvRow& hexadecimal(std::uint64_t n);
  /// Quoted when it holds a comma, a quote or a line break (RFC 4180).
  CsvRow& text(std::string_view word);
  /// The row with its line end; the next value starts a new row after clear().
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

}  // namespace nilas
