#pragma once
/// The page as it was bundled when the program was built.
#include <string_view>

namespace nilas::view {

/// The bundled files by their names. "page.html" has places that page.cpp fills; it is empty where it was not built.
std::string_view page_file(std::string_view name);

}  // namespace nilas::view
