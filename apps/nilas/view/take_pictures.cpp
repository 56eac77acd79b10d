#include "apps/nilas/view/take_pictures.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iostream>

#include "apps/view/pictures/film.h"
#include "apps/view/pictures/find_program.h"
#include "core/base/error.h"
#include "core/base/stop_request.h"
#include "core/output/file/output_file.h"
#include "core/output/text/console.h"

namespace nilas::commands {

namespace {

constexpr double k_same_time = 1e-9;  // [s]

void demand_time(const std::string& option, double time, const view::Photographer& photographer) {
  if (time < photographer.start() - k_same_time || time > photographer.end() + k_same_time)
    throw InputError(fmt::format("{}: found {:g} s; allowed: a time from {:g} to {:g} s, of which the run has frames",
                                 option, time, photographer.start(), photographer.end()));
}

void demand_folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
  if (!std::filesystem::is_directory(folder))
    throw FileError(file.string() + ": cannot be written, since there is no folder " + folder.string());
}

/// The file of a still. Several stills have their times in their names.
std::filesystem::path still_file(const PictureOptions& options, const std::filesystem::path& run,
                                 const std::string& out, double time) {
  if (out.empty()) return run / fmt::format("view-{}s.png", time);
  const std::filesystem::path file = out;
  if (options.png.size() == 1) return file;
  return file.parent_path() / fmt::format("{}-{}s{}", file.stem().string(), time, file.extension().string());
}

void write_stills(const PictureOptions& options, view::Photographer& photographer, const std::filesystem::path& run,
                  const std::string& out) {
  for (const double time : options.png) demand_time("--png", time, photographer);
  for (const double time : options.png) {
    const auto file = still_file(options, run, out, time);
    output::write_whole(file, photographer.still(time));
    std::cout << "written: " << file.string() << "\n" << std::flush;
  }
}

/// The times of a film's pictures.
struct FilmTimes {
  double from, step;  ///< [s]
  long count;

  double at(long k) const { return from + static_cast<double>(k) * step; }
};

FilmTimes times_of(const PictureOptions& options, const view::Photographer& photographer) {
  const double from = options.from.value_or(photographer.start()), until = options.until.value_or(photographer.end());
  demand_time("--from", from, photographer);
  demand_time("--until", until, photographer);
  const double step = options.speed / options.fps;
  return {from, step, 1 + std::lround(std::floor((until - from + k_same_time) / step))};
}

std::filesystem::path film_file(const PictureOptions& options, const std::filesystem::path& run,
                                const std::string& out) {
  if (!options.film->empty()) return *options.film;
  return out.empty() ? run / "view.mp4" : std::filesystem::path(out);
}

void make_empty_folder(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  if (!std::filesystem::is_empty(folder))
    throw InputError("--frames: " + folder.string() + " is not empty; name a new folder");
}

/// Draws the pictures of a film, one after the other. `take`(k, png) gets each.
void draw_film(const FilmTimes& times, view::Photographer& photographer,
               const std::function<void(long, const std::string&)>& take) {
  output::StatusLine line(std::cout);
  const bool is_terminal = output::console_style(false) == output::ConsoleStyle::terminal;
  photographer.begin_film(times.from);
  for (long k = 0; k < times.count; ++k) {
    take(k, photographer.film_frame(times.at(k)));
    if (is_terminal) line.draw(fmt::format("picture {} of {}", k + 1, times.count));
  }
  line.erase();
}

void write_film(const PictureOptions& options, view::Photographer& photographer, const std::filesystem::path& run,
                const std::string& out) {
  const FilmTimes times = times_of(options, photographer);
  const std::filesystem::path folder = options.frames;
  if (!folder.empty()) make_empty_folder(folder);
  std::optional<view::Film> film;
  if (options.film) film.emplace(film_file(options, run, out), options.fps, view::find_ffmpeg());
  draw_film(times, photographer, [&](long k, const std::string& png) {
    if (!folder.empty()) output::write_whole(folder / fmt::format("frame-{:06}.png", k), png);
    if (film) film->add(png);
  });
  if (film) film->finish();
  std::cout << fmt::format("{} pictures, {:.2f} s at {:g} pictures a second\n", times.count,
                           static_cast<double>(times.count) / options.fps, options.fps);
  if (film) std::cout << "written: " << film_file(options, run, out).string() << "\n";
  if (!folder.empty()) std::cout << "written: " << folder.string() << "/frame-000000.png ...\n";
}

}  // namespace

void take_pictures(const PictureOptions& options, const std::string& page, const std::filesystem::path& run,
                   const std::string& out) {
  if (options.film) demand_folder_of(film_file(options, run, out));
  if (options.wants_stills()) demand_folder_of(still_file(options, run, out, options.png.front()));
  listen_for_stop();
  view::Photographer photographer(page, view::find_browser(options.browser), look_of(options));
  if (options.wants_stills())
    write_stills(options, photographer, run, out);
  else
    write_film(options, photographer, run, out);
}

}  // namespace nilas::commands
