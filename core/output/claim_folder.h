#pragma once
/// Takes a folder for a run without harming what else is there.
#include <filesystem>

namespace nilas {

/// Creates `folder` and its parents. Throws InputError when it holds anything, unless `force`: then the files that a
/// run of Nilas writes are removed and all others stay. Throws FileError when it cannot be made or written.
void claim_folder(const std::filesystem::path& folder, bool force);

}  // namespace nilas
