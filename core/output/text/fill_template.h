#pragma once
/// Text templates filled from JSON, in the manner of Mustache: pages and scripts for gnuplot stand in files of their
/// own.
///
///   {{name}}                   the value, escaped for where it stands; numbers as short as they read back
///   {{{name}}}                 the value as it is
///   {{#name}} ... {{/name}}    once per element of an array; once where the value is an object or is neither null,
///                              false nor empty; names inside are looked up in the element first
///   {{^name}} ... {{/name}}    once where the value is null, false or empty
///   {{.}}                      the element itself
///
/// A section's tag that stands alone in its line takes the line with it. Debian has no such library for C++.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace nilas::output {

enum class Escape {
  html,    ///< for text and attributes: & < > " ' become entities
  gnuplot  ///< for gnuplot's strings in single quotes, which hold no escapes and run no commands
};

/// Fills a template. Throws ContractError for a name without a value and for an unclosed section, because templates are
/// part of the program.
std::string fill_template(std::string_view text, const nlohmann::ordered_json& data, Escape escape);

}  // namespace nilas::output
