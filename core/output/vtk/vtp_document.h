#pragma once
/// What stands around the arrays of a ParaView PolyData document.
#include <cstddef>
#include <string>

namespace nilas {

/// Elements that a document holds; `field_data`: its arrays, may be empty.
struct PolyDataCounts {
  std::size_t points = 0, vertices = 0, polygons = 0;
};
std::string polydata_head(const std::string& field_data, const PolyDataCounts& counts);
inline constexpr const char* k_polydata_tail = "</Piece>\n</PolyData>\n</VTKFile>\n";

/// A horizontal rectangle between two corners [m], as the surface of still water.
std::string rectangle_document(double low_x, double low_y, double high_x, double high_y, double z);

}  // namespace nilas
