#include "core/scene/spec/values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace nilas::scene {

static constexpr std::string_view k_blanks = " \t\r\n";

static std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(k_blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(k_blanks) - first + 1);
}

/// The text without a leading plus sign, which from_chars does not accept.
static std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
  return text;
}

template <class Number>
static std::optional<Number> parse_all(std::string_view text) {
  text = without_plus(without_blanks(text));
  Number value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<double> parse_number(std::string_view text) {
  const auto value = parse_all<double>(text);
  // from_chars accepts "inf" and "nan".
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_integer(std::string_view text) { return parse_all<std::int64_t>(text); }

std::optional<bool> parse_boolean(std::string_view text) {
  text = without_blanks(text);
  if (text == "true") return true;
  if (text == "false") return false;
  return std::nullopt;
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  for (auto first = text.find_first_not_of(k_blanks); first != std::string_view::npos;) {
    const auto last = std::min(text.find_first_of(k_blanks, first), text.size());
    words.emplace_back(text.substr(first, last - first));
    first = text.find_first_not_of(k_blanks, last);
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string s;
  for (const auto& word : words) s += (s.empty() ? "" : ", ") + word;
  return s;
}

std::string trimmed(std::string_view text) { return std::string(without_blanks(text)); }

std::string format_number(double x) {
  std::array<char, 32> buffer{};  // the longest shortest form of a double has 24 characters
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
  return {buffer.data(), result.ptr};
}

std::string canonical_value(const AttributeSpec& attribute, const std::string& value) {
  if (attribute.type == ValueType::text) return value;
  const bool is_list =
      attribute.type == ValueType::number || attribute.type == ValueType::integer || attribute.type == ValueType::words;
  if (!is_list) return trimmed(value);
  std::string spelt;
  for (const auto& word : split_words(value)) {
    if (!spelt.empty()) spelt += ' ';
    if (attribute.type == ValueType::number)
      spelt += format_number(parse_number(word).value_or(0));
    else if (attribute.type == ValueType::integer)
      spelt += std::to_string(parse_integer(word).value_or(0));
    else
      spelt += word;
  }
  return spelt;
}

}  // namespace nilas::scene
