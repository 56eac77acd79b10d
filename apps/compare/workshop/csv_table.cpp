#include "apps/compare/workshop/csv_table.h"

#include <algorithm>
#include <cmath>

namespace nilas::compare {

void CsvCell::operator=(double value) { std::isfinite(value) ? row_.shortest(value) : row_.text(""); }

std::string without_commas(std::string sentence) {
  std::replace(sentence.begin(), sentence.end(), ',', ';');
  return sentence;
}

std::string list_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : ";") + std::to_string(n);
  return text;
}

}  // namespace nilas::compare
