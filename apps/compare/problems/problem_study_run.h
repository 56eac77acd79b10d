#pragma once
/// One run of a study of stored problems: `nilas solve` in a process of its own, and the judged result.
#include <filesystem>
#include <string>

#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/workshop/child.h"

namespace nilas::compare {

/// The limit of iterations, which is high because a study limits the time.
constexpr int k_study_iterations = 1000000;
/// The number of solves of a short run, of which the least time counts.
constexpr int k_study_repeats = 5;

/// The process of a run. It writes its result as JSON to `output` and its messages to `log`. It is ended some time
/// after the limit of its solve, because some solvers do not look at the clock often.
ChildTask task_of(const StudyFile& file, const StudyRun& run, double limit_s, const std::filesystem::path& output,
                  const std::filesystem::path& log);

/// The row from the end and the output of the process. Throws FileError if it ended in order but left no result, which
/// happens on a full disk, and if it could not be started.
StudyRow judge(const StudyFile& file, const StudyRun& run, double limit_s, const ChildResult& ended,
               const std::string& printed, const std::string& logged);

}  // namespace nilas::compare
