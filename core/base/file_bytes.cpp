#include "core/base/file_bytes.h"

#include <fstream>
#include <sstream>

#include "core/base/error.h"

namespace nilas {

std::string file_bytes(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file, ignored)) throw FileError(file.string() + ": cannot be opened");
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (in.bad()) throw FileError(file.string() + ": cannot be read");
  return std::move(bytes).str();
}

}  // namespace nilas
