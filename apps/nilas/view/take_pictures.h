#pragma once
/// The pictures and films of `nilas view`.
#include <filesystem>
#include <string>

#include "apps/nilas/view/picture_options.h"

namespace nilas::commands {

/// Draws what the options ask for, which are checked. `page`: the page of the run; `run`: its folder; `out`: that of
/// --out. Prints the files. Throws InputError for a time that the run has not, FileError, Interruption.
void take_pictures(const PictureOptions& options, const std::string& page, const std::filesystem::path& run,
                   const std::string& out);

}  // namespace nilas::commands
