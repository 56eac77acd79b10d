#pragma once
/// The pictures of a study of stored problems, which gnuplot draws from CSV files in the same folder.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_results.h"
#include "apps/compare/workshop/picture.h"

namespace nilas::compare {

struct ProblemPicture {
  enum class Kind { performance, data, medians, problems };
  Kind kind = Kind::performance;
  std::string title;
  Picture picture;
};

/// Writes profiles.csv and work-precision.csv and draws them: a performance and a data profile for each comparison, the
/// medians for each law, and single problems. Throws FileError, and PlotError if gnuplot is missing or fails, after the
/// CSV files are written.
std::vector<ProblemPicture> draw_problem_study(const std::filesystem::path& folder, const std::vector<StudyRow>& rows,
                                               const std::vector<SolverComparison>& comparisons);

/// Whether draw_problem_study() writes a file of this name.
bool is_problem_picture_file(const std::string& name);

}  // namespace nilas::compare
