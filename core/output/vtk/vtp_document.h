#pragma once
/// Head and tail of a ParaView PolyData document.
#include <cstddef>
#include <string>

namespace nilas::output {

/// Numbers of elements in a document.
struct PolyDataCounts {
  std::size_t points = 0, vertices = 0, polygons = 0;
};
std::string polydata_head(const std::string& field_data, const PolyDataCounts& counts);
inline constexpr const char* k_polydata_tail = "</Piece>\n</PolyData>\n</VTKFile>\n";

/// A document with a horizontal rectangle between two corners [m], as the surface of still water.
std::string rectangle_document(double low_x, double low_y, double high_x, double high_y, double z);

}  // namespace nilas::output
