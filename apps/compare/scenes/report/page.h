#pragma once
/// The page of a comparison, and all that it leaves on disk.
#include <filesystem>
#include <string>

#include "apps/compare/scenes/report/pictures.h"

namespace nilas {

/// Writes compare.html without pictures, before they are drawn or anything was run. Throws FileError.
void write_first_page(const std::filesystem::path& folder, const SceneReport& report);

/// Writes compare.csv, settings.csv, loads.csv, compare.json, then pictures and compare.html. Returns why pictures are
/// missing, or nothing. Throws FileError where a table or the page cannot be written.
std::string write_report(const std::filesystem::path& folder, const SceneReport& report);

}  // namespace nilas
