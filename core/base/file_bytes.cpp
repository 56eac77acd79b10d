#include "core/base/file_bytes.h"

#include <array>
#include <fstream>
#include <new>

#include "core/base/error.h"

namespace nilas {

namespace fs = std::filesystem;

std::string file_bytes(const fs::path& file) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file, ignored)) throw FileError(file.string() + ": cannot be opened");
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
  std::error_code error;
  const fs::file_status found = fs::status(path, error);
  if (found.type() == fs::file_type::not_found) throw FileError(path.string() + ": no such file or folder");
  if (error) throw FileError(path.string() + ": cannot be opened: " + error.message());
  return fs::is_directory(found);
}

}  // namespace nilas
