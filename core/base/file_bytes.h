#pragma once
/// Whole files, and what lies at a path.
#include <filesystem>
#include <string>

namespace nilas {

/// All bytes of a file. Throws FileError: cannot be opened (a folder cannot), read, or held in memory.
std::string file_bytes(const std::filesystem::path& file);

/// Whether the path is a folder, not a file. Throws FileError where there is neither, or where this cannot be found
/// out.
bool is_folder(const std::filesystem::path& path);

}  // namespace nilas
