#pragma once
/// Conversion of text to values and back, independent of the locale, for the attributes of a scene.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/spec/element_spec.h"

namespace nilas::scene {

/// Parses a finite decimal number; blanks around it are allowed, other text is not.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);
/// "true" or "false".
std::optional<bool> parse_boolean(std::string_view text);
/// Blank-separated words.
std::vector<std::string> split_words(std::string_view text);
/// The words with commas between them.
std::string joined(const std::vector<std::string>& words);
/// The text without blanks around it.
std::string trimmed(std::string_view text);

/// The shortest text that reads back as the same double.
std::string format_number(double x);
/// A valid value in its one canonical spelling.
std::string canonical_value(const AttributeSpec& attribute, const std::string& value);

}  // namespace nilas::scene
