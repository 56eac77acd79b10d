#include "apps/nilas/view/picture_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <regex>

#include "apps/nilas/commands/commands.h"
#include "apps/view/pictures/find_program.h"
#include "core/base/error.h"
#include "core/scene/spec/values.h"

namespace nilas::commands {

namespace {

constexpr std::array k_cameras{"scene", "bow", "side", "top", "stern"};
/// Words of the page's address that an option of the command gives.
constexpr std::array k_own_words{"t", "frame", "play", "speed", "view", "camera"};
constexpr int k_least_pixels = 64, k_most_pixels = 8192;

struct Size {
  int width = 0, height = 0;
};

Size size_of(const PictureOptions& options) {
  if (options.size.empty()) return options.wants_film() ? Size{1280, 720} : Size{1600, 900};
  static const std::regex pattern("([0-9]{1,5})x([0-9]{1,5})");
  std::smatch found;
  if (std::regex_match(options.size, found, pattern)) {
    const Size size{std::stoi(found[1]), std::stoi(found[2])};
    const auto [low, high] = std::minmax(size.width, size.height);
    if (low >= k_least_pixels && high <= k_most_pixels) return size;
  }
  throw InputError(fmt::format("--size: found {}; allowed: WIDTHxHEIGHT in pixels, each from {} to {}, as in 1600x900",
                               options.size, k_least_pixels, k_most_pixels));
}

void check_camera(const std::string& camera) {
  if (std::find(k_cameras.begin(), k_cameras.end(), camera) != k_cameras.end()) return;
  std::vector<std::string> numbers(1);
  for (const char c : camera) {
    if (c == ',')
      numbers.emplace_back();
    else
      numbers.back() += c;
  }
  constexpr std::size_t k_numbers = 6;
  const bool all = std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return scene::parse_number(n); });
  if (all && numbers.size() == k_numbers) return;
  throw InputError("--camera: found " + camera +
                   "; allowed: scene, bow, side, top, stern, or six numbers with commas: the place of the camera and "
                   "the place that it looks at [m]");
}

void check_look(const std::string& word) {
  static const std::regex pattern("([a-z]+)=[A-Za-z0-9.]+");
  std::smatch found;
  const std::string wanted = "; allowed: NAME=VALUE with a switch of the page, as in color=force";
  if (!std::regex_match(word, found, pattern)) throw InputError("--look: found " + word + wanted);
  if (std::find(k_own_words.begin(), k_own_words.end(), found[1].str()) != k_own_words.end())
    throw InputError("--look: found " + word + wanted + ". " + found[1].str() + " has an option of its own");
}

void check_finite(const std::string& option, double value) {
  if (!std::isfinite(value)) throw InputError(fmt::format("{}: found {}; allowed: a finite number", option, value));
}

void check_film(const PictureOptions& options) {
  const std::string stray = options.from ? "--from" : options.until ? "--until" : "";
  if (!options.wants_film() && !stray.empty()) throw InputError(stray + " is for films; add --mp4 or --frames");
  if (!options.wants_film()) return;
  if (options.from && options.until && *options.from > *options.until)
    throw InputError(
        fmt::format("--until: found {:g}; allowed: a time at or after --from {:g}", *options.until, *options.from));
  const Size size = size_of(options);
  if (options.film && (size.width % 2 != 0 || size.height % 2 != 0))
    throw InputError("--size: found " + options.size + "; a film needs even numbers of pixels");
}

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
  command
      .add_option("--png", options.png,
                  "Writes pictures at these simulated times [s], separated by commas, and no page. Each shows the "
                  "stored frame at or before its time.")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      .add_option_function<std::string>(
          "--mp4", [&options](const std::string& file) { options.film = file; },
          "Writes a film into this file, and no page. The default is view.mp4 in the folder. It needs ffmpeg.")
      ->expected(0, 1)
      ->check(CLI::Validator(
          [](const std::string& file) -> std::string {
            if (file.empty() || file.ends_with(".mp4")) return "";
            return "found " + file + "; allowed: a file whose name ends with .mp4";
          },
          ""));
  command.add_option("--frames", options.frames,
                     "Writes the pictures of a film into this folder as PNG files. It needs no ffmpeg.");
  command.add_option("--from", options.from, "The film begins at this simulated time [s].");
  command.add_option("--until", options.until, "The film ends at this simulated time [s].");
  command.add_option("--speed", options.speed, "The film shows so many simulated seconds in a second.")
      ->check(above(0))
      ->capture_default_str();
  command.add_option("--fps", options.fps, "The film has so many pictures a second.")
      ->check(CLI::Range(0.1, 240.0))
      ->capture_default_str();
  command.add_option("--size", options.size,
                     "Width and height of pictures, as in 1600x900, which is the default. That of films is 1280x720.");
  command
      .add_option("--camera", options.camera,
                  "The view: scene (as <view> says), bow, side, top or stern; or six numbers with commas, the place of "
                  "the camera and the place that it looks at [m].")
      ->capture_default_str();
  command
      .add_option("--look", options.look, "Turns a switch of the page, as in color=force or graphs=1. May be repeated.")
      ->allow_extra_args(false);
  command.add_flag("--plain", options.plain, "Leaves out the bar above the picture and the legend.");
  command.add_option("--browser", options.browser,
                     "Draws with this browser. The default is what CHROME names, or Chromium or Google Chrome.");
}

void check_picture_options(const PictureOptions& options, const std::string& out) {
  if (options.wants_stills() && options.wants_film())
    throw InputError("--png and a film cannot be written at once; call the command once for each");
  for (const double time : options.png) check_finite("--png", time);
  check_finite("--from", options.from.value_or(0));
  check_finite("--until", options.until.value_or(0));
  check_finite("--speed", options.speed);
  check_film(options);
  if (!options.wants_stills() && !options.wants_film()) return;
  size_of(options);
  check_camera(options.camera);
  for (const auto& word : options.look) check_look(word);
  if (options.film && !options.film->empty() && !out.empty())
    throw InputError("--out and the file of --mp4 name the film twice");
  if (!options.film && !options.frames.empty() && !out.empty())
    throw InputError("--out is not used with --frames, which names the folder");
  if (options.film) view::find_ffmpeg();
  view::find_browser(options.browser);
}

view::PictureLook look_of(const PictureOptions& options) {
  const Size size = size_of(options);
  return {size.width, size.height, options.plain, options.camera, options.look};
}

}  // namespace nilas::commands
