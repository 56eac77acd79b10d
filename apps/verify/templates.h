#pragma once
/// The text files of apps/verify/templates, which the build puts into the program.
#include <string>
#include <string_view>

namespace nilas::verify {

/// The text of a template by its file name. Throws ContractError for one that does not exist.
std::string_view verify_template(std::string_view name);

}  // namespace nilas::verify
