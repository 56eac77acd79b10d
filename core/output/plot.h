#pragma once
/// Pictures by gnuplot.
#include <filesystem>
#include <string>

namespace nilas {

/// Runs a gnuplot script whose pictures go into `folder`. Throws FileError where gnuplot is missing or complains.
void plot(const std::filesystem::path& folder, const std::string& script);

}  // namespace nilas
