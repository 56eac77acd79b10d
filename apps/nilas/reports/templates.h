#pragma once
/// The text files of apps/nilas/templates, which the build puts into the program.
#include <string>
#include <string_view>

namespace nilas::commands {

/// The text of a template by its file name. Throws ContractError for one that does not exist.
std::string_view nilas_template(std::string_view name);

}  // namespace nilas::commands
