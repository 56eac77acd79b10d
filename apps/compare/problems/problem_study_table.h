#pragma once
/// The table compare.csv of a study of stored problems: writing a row per run, and reading it to continue a study.
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_row.h"

namespace nilas::compare {

std::string study_header();
std::string study_line(const StudyRow& row);
/// The row as a JSON object with the same columns; null stands for no number.
nlohmann::ordered_json study_json(const StudyRow& row);

/// The rows that a study left. A last line that was cut off does not count.
struct StoredRows {
  std::vector<StudyRow> rows;
  std::int64_t bytes = 0;  ///< size of the header and the complete rows
};
/// Reads the rows. Throws FileError if the file cannot be read, and InputError with the line that is no row of a study.
StoredRows read_study(const std::filesystem::path& file);

/// Sorts the rows by problem, law, solver in the registry's order, and falling tolerance.
void sort_study(std::vector<StudyRow>& rows);

}  // namespace nilas::compare
