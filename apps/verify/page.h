#pragma once
/// The results of `nilas verify` as a page with a picture per family.
#include <filesystem>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas::verify {

/// Writes verify.html, which contains its pictures, and beside it family-A.svg, family-A.png and so on. Throws
/// FileError if a file cannot be written.
void write_page(const std::filesystem::path& folder, const std::vector<Row>& rows);

}  // namespace nilas::verify
