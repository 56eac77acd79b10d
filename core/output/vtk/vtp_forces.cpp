#include "core/output/vtk/vtp_forces.h"

#include <numeric>

#include "core/output/vtk/vtp_array.h"
#include "core/output/vtk/vtp_document.h"

namespace nilas::output {

std::string contact_forces_document(const std::vector<ContactRow>& rows, double h) {
  std::vector<float> points, force, normal, gap;
  std::vector<std::int64_t> body, other;
  std::vector<std::uint8_t> status;
  for (const ContactRow& row : rows) {
    if (row.impulse.isZero(0)) continue;
    append(row.p_G, points);
    append(row.impulse / h, force);
    append(row.n, normal);
    gap.push_back(static_cast<float>(row.gap));
    body.push_back(row.body);
    other.push_back(row.other);
    status.push_back(static_cast<std::uint8_t>(row.status));
  }
  std::vector<std::int32_t> corners(body.size()), ends(body.size());
  std::iota(corners.begin(), corners.end(), 0);
  std::iota(ends.begin(), ends.end(), 1);
  std::string text = polydata_head("", {.points = body.size(), .vertices = body.size(), .polygons = 0});
  text += "<PointData Vectors=\"force_N\">\n";
  add_data_array({"force_N", "Float32", 3}, force, text);
  add_data_array({"normal", "Float32", 3}, normal, text);
  add_data_array({"gap_m", "Float32", 1}, gap, text);
  add_data_array({"body", "Int64", 1}, body, text);
  add_data_array({"other", "Int64", 1}, other, text);
  add_data_array({"status", "UInt8", 1}, status, text);
  text += "</PointData>\n<Points>\n";
  add_data_array({"Points", "Float32", 3}, points, text);
  text += "</Points>\n<Verts>\n";
  add_data_array({"connectivity", "Int32", 1}, corners, text);
  add_data_array({"offsets", "Int32", 1}, ends, text);
  return text + "</Verts>\n" + k_polydata_tail;
}

}  // namespace nilas::output
