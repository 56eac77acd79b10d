#pragma once
/// Chosen columns of a run's CSV files.
#include <filesystem>
#include <string>
#include <vector>

namespace nilas {

/// The named columns, each from the first row to the last whole one; a cell that is no number is NaN. Throws FileError
/// where the file cannot be read and InputError where a column is missing.
std::vector<std::vector<double>> csv_columns(const std::filesystem::path& file, const std::vector<std::string>& names);

}  // namespace nilas
