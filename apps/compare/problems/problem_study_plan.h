#pragma once
/// The plan of a study of stored problems: its runs, their order, and what the budget leaves out.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_row.h"

namespace nilas::compare {

/// A file of the folder of problems.
struct StudyFile {
  std::filesystem::path path;
  StudyProblem problem;
  bool moments = false;  ///< the problem has rolling friction
  double reading_s = 0;  ///< time of reading it [s]
  std::string fault;     ///< why it cannot be read; empty: it can
};

/// The .hdf5 and .h5 files of a folder, sorted by name. Throws FileError if there is no such folder, and InputError if
/// it holds no such file or none that can be read.
std::vector<StudyFile> survey(const std::filesystem::path& folder);

/// The ratio of the largest to the smallest effective mass 3 / trace(J M^-1 J^T) over contacts and their sides [-]; NaN
/// without any.
double contact_mass_ratio(const contact::ContactProblem& problem);

/// The solvers, laws and tolerances that are combined.
struct StudyChoice {
  std::vector<std::string> solvers, laws;  ///< empty solvers: all that take the law
  std::vector<double> tolerances;          ///< [m/s]; empty: 1e-2 1e-4 1e-6 1e-8, and 1e-10 up to 50 contacts
  double limit_s = 0;  ///< time limit of a solve [s]; 0: twice an even share of the budget, 0.2 s to 60 s
};
/// Throws InputError for an unknown solver or law, with the nearest one, and for a tolerance that is not above 0.
void validate(const StudyChoice& choice);

struct StudyRun {
  std::size_t file = 0;
  std::string solver, law;
  double tolerance = 0;
};

struct StudyPlan {
  std::vector<StudyRun> runs;            ///< runs in their order
  std::vector<StudyRun> dropped;         ///< runs for which the budget has no time
  std::vector<StudyRow> settled;         ///< rows known without a run: not applicable or unreadable
  double limit_s = 0;                    ///< time limit of a solve [s]
  double estimate_s = 0, at_most_s = 0;  ///< estimate and limit of the processor time of `runs` [s]
};

/// Makes the plan from blocks of one problem, law and tolerance with all solvers, so that the finished runs can be
/// compared. The middle tolerance comes first, then those outwards. Problems are in an order in which each stretch
/// spans all sizes. Once the estimate exceeds `core_seconds`, the remaining blocks are dropped, but not the first.
/// `start_s`: time of starting a process [s]. `done`: whether a run is not needed again.
StudyPlan make_plan(const std::vector<StudyFile>& files, const StudyChoice& choice, double core_seconds, double start_s,
                    const std::function<bool(const StudyRow&)>& done = {});

/// The row of a run before it is done.
StudyRow row_of(const StudyFile& file, const StudyRun& run);

/// The tolerances with the middle one first, then those outwards, of which the tighter comes first.
std::vector<double> middle_first(std::vector<double> tolerances);

}  // namespace nilas::compare
