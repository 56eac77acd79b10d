#pragma once
/// One run of a study of stored problems: `nilas solve` in a process of its own, and what it left, judged.
#include <filesystem>
#include <string>

#include "apps/compare/problems/problem_study_plan.h"
#include "apps/compare/workshop/child.h"

namespace nilas {

/// Iterations are not what a study limits.
constexpr int k_study_iterations = 1000000;
/// Solves of a short run; the least time counts.
constexpr int k_study_repeats = 5;

/// Writes its result as JSON to `output`, its messages to `log`. The process ends a while after the limit of its solve:
/// some solvers look at the clock only now and then.
ChildTask task_of(const StudyFile& file, const StudyRun& run, double limit_s, const std::filesystem::path& output,
                  const std::filesystem::path& log);

/// The row that follows from how the process ended and what it printed. Throws FileError where it ended in order and
/// its result is not there, as on a full disk.
StudyRow judge(const StudyFile& file, const StudyRun& run, double limit_s, const ChildResult& ended,
               const std::string& printed, const std::string& logged);

}  // namespace nilas
