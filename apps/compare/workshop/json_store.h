#pragma once
/// The JSON files of both kinds of study.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace nilas::compare {

/// JSON whose objects keep the order of their keys.
using Json = nlohmann::ordered_json;

/// The value, or null if it is not finite, because JSON has no NaN and no infinity.
Json number_or_null(double value);

/// The text of a JSON object for files and `--json`, indented as by the other commands. Bytes that are no UTF-8 are
/// replaced.
std::string json_text(const Json& json);
/// Writes a whole file and then renames it to its name. Returns when it is on the disk. Throws FileError.
void write_json(const std::filesystem::path& file, const Json& json);
/// Reads a file; is_discarded() holds for the result if the file holds no JSON. Throws FileError.
Json read_json(const std::filesystem::path& file);

}  // namespace nilas::compare
