#include "core/vessel/mooring/moordyn_file.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "core/base/file_bytes.h"

namespace nilas::vessel {

namespace {

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// The number that a whole word states.
std::optional<double> number_of_word(const std::string& word) {
  std::istringstream in(word);
  double number = 0;
  return in >> number && in.peek() == std::istringstream::traits_type::eof() ? std::optional(number) : std::nullopt;
}

}  // namespace

MoordynWater moordyn_water(const std::string& file) {
  MoordynWater water;
  std::istringstream lines(file_bytes(file, k_most_text_bytes));
  bool in_options = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("---")) in_options = in_lower_case(line).find("option") != std::string::npos;
    std::istringstream words(line);
    std::string value, keyword;
    if (!in_options || !(words >> value >> keyword)) continue;
    keyword = in_lower_case(keyword);
    if (keyword == "wtrdpth" || keyword == "depth") water.depth = number_of_word(value);
    if (keyword == "rho" || keyword == "rhow" || keyword == "wtrdnsty") water.density = number_of_word(value);
    if (keyword == "g" || keyword == "gravity") water.gravity = number_of_word(value);
  }
  return water;
}

}  // namespace nilas::vessel
