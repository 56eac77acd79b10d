#pragma once
/// Whole files, and what lies at a path.
#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace nilas {

/// Returns the fault of a path where nothing is: "PATH: there is no such KIND; nearest: PATH". The latter is the
/// entry of that folder with the most similar name, if any is similar.
FileError nothing_there(const std::filesystem::path& path, const std::string& kind);

/// Throws nothing_there() where nothing is at the path.
void demand_there(const std::filesystem::path& path, const std::string& kind);

/// All bytes of a file. Throws FileError: cannot be opened (a folder cannot), read, or held in memory.
std::string file_bytes(const std::filesystem::path& file);

/// Whether the path is a folder, not a file. Throws FileError where there is neither, or where this cannot be found
/// out.
bool is_folder(const std::filesystem::path& path);

}  // namespace nilas
