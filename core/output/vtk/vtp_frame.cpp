#include "core/output/vtk/vtp_frame.h"

#include "core/output/vtk/vtp_array.h"
#include "core/output/vtk/vtp_document.h"

namespace nilas::output {

namespace {

std::uint8_t kind_number(bodies::BodyKind kind) {
  switch (kind) {
    case bodies::BodyKind::floe:
      return 0;
    case bodies::BodyKind::vessel:
      return 1;
    case bodies::BodyKind::rigid:
      return 2;
    case bodies::BodyKind::wall:
      return 3;
  }
  return 2;
}

}  // namespace

void VtpFrame::clear(bool with_damage) {
  with_damage_ = with_damage;
  points_.clear();
  thickness_.clear();
  damage_.clear();
  speed_.clear();
  velocity_.clear();
  corners_.clear();
  ends_.clear();
  id_.clear();
  kind_.clear();
  body_id_.clear();
  body_name_.clear();
}

void VtpFrame::add(const bodies::Bodies& bodies, std::size_t b, const PolygonSurface& surface, double damage) {
  const auto first_point = static_cast<std::int32_t>(points_.size() / 3);
  const auto first_corner = static_cast<std::int32_t>(corners_.size());
  for (const Vec3& x : surface.points) append(bodies.p_GB[b] + bodies.R_GB[b] * x, points_);
  for (const std::int32_t corner : surface.corners) corners_.push_back(first_point + corner);
  for (const std::int32_t end : surface.ends) {
    ends_.push_back(first_corner + end);
    append(bodies.v_GB[b], velocity_);
  }
  const std::size_t facets = ends_.size();
  thickness_.resize(facets, static_cast<float>(bodies.shape[b]->thickness));
  damage_.resize(facets, static_cast<float>(damage));
  speed_.resize(facets, static_cast<float>(bodies.v_GB[b].norm()));
  id_.resize(facets, bodies.id[b]);
  kind_.resize(facets, kind_number(bodies.kind[b]));
  body_id_.push_back(bodies.id[b]);
  body_name_.push_back(bodies.name[b]);
}

const std::string& VtpFrame::document() {
  std::string field_data;
  add_data_array({"body_id", "Int64", 1, true}, body_id_, field_data);
  add_text_array("body_name", body_name_, field_data);
  text_ = polydata_head(field_data, {.points = points_.size() / 3, .vertices = 0, .polygons = ends_.size()});
  text_ += "<CellData Scalars=\"speed_m_s\" Vectors=\"velocity_m_s\">\n";
  add_data_array({"id", "Int64", 1}, id_, text_);
  add_data_array({"kind", "UInt8", 1}, kind_, text_);
  add_data_array({"thickness_m", "Float32", 1}, thickness_, text_);
  if (with_damage_) add_data_array({"damage", "Float32", 1}, damage_, text_);
  add_data_array({"speed_m_s", "Float32", 1}, speed_, text_);
  add_data_array({"velocity_m_s", "Float32", 3}, velocity_, text_);
  text_ += "</CellData>\n<Points>\n";
  add_data_array({"Points", "Float32", 3}, points_, text_);
  text_ += "</Points>\n<Polys>\n";
  add_data_array({"connectivity", "Int32", 1}, corners_, text_);
  add_data_array({"offsets", "Int32", 1}, ends_, text_);
  text_ += "</Polys>\n";
  return text_ += k_polydata_tail;
}

}  // namespace nilas::output
