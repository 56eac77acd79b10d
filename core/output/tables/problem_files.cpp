#include "core/output/tables/problem_files.h"

#include <fmt/format.h>

#include <cmath>

#include "contact/fclib/fclib_io.h"
#include "core/base/error.h"

namespace nilas::output {

static constexpr const char* k_worst = "worst.hdf5";

static std::string numbered(const char* kind, long step) { return fmt::format("{}-{:08d}.hdf5", kind, step); }

std::string kept_worst_name(long step) { return numbered("worst", step); }

ProblemFiles::ProblemFiles(const std::filesystem::path& run_folder, StoredProblems which, bool resumable)
    : folder_(run_folder / "problems"), which_(which), unflushed_(resumable) {}

void ProblemFiles::step(const sim::StepRecord& record, const contact::SolvedProblem& solved) {
  if (solved.problem.num_contacts() == 0) return;
  switch (which_) {
    case StoredProblems::never:
      return;
    case StoredProblems::failed:
      if (record.status != contact::SolveStatus::converged) write(numbered("step", record.step), solved);
      return;
    case StoredProblems::every:
      return write(numbered("step", record.step), solved);
    case StoredProblems::worst:
      if (record.residuals.law_map_m_s <= worst_ || std::isnan(worst_)) return;  // the first NaN stays the worst
      if (worst_step_ >= 0 && worst_step_ == saved_worst_step_) keep_worst();
      worst_ = record.residuals.law_map_m_s;
      worst_step_ = record.step;
      return write(k_worst, solved);
  }
}

void ProblemFiles::last(const contact::SolvedProblem& solved) {
  if (solved.problem.num_contacts() == 0) return;
  try {
    write("last.hdf5", solved);
  } catch (const InputError&) {
    // FCLIB's form cannot hold this problem; what the run has to say of its failure matters more.
  }
}

void ProblemFiles::save(StateWriter out) const {
  out.add("worst_law_map_m_s", worst_);
  out.add("worst_step", worst_step_);
}

void ProblemFiles::restore(const StateReader& in) {
  in.get("worst_law_map_m_s", worst_);
  in.get("worst_step", worst_step_);
  saved_worst_step_ = worst_step_;
}

void ProblemFiles::saved() {
  if (saved_worst_step_ >= 0 && saved_worst_step_ != worst_step_) {
    const std::filesystem::path kept = folder_ / kept_worst_name(saved_worst_step_);
    std::error_code error;
    std::filesystem::remove(kept, error);
    if (error) throw FileError(kept.string() + ": cannot be removed: " + error.message());
  }
  saved_worst_step_ = worst_step_;
}

void ProblemFiles::keep_worst() const {
  std::error_code error;
  std::filesystem::rename(folder_ / k_worst, folder_ / kept_worst_name(worst_step_), error);
  if (error && error != std::errc::no_such_file_or_directory)
    throw FileError((folder_ / k_worst).string() + ": cannot be renamed: " + error.message());
}

void ProblemFiles::write(const std::string& name, const contact::SolvedProblem& solved) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw FileError(folder_.string() + ": " + error.message());
  contact::write_fclib(folder_ / name, solved.problem, &solved.solution);
  unflushed_.add(folder_ / name);
}

}  // namespace nilas::output
