#pragma once
/// Whole files.
#include <filesystem>
#include <string>

namespace nilas {

/// All bytes of a file. Throws FileError: cannot be opened (a folder cannot), or read.
std::string file_bytes(const std::filesystem::path& file);

}  // namespace nilas
