#pragma once
/// Text to values and back, without locale: what the attributes of a scene may look like.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/schema/schema.h"

namespace nilas {

/// A finite decimal number with nothing behind it; blanks around it are allowed.
std::optional<double> parse_number(std::string_view text);
std::optional<std::int64_t> parse_integer(std::string_view text);
/// "true" or "false".
std::optional<bool> parse_boolean(std::string_view text);
/// Blank-separated words.
std::vector<std::string> split_words(std::string_view text);
/// Without the blanks around it.
std::string trimmed(std::string_view text);

/// The shortest text that reads back as the same double.
std::string format_number(double x);
/// A valid value in its one canonical spelling.
std::string canonical_value(const AttributeSpec& attribute, const std::string& value);

}  // namespace nilas
