#pragma once
/// compare.csv of a study of stored problems: a row per run, and reading it back to go on.
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/problems/problem_study_row.h"

namespace nilas {

std::string study_header();
std::string study_line(const StudyRow& row);
/// The same columns as an object; null where there is no number.
nlohmann::ordered_json study_json(const StudyRow& row);

/// Rows that a study left, however it ended: a last line that was cut off does not count.
struct StoredRows {
  std::vector<StudyRow> rows;
  std::int64_t bytes = 0;  ///< of the header and the complete rows
};
/// Throws FileError where the file cannot be read, InputError naming the line that is no row of a study.
StoredRows read_study(const std::filesystem::path& file);

/// By problem, law, solver in the registry's order, and falling tolerance.
void sort_study(std::vector<StudyRow>& rows);

}  // namespace nilas
