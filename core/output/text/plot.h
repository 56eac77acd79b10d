#pragma once
/// Pictures by gnuplot.
#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace nilas::output {

/// Gnuplot is missing or failed. The pictures only repeat results that are also written otherwise.
class PlotError : public FileError {
 public:
  using FileError::FileError;
};

/// Runs a gnuplot script whose pictures go into `folder`. Throws PlotError, or FileError where the script cannot be
/// written.
void plot(const std::filesystem::path& folder, const std::string& script);

}  // namespace nilas::output
