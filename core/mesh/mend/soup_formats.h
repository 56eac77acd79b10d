#pragma once
/// The text and binary formats behind read_polygons(). CGAL 5.5's own readers (CGAL::IO::read_polygon_soup) were tried
/// on sixteen broken files: five were taken with corners that name no point or with fewer than three of them, one ended
/// the program, one lost a coordinate. Of 100 lengths of an OBJ cut short 51 were taken with such corners, of 150
/// binary PLY with changed bytes 80, and three PLY crashed. No refusal names a line. Lines joined by a backslash, a
/// byte order mark and an OFF file without its keyword are refused, which these take.
#include <string>

#include "core/mesh/mend/polygon_soup.h"

namespace nilas::mesh {

/// Each takes the whole file and its name for messages; throws as read_polygons() does.
PolygonSoup parse_obj(const std::string& text, const std::string& file);
PolygonSoup parse_off(const std::string& text, const std::string& file);
PolygonSoup parse_ply(const std::string& bytes, const std::string& file);

}  // namespace nilas::mesh
