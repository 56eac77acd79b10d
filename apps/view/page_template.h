#pragma once
/// The pages' scripts and styles as they were bundled when the program was built.
#include <string_view>

namespace nilas::view {

/// The bundled files by their names: "page.html" and "report.html" with places that page.cpp fills, "compare.js", the
/// script of the page of a comparison, and "theme.css" with colours. All but the last are empty where they were not
/// built.
std::string_view page_file(std::string_view name);

}  // namespace nilas::view
