#pragma once
/// The JSON files of both kinds of study.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace nilas {

/// The value, or null if it is not finite, because JSON has no NaN and no infinity.
nlohmann::ordered_json number_or_null(double value);

/// The text of a JSON object for files and `--json`. Bytes that are no UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& json);
/// Writes a whole file and then renames it to its name. Throws FileError.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);
/// Reads a file; is_discarded() holds for the result if the file holds no JSON. Throws FileError.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

}  // namespace nilas
