#pragma once
/// The pages of both kinds of study: they share the head and the style.
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace nilas::compare {

/// The page whose body is a template. `view` fills the body, and the head by `page_title`, `page_heading` and
/// `subtitle`. Throws ContractError for a template that does not exist and for a name without a value.
std::string page_text(std::string_view body, nlohmann::ordered_json view);

}  // namespace nilas::compare
