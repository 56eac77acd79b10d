#include "core/base/file_bytes.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <new>
#include <vector>

namespace nilas {

namespace fs = std::filesystem;

/// Returns the names in a folder in order; none where it cannot be read.
static std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    names.push_back(entry->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

FileError nothing_there(const fs::path& path, const std::string& kind) {
  const fs::path written = path.has_filename() ? path : path.parent_path();
  const fs::path folder = written.has_parent_path() ? written.parent_path() : fs::path(".");
  const std::string name = nearest_name(written.filename().string(), names_in(folder));
  const std::string near = name.empty() ? "" : (written.parent_path() / name).string();
  return FileError(path.string() + ": there is no such " + kind + (near.empty() ? "" : "; nearest: " + near));
}

void demand_there(const fs::path& path, const std::string& kind) {
  std::error_code ignored;
  if (fs::status(path, ignored).type() == fs::file_type::not_found) throw nothing_there(path, kind);
}

std::string file_bytes(const fs::path& file) {
  demand_there(file, "file");
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (fs::is_directory(file, ignored)) throw FileError(file.string() + ": is a folder, and a file is needed");
  if (!in) throw FileError(file.string() + ": cannot be opened");
  // in blocks: what pipes and /proc hold is not known beforehand
  constexpr std::size_t k_block = 1 << 16;
  std::array<char, k_block> block{};
  std::string bytes;
  try {
    while (in.read(block.data(), block.size()) || in.gcount() > 0)
      bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
  } catch (const std::bad_alloc&) {
    throw FileError(file.string() + ": too large for the memory that there is");
  }
  if (in.bad()) throw FileError(file.string() + ": cannot be read");
  return bytes;
}

bool is_folder(const fs::path& path) {
  demand_there(path, "file or folder");
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (error) throw FileError(path.string() + ": cannot be opened: " + error.message());
  return fs::is_directory(found);
}

}  // namespace nilas
