#pragma once
/// The table of verification as a page with a picture per family.
#include <filesystem>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas {

/// Writes verify.html, which needs no other file, and family-A.svg, family-A.png ... beside it. Throws FileError.
void write_page(const std::filesystem::path& folder, const std::vector<Row>& rows);

}  // namespace nilas
