#pragma once
/// JSON of other programs before it is parsed.
#include <filesystem>
#include <string>
#include <string_view>

namespace nilas {

/// Whether brackets of a JSON text are nested more than 100 deep, which no input of this program needs. The library
/// copies, compares and writes values by functions that call themselves for each level.
bool is_nested_deeply(std::string_view json);

/// The text of a JSON file. Throws as file_bytes() does, for more than k_most_text_bytes too, and InputError where it
/// is nested deeply.
std::string json_file_text(const std::filesystem::path& file);

}  // namespace nilas
