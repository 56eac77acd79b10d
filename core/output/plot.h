#pragma once
/// Pictures by gnuplot.
#include <filesystem>
#include <string>

namespace nilas {

/// Runs a gnuplot script whose pictures go into `folder`. Throws FileError that tells whether gnuplot is missing or
/// failed.
void plot(const std::filesystem::path& folder, const std::string& script);

}  // namespace nilas
