/// Checks values of the scene file and describes their faults.
#include <algorithm>

#include "core/base/error.h"
#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

static std::string count_text(const AttributeSpec& attribute) {
  const int low = attribute.min_count, high = attribute.max_count;
  if (low == high) return std::to_string(low);
  if (high == k_any_count) return "at least " + std::to_string(low);
  if (low == 0) return "up to " + std::to_string(high);
  return std::to_string(low) + (high == low + 1 ? " or " : " to ") + std::to_string(high);
}

static std::string numbers_text(const AttributeSpec& attribute) {
  const bool whole = attribute.type == ValueType::integer;
  std::string s = whole ? "a whole number" : "a finite number";
  if (attribute.max_count > 1) s = count_text(attribute) + (whole ? " whole numbers" : " finite numbers");
  if (const std::string range = attribute.range.text(); !range.empty()) s += " " + range;
  return attribute.unit.empty() ? s : s + " [" + unit_text(attribute) + "]";
}

std::string unit_text(const AttributeSpec& attribute) {
  std::string text = attribute.unit;
  for (const OtherUnit& other : attribute.other_units)
    text += "; with " + joined(other.applies.values) + " " + other.unit;
  return text;
}

static std::string words_text(const AttributeSpec& attribute) {
  if (attribute.choices.empty()) return attribute.max_count == 1 ? "one word" : count_text(attribute) + " words";
  return (attribute.max_count == 1 ? "one of " : count_text(attribute) + " of ") + joined(attribute.choices);
}

std::string allowed_text(const AttributeSpec& attribute) {
  switch (attribute.type) {
    case ValueType::number:
    case ValueType::integer:
      return numbers_text(attribute);
    case ValueType::boolean:
      return "true or false";
    case ValueType::text:
      return "any text";
    case ValueType::name:
      return "a name without , ; / \\ quotes and angle brackets";
    case ValueType::words:
      return words_text(attribute);
    case ValueType::choice:
      return attribute.choices.size() == 1 ? attribute.choices.front() : "one of " + joined(attribute.choices);
    case ValueType::path:
      return "the path of a file";
    case ValueType::hull:
      return "the path of a hull folder or an STL file";
  }
  return "";
}

static std::string found_and_allowed(const AttributeSpec& attribute, const std::string& found) {
  return "found " + found + "; allowed: " + allowed_text(attribute);
}

static std::string quoted(const std::string& text) { return "'" + text + "'"; }

static bool count_fits(const AttributeSpec& attribute, std::size_t count) {
  return count >= static_cast<std::size_t>(attribute.min_count) &&
         count <= static_cast<std::size_t>(attribute.max_count);
}

/// The number in a word, if any. Integers are returned as doubles, which hold all allowed ones exactly.
static std::optional<double> number_in(const AttributeSpec& attribute, const std::string& word) {
  if (attribute.type == ValueType::number) return parse_number(word);
  if (const auto whole = parse_integer(word)) return static_cast<double>(*whole);
  return std::nullopt;
}

static std::optional<std::string> numbers_problem(const AttributeSpec& attribute, const std::string& value) {
  const auto words = split_words(value);
  for (const auto& word : words) {
    const auto x = number_in(attribute, word);
    if (!x && word.find(',') != std::string::npos)
      return found_and_allowed(attribute, quoted(word)) + "; blanks separate numbers, a point their decimals";
    if (!x || !attribute.range.contains(*x)) return found_and_allowed(attribute, quoted(word));
  }
  if (count_fits(attribute, words.size())) return std::nullopt;
  if (attribute.max_count == 1) return found_and_allowed(attribute, quoted(trimmed(value)));
  return found_and_allowed(attribute, std::to_string(words.size()) + (words.size() == 1 ? " number" : " numbers"));
}

static std::string with_nearest(const AttributeSpec& attribute, const std::string& word) {
  std::string near = nearest_name(word, attribute.choices);
  if (near.ends_with("-k")) near.back() = '8';  // k stands for a number of facets, from 3 to 1000
  return found_and_allowed(attribute, quoted(word)) + (near.empty() ? "" : "; nearest: " + near);
}

static std::optional<std::string> words_problem(const AttributeSpec& attribute, const std::string& value) {
  const auto words = split_words(value);
  for (const auto& word : words) {
    if (!attribute.choices.empty() && matching_choice(attribute.choices, word).empty())
      return with_nearest(attribute, word);
  }
  if (count_fits(attribute, words.size())) return std::nullopt;
  return found_and_allowed(attribute, quoted(value));
}

static bool is_name(const std::string& value) {
  const std::string name = trimmed(value);
  const auto forbidden = [](char c) {
    return std::string_view(",;/\\\"'<>").find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ';
  };
  return !name.empty() && name != "." && name != ".." && std::none_of(name.begin(), name.end(), forbidden);
}

std::optional<std::string> value_problem(const AttributeSpec& attribute, const std::string& value) {
  bool fine = true;
  switch (attribute.type) {
    case ValueType::number:
    case ValueType::integer:
      return numbers_problem(attribute, value);
    case ValueType::words:
      return words_problem(attribute, value);
    case ValueType::choice:
      if (!matching_choice(attribute.choices, trimmed(value)).empty()) return std::nullopt;
      return with_nearest(attribute, trimmed(value));
    case ValueType::boolean:
      fine = parse_boolean(value).has_value();
      break;
    case ValueType::name:
      fine = is_name(value);
      break;
    case ValueType::path:
    case ValueType::hull:
      fine = !trimmed(value).empty();
      break;
    case ValueType::text:
      break;
  }
  if (fine) return std::nullopt;
  return found_and_allowed(attribute, quoted(value));
}

}  // namespace nilas::scene
