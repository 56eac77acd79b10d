#pragma once
/// Claims a folder for a new or continued run without harming other files in it.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/run/run_lock.h"
#include "core/scene/scene.h"

namespace nilas::output {

/// The default folder for results: runs/<name>-<date and time>.
std::filesystem::path dated_folder(const std::string& name);

/// Creates `folder` and its parents. Throws InputError when it is not empty, unless `force`: then the files that a run
/// of Nilas writes are removed and all others stay. Throws FileError when it cannot be created or written.
void claim_folder(const std::filesystem::path& folder, bool force);
/// The same for a run, and locks the folder on an empty or older nilas.log. Files that an earlier run copied there and
/// that are among `inputs` of this one stay. Throws FileError where another program holds the lock, and InputError
/// where the run's own copies would replace its inputs.
[[nodiscard]] RunLock claim_run_folder(const std::filesystem::path& folder, bool force,
                                       const std::vector<scene::InputFile>& inputs = {});

/// Removes the files that a run continued after `step` writes anew: the summary, trajectory frames and contact problems
/// of later steps, problems/last.hdf5, and half-written files. `worst_problem`: step of the problem in
/// problems/worst.hdf5. -1: none, so all are removed. Throws FileError.
void clear_after(const std::filesystem::path& folder, long step = -1, long worst_problem = -1);

}  // namespace nilas::output
