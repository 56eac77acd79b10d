#include "apps/view/pictures/find_program.h"

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "core/base/error.h"

namespace nilas::view {

namespace {

constexpr std::array k_browsers{"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"};

bool can_run(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

/// The program of a name in the PATH, or of a path. Nothing where there is none.
std::optional<std::filesystem::path> program_of(const std::string& name) {
  if (name.find('/') != std::string::npos)
    return can_run(name) ? std::optional(std::filesystem::absolute(name)) : std::nullopt;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (!folder.empty() && can_run(std::filesystem::path(folder) / name)) return std::filesystem::path(folder) / name;
  return std::nullopt;
}

}  // namespace

std::filesystem::path find_browser(const std::string& wanted) {
  const char* const set = std::getenv("CHROME");
  const std::string named = !wanted.empty() ? wanted : set != nullptr ? set : "";
  if (!named.empty()) {
    if (const auto found = program_of(named)) return *found;
    throw InputError((wanted.empty() ? "CHROME: " : "--browser: ") + named +
                     " is no program that can be run. Name Chromium or Google Chrome");
  }
  for (const char* name : k_browsers)
    if (const auto found = program_of(name)) return *found;
  throw InputError(
      "pictures and films need Chromium or Google Chrome, which is not there. Install the package chromium, or name "
      "the browser with --browser or in CHROME");
}

std::filesystem::path find_ffmpeg() {
  if (const auto found = program_of("ffmpeg")) return *found;
  throw InputError(
      "films need the program ffmpeg, which is not there. Install the package ffmpeg. Without it, --frames DIR writes "
      "the pictures of the film as PNG files");
}

}  // namespace nilas::view
