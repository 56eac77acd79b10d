#pragma once
/// The text and binary formats behind read_polygons(). CGAL 5.5's own readers allocate what a file's counts promise and
/// take indices unchecked, so that a broken file ends the program; hence these.
#include <string>

#include "core/mesh/polygon_soup.h"

namespace nilas {

/// Each takes the whole file and its name for messages; throws as read_polygons() does.
PolygonSoup parse_obj(const std::string& text, const std::string& file);
PolygonSoup parse_off(const std::string& text, const std::string& file);
PolygonSoup parse_ply(const std::string& bytes, const std::string& file);

}  // namespace nilas
