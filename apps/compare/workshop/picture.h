#pragma once
/// The pictures of both kinds of study: a gnuplot template filled with data, drawn as SVG for the page and as PNG.
#include <nlohmann/json.hpp>
#include <string>

namespace nilas::compare {

/// One picture before it is drawn.
struct Picture {
  std::string name;             ///< name of its files without extension
  std::string script;           ///< name of its template
  int width = 960;              ///< width of the SVG [px]
  int height = 560;             ///< height of the SVG [px]
  double png_factor = 2;        ///< ratio of the size of the PNG to that of the SVG
  nlohmann::ordered_json data;  ///< data that fill the template
};

/// The script that draws `<name>.svg` and `<name>.png` in gnuplot's working folder.
std::string script_of(const Picture& picture);

}  // namespace nilas::compare
