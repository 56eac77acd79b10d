#pragma once
/// Whole files, and what lies at a path.
#include <cstddef>
#include <filesystem>
#include <string>

#include "core/base/error.h"

namespace nilas {

/// Returns the fault of a path where nothing is: "PATH: there is no such KIND; nearest: PATH". The latter is the
/// entry of that folder with the most similar name, if any is similar.
FileError nothing_there(const std::filesystem::path& path, const std::string& kind);

/// Throws nothing_there() where nothing is at the path.
void demand_there(const std::filesystem::path& path, const std::string& kind);

/// Most bytes of a file that is read whole, and of one that people or scripts write as text.
constexpr std::size_t k_most_bytes = std::size_t{4} << 30, k_most_text_bytes = std::size_t{256} << 20;

/// All bytes of a file or of a pipe, into which another program writes. Throws FileError: cannot be opened (a folder
/// cannot), read, or held in memory, is a device, or is a pipe into which nobody writes for ten seconds. Throws
/// InputError where there are more than `most` bytes.
std::string file_bytes(const std::filesystem::path& file, std::size_t most = k_most_bytes);

/// Throws FileError unless a file, no pipe and no device, is at the path: a reader would wait or never end.
void demand_file(const std::filesystem::path& path);

/// Whether the path is a folder, not a file. Throws FileError where there is neither, or where this cannot be found
/// out.
bool is_folder(const std::filesystem::path& path);

}  // namespace nilas
