#pragma once
/// The text files of apps/compare/templates, which the build puts into the program.
#include <string>
#include <string_view>

namespace nilas::compare {

/// The text of a template by its file name. Throws ContractError for one that does not exist.
std::string_view compare_template(std::string_view name);

}  // namespace nilas::compare
