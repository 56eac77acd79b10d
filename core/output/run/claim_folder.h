#pragma once
/// Takes a folder for a run, or for the rest of one, without harming what else is there.
#include <filesystem>
#include <string>
#include <vector>

#include "core/output/run/run_lock.h"
#include "core/scene/scene.h"

namespace nilas {

/// runs/<name>-<date and time>: where results go when nobody names a folder.
std::filesystem::path dated_folder(const std::string& name);

/// Creates `folder` and its parents. Throws InputError when it holds anything, unless `force`: then the files that a
/// run of Nilas writes are removed and all others stay. Throws FileError when it cannot be made or written.
void claim_folder(const std::filesystem::path& folder, bool force);
/// The same for a run: the lock is held, on an empty or older nilas.log. Files that an earlier run copied there and
/// that this one reads, of `inputs`, stay. Throws FileError where another program holds the lock, InputError where the
/// run's own copies would replace what it reads.
[[nodiscard]] RunLock claim_run_folder(const std::filesystem::path& folder, bool force,
                                       const std::vector<InputFile>& inputs = {});

/// Removes what a run that goes on after `step` writes again as a whole: the summary, trajectory frames and contact
/// problems of later steps, problems/last.hdf5, and what was left half written. `worst_problem`: step of the problem
/// that is problems/worst.hdf5 again. -1: none, so all is removed. Throws FileError.
void clear_after(const std::filesystem::path& folder, long step = -1, long worst_problem = -1);

}  // namespace nilas
