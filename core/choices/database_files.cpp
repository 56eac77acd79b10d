#include "core/choices/database_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <system_error>

namespace nilas {

namespace fs = std::filesystem;

/// Radiation, excitation by Haskind's relation and by diffraction, motions, mean drift by momentum and by pressure,
/// hydrostatics, and the geometry, which states the length by which results were divided.
constexpr std::array<const char*, 8> k_wamit_endings{".1", ".2", ".3", ".4", ".8", ".9", ".hst", ".gdf"};

static std::string lower_ending(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_wamit_file(const fs::path& file) {
  return std::find(k_wamit_endings.begin(), k_wamit_endings.end(), lower_ending(file)) != k_wamit_endings.end();
}

std::vector<fs::path> database_files(const fs::path& file) {
  if (!is_wamit_file(file)) return {file};
  std::vector<fs::path> files;
  for (std::string ending : k_wamit_endings) {
    for (const bool capitals : {false, true}) {
      if (capitals)
        std::transform(ending.begin(), ending.end(), ending.begin(),
                       [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      const fs::path each = fs::path(file).replace_extension(ending);
      std::error_code ignored;
      const bool known = std::find(files.begin(), files.end(), each) != files.end();
      if (!known && fs::is_regular_file(each, ignored)) files.push_back(each);
    }
  }
  return files;
}

}  // namespace nilas
