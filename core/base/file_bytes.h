#pragma once
/// Whole files, and what lies at a path.
#include <filesystem>
#include <string>

namespace nilas {

/// All bytes of a file. Throws FileError: cannot be opened (a folder cannot), read, or held in memory.
std::string file_bytes(const std::filesystem::path& file);

/// Whether a folder lies there, not a file. Throws FileError where there is neither or it cannot be told.
bool is_folder(const std::filesystem::path& path);

}  // namespace nilas
