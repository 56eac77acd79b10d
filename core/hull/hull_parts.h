#pragma once
/// The part files of a hull folder.
#include <filesystem>
#include <string>
#include <vector>

namespace nilas::hull {

/// part-0001.stl for the first, so that up to 9999 stand in their order wherever files are listed by name.
std::string part_name(std::size_t number);
/// Whether it names a part: part-NNNN.stl, with any number of digits.
bool names_part(const std::string& name);

/// All paths in a folder, by name. Throws FileError.
std::vector<std::filesystem::path> paths_in(const std::filesystem::path& folder);
/// The parts by number. Throws FileError, or InputError for a part-*.stl without a number: it would look like a part.
std::vector<std::filesystem::path> part_files(const std::filesystem::path& folder);

}  // namespace nilas::hull
