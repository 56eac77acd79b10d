#pragma once
/// JSON files of both studies.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace nilas {

/// JSON knows no NaN and no infinity.
nlohmann::ordered_json number_or_null(double value);

/// As the files and `--json` have it; bytes that are no UTF-8 are replaced.
std::string json_text(const nlohmann::ordered_json& json);
/// Writes a file whole, through a rename. Throws FileError.
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);
/// Reads a file; "discarded" (nlohmann) where it holds no JSON. Throws FileError.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

}  // namespace nilas
