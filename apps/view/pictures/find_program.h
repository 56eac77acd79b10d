#pragma once
/// Programs of others that draw pictures and films.
#include <filesystem>
#include <string>

namespace nilas::view {

/// The browser: the file or name `wanted`, or where it is empty what CHROME names, or else the first of chromium,
/// chromium-browser, google-chrome and google-chrome-stable in the PATH. Throws InputError that names the package to
/// install.
std::filesystem::path find_browser(const std::string& wanted);

/// The program ffmpeg in the PATH. Throws InputError that names the package and the way without it.
std::filesystem::path find_ffmpeg();

}  // namespace nilas::view
