#include "core/output/vtk/vtp_document.h"

#include <fmt/format.h>

#include <cstdint>

#include "core/output/vtk/vtp_array.h"

namespace nilas::output {

std::string polydata_head(const std::string& field_data, const PolyDataCounts& counts) {
  const std::string fields = field_data.empty() ? "" : "<FieldData>\n" + field_data + "</FieldData>\n";
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
      "compressor=\"vtkLZ4DataCompressor\">\n<PolyData>\n{}"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      fields, counts.points, counts.vertices, counts.polygons);
}

std::string rectangle_document(double low_x, double low_y, double high_x, double high_y, double z) {
  const std::vector<double> points{low_x, low_y, z, high_x, low_y, z, high_x, high_y, z, low_x, high_y, z};
  std::string text = polydata_head("", {.points = 4, .vertices = 0, .polygons = 1});
  text += "<Points>\n";
  add_data_array({"Points", "Float64", 3}, points, text);
  text += "</Points>\n<Polys>\n";
  add_data_array({"connectivity", "Int32", 1}, std::vector<std::int32_t>{0, 1, 2, 3}, text);
  add_data_array({"offsets", "Int32", 1}, std::vector<std::int32_t>{4}, text);
  return text + "</Polys>\n" + k_polydata_tail;
}

}  // namespace nilas::output
