#pragma once
/// Pictures of both studies: a gnuplot template filled with data, drawn as SVG for the page and as PNG.
#include <nlohmann/json.hpp>
#include <string>

namespace nilas {

/// One picture before it is drawn.
struct Picture {
  std::string name;             ///< of its files, without ending
  std::string script;           ///< name of its template
  int width = 960;              ///< of the SVG [px]
  int height = 560;             ///< [px]
  double png_factor = 2;        ///< size of the PNG over that of the SVG
  nlohmann::ordered_json data;  ///< that fills the template
};

/// The script that draws `<name>.svg` and `<name>.png` in gnuplot's working folder.
std::string script_of(const Picture& picture);

}  // namespace nilas
