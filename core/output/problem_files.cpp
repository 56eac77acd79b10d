#include "core/output/problem_files.h"

#include <cmath>
#include <cstdio>

#include "contact/fclib_io.h"
#include "core/base/error.h"

namespace nilas {

ProblemFiles::ProblemFiles(const std::filesystem::path& run_folder, const std::string& which)
    : folder_(run_folder / "problems"), which_(which) {}

void ProblemFiles::step(const StepRecord& record, const SolvedProblem& solved) {
  if (which_ == "never" || solved.problem.num_contacts() == 0) return;
  if (which_ == "failed" && record.status == SolveStatus::converged) return;
  if (which_ == "worst") {
    if (record.residuals.law_map_m_s <= worst_ || std::isnan(worst_)) return;  // the first NaN stays the worst
    worst_ = record.residuals.law_map_m_s;
    return write("worst.hdf5", solved);
  }
  char name[32];
  std::snprintf(name, sizeof name, "step-%08ld.hdf5", record.step);
  write(name, solved);
}

void ProblemFiles::last(const SolvedProblem& solved) const {
  if (solved.problem.num_contacts() > 0) write("last.hdf5", solved);
}

void ProblemFiles::write(const std::string& name, const SolvedProblem& solved) const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw FileError(folder_.string() + ": " + error.message());
  write_fclib(folder_ / name, solved.problem, &solved.solution);
}

}  // namespace nilas
