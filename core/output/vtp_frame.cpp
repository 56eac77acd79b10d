#include "core/output/vtp_frame.h"

#include <fmt/format.h>

#include "core/output/vtp_array.h"

namespace nilas {

namespace {

std::uint8_t kind_number(BodyKind kind) {
  switch (kind) {
    case BodyKind::floe:
      return 0;
    case BodyKind::vessel:
      return 1;
    case BodyKind::rigid:
      return 2;
    case BodyKind::wall:
      return 3;
  }
  return 2;
}

void append(const Vec3& x, std::vector<float>& out) {
  for (const double component : x) out.push_back(static_cast<float>(component));
}

}  // namespace

void VtpFrame::clear() {
  points_.clear();
  speed_.clear();
  velocity_.clear();
  corners_.clear();
  ends_.clear();
  id_.clear();
  kind_.clear();
}

void VtpFrame::add(const Bodies& bodies, std::size_t b, const PolygonSurface& surface) {
  const auto first_point = static_cast<std::int32_t>(points_.size() / 3);
  const auto first_corner = static_cast<std::int32_t>(corners_.size());
  for (const Vec3& x : surface.points) append(bodies.p_GB[b] + bodies.R_GB[b] * x, points_);
  for (const std::int32_t corner : surface.corners) corners_.push_back(first_point + corner);
  for (const std::int32_t end : surface.ends) {
    ends_.push_back(first_corner + end);
    append(bodies.v_GB[b], velocity_);
  }
  const std::size_t facets = ends_.size();
  speed_.resize(facets, static_cast<float>(bodies.v_GB[b].norm()));
  id_.resize(facets, bodies.id[b]);
  kind_.resize(facets, kind_number(bodies.kind[b]));
}

const std::string& VtpFrame::document() {
  text_ = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
      "compressor=\"vtkLZ4DataCompressor\">\n<PolyData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"{}\">\n",
      points_.size() / 3, ends_.size());
  text_ += "<CellData Scalars=\"speed_m_s\" Vectors=\"velocity_m_s\">\n";
  add_data_array({"id", "Int64", 1}, id_, text_);
  add_data_array({"kind", "UInt8", 1}, kind_, text_);
  add_data_array({"speed_m_s", "Float32", 1}, speed_, text_);
  add_data_array({"velocity_m_s", "Float32", 3}, velocity_, text_);
  text_ += "</CellData>\n<Points>\n";
  add_data_array({"Points", "Float32", 3}, points_, text_);
  text_ += "</Points>\n<Polys>\n";
  add_data_array({"connectivity", "Int32", 1}, corners_, text_);
  add_data_array({"offsets", "Int32", 1}, ends_, text_);
  return text_ += "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace nilas
