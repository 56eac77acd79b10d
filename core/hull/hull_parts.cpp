#include "core/hull/hull_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/base/error.h"

namespace nilas::hull {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_prefix = "part-", k_ending = ".stl";

bool looks_like_part(std::string_view name) { return name.starts_with(k_prefix) && name.ends_with(k_ending); }

/// The text between "part-" and ".stl".
std::string_view number_in(std::string_view name) {
  return name.substr(k_prefix.size(), name.size() - k_prefix.size() - k_ending.size());
}

/// Numbers of any length: without leading zeros the shorter is the smaller.
bool comes_before(const fs::path& a, const fs::path& b) {
  const auto key = [](const fs::path& file) {
    const std::string name = file.filename().string();
    const std::string_view digits = number_in(name);
    return std::string(digits.substr(std::min(digits.find_first_not_of('0'), digits.size())));
  };
  const std::string x = key(a), y = key(b);
  return x.size() != y.size() ? x.size() < y.size() : x < y;
}

}  // namespace

std::string part_name(std::size_t number) { return fmt::format("{}{:04}{}", k_prefix, number, k_ending); }

bool names_part(const std::string& name) {
  return looks_like_part(name) && name.size() > k_prefix.size() + k_ending.size() &&
         number_in(name).find_first_not_of("0123456789") == std::string_view::npos;
}

std::vector<fs::path> paths_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> paths;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    paths.push_back(entry->path());
  if (error) throw FileError(folder.string() + ": cannot be read: " + error.message());
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<fs::path> part_files(const fs::path& folder) {
  std::vector<fs::path> parts;
  for (const auto& path : paths_in(folder)) {
    const std::string name = path.filename().string();
    if (names_part(name))
      parts.push_back(path);
    else if (looks_like_part(name))
      throw InputError(path.string() + ": found in a hull folder; allowed there: parts with a number, such as " +
                       part_name(1));
  }
  std::stable_sort(parts.begin(), parts.end(), comes_before);
  return parts;
}

}  // namespace nilas::hull
