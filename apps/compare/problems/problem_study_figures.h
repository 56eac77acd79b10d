#pragma once
/// The pictures of a study of stored problems, drawn by gnuplot from the CSV files beside them.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_results.h"

namespace nilas {

/// A picture's files are `name`.svg and `name`.png.
struct StudyFigure {
  enum class Kind { performance, data, medians, problems };
  Kind kind = Kind::performance;
  std::string name, title;
  std::string law;
  double tolerance = 0;  ///< of a profile [m/s]
};

/// Writes profiles.csv and work-precision.csv and draws them: per comparison a performance and a data profile, then per
/// law the medians, then single problems. Throws FileError, also where gnuplot is missing or fails; the CSV files are
/// written before.
std::vector<StudyFigure> draw_study(const std::filesystem::path& folder, const std::vector<StudyRow>& rows,
                                    const std::vector<Comparison>& comparisons);

/// Names of the files that draw_study writes, as a pattern for std::regex.
constexpr const char* k_study_figure_files =
    R"((profiles|work-precision)\.csv|(performance|data|work-precision|problems)-[A-Za-z0-9+.-]+\.(svg|png))";

}  // namespace nilas
