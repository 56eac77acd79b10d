#pragma once
/// What a study of stored problems runs, in which order, and what its budget leaves out.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_row.h"

namespace nilas {

/// A file of the folder.
struct StudyFile {
  std::filesystem::path path;
  StudyProblem problem;
  bool moments = false;  ///< it has rolling friction
  double reading_s = 0;  ///< what reading it took
  std::string fault;     ///< why it cannot be read; empty where it can
};

/// The .hdf5 and .h5 files of a folder by name. Throws FileError where it is no folder, InputError where it holds no
/// such file or none that can be read.
std::vector<StudyFile> survey(const std::filesystem::path& folder);

/// Largest over smallest mass that a side of a contact shows: 3 / trace(J M^-1 J^T) over contacts and sides.
double contact_mass_ratio(const ContactProblem& problem);

/// What is to be crossed.
struct StudyChoice {
  std::vector<std::string> solvers, laws;  ///< empty solvers: all that take the law
  std::vector<double> tolerances;          ///< [m/s]; empty: 1e-2 1e-4 1e-6 1e-8, and 1e-10 up to 50 contacts
  double limit_s = 0;  ///< of a solve; 0: two even shares of the budget without starts, 0.2 s to 60 s
};
/// Throws InputError naming the nearest solver or law, or the tolerance that is none.
void validate(const StudyChoice& choice);

struct StudyRun {
  std::size_t file = 0;
  std::string solver, law;
  double tolerance = 0;
};

struct StudyPlan {
  std::vector<StudyRun> runs;            ///< in their order
  std::vector<StudyRun> dropped;         ///< that the budget has no room for
  std::vector<StudyRow> settled;         ///< known without a run: not applicable, unreadable
  double limit_s = 0;                    ///< of a solve
  double estimate_s = 0, at_most_s = 0;  ///< of processor time, for `runs`
};

/// Blocks of one problem, law and tolerance with all solvers, so that what is done compares: the middle tolerance
/// first, then outwards; problems in an order in which each stretch spans all sizes. Whole blocks are dropped from the
/// end once the estimate exceeds `core_seconds`; the first stays. `start_s`: what starting a process takes. `done`:
/// runs that are not needed again.
StudyPlan make_plan(const std::vector<StudyFile>& files, const StudyChoice& choice, double core_seconds, double start_s,
                    const std::function<bool(const StudyRow&)>& done = {});

/// The row of a run before it is done.
StudyRow row_of(const StudyFile& file, const StudyRun& run);

/// Tolerances with the middle one first, then outwards, the tighter first.
std::vector<double> middle_first(std::vector<double> tolerances);

}  // namespace nilas
