#include <cstdlib>
#include <fstream>

#include "tests/fuzz/targets.h"
#include "tests/support/scratch_folder.h"

namespace nilas::fuzz {

std::filesystem::path file_with(const std::string& name, std::string_view bytes) {
  static const test::ScratchFolder folder;
  const std::filesystem::path file = folder / name;
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

}  // namespace nilas::fuzz
