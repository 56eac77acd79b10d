#pragma once
/// JSON within HTML pages.
#include <nlohmann/json.hpp>
#include <string>

namespace nilas::output {

/// The JSON as it may stand in a script element of a page: no text in it can end the element. Bytes that are no UTF-8
/// are replaced.
std::string script_json(const nlohmann::ordered_json& json);

}  // namespace nilas::output
