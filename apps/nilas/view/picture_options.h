#pragma once
/// The options of `nilas view` for pictures and films.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/view/pictures/photographer.h"

namespace nilas::commands {

struct PictureOptions {
  std::vector<double> png;          ///< times of the stills [s]
  std::optional<std::string> film;  ///< the film's file; empty: that of the run folder
  std::string frames;               ///< folder for the pictures of a film; empty: none
  std::optional<double> from, until;
  double speed = 1, fps = 25;
  std::string size, camera = "scene", browser;
  std::vector<std::string> look;
  bool plain = false;

  bool wants_stills() const { return !png.empty(); }
  bool wants_film() const { return film.has_value() || !frames.empty(); }
};

void add_picture_options(CLI::App& command, PictureOptions& options);

/// Throws InputError for options that do not go together, for a size, a camera or a look that cannot be, and where a
/// program that they need is missing. `out`: that of --out.
void check_picture_options(const PictureOptions& options, const std::string& out);

/// The look that the options ask for; they are checked.
view::PictureLook look_of(const PictureOptions& options);

}  // namespace nilas::commands
