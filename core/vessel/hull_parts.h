#pragma once
/// The part files of a hull folder.
#include <filesystem>
#include <string>
#include <vector>

namespace nilas {

/// part-01.stl for the first.
std::string part_name(std::size_t number);
/// Whether it names a part: part-NN.stl with any number of digits.
bool names_part(const std::string& name);

/// All paths in a folder, by name. Throws FileError.
std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder);
/// The parts by number. Throws FileError, or InputError for a part-*.stl without a number: it would look like a part.
std::vector<std::filesystem::path> part_files(const std::filesystem::path& folder);

}  // namespace nilas
