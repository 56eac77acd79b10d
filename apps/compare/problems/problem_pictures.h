#pragma once
/// The pictures of a study of stored problems, drawn by gnuplot from the CSV files beside them.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_results.h"
#include "apps/compare/workshop/picture.h"

namespace nilas {

struct ProblemPicture {
  enum class Kind { performance, data, medians, problems };
  Kind kind = Kind::performance;
  std::string title;
  Picture picture;
};

/// Writes profiles.csv and work-precision.csv and draws them: per comparison a performance and a data profile, then per
/// law the medians, then single problems. Throws FileError, also where gnuplot is missing or fails (PlotError); the CSV
/// files are written before.
std::vector<ProblemPicture> draw_problem_study(const std::filesystem::path& folder, const std::vector<StudyRow>& rows,
                                               const std::vector<SolverComparison>& comparisons);

/// Whether that writes a file of this name.
bool is_problem_picture_file(const std::string& name);

}  // namespace nilas
