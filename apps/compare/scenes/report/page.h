#pragma once
/// Writes the page of a comparison and all its other files.
#include <filesystem>
#include <string>

#include "apps/compare/scenes/report/pictures.h"

namespace nilas::compare {

/// Writes compare.html without pictures, before anything was run. Throws FileError.
void write_first_page(const std::filesystem::path& folder, const SceneReport& report);

/// Writes compare.csv, settings.csv, loads.csv, compare.json, then pictures and compare.html. Returns why pictures are
/// missing, or an empty text. Throws FileError if a table or the page cannot be written.
std::string write_report(const std::filesystem::path& folder, const SceneReport& report);

}  // namespace nilas::compare
