#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/field/field.h"
#include "core/field/pack/overlaps.h"
#include "core/field/sizes/floe_property.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace nilas::field {

namespace {

using nlohmann::json;

/// Reads one GeoJSON file and describes its faults.
class FieldReader {
 public:
  explicit FieldReader(const std::filesystem::path& file) : file_(file) {}

  FieldResult read() {
    const json root = json::parse(json_file_text(file_), nullptr, false);
    if (root.is_discarded()) refuse("the file is not JSON, or is cut short");
    if (!root.is_object() || root.value("type", json()) != "FeatureCollection")
      refuse("expected a GeoJSON object of type FeatureCollection");
    if (!root.contains("features") || !root["features"].is_array()) refuse("expected an array \"features\"");
    FieldResult result;
    for (const json& feature : root["features"]) {
      ++feature_;
      const json& geometry = geometry_of(feature);
      if (geometry.value("type", json()) == "LineString")
        result.weak_lines.push_back(weak_line(feature, geometry));
      else
        result.floes.push_back(floe(feature, geometry));
    }
    feature_ = 0;
    if (root.contains("properties")) result.concentration = number(root["properties"], "concentration");
    return result;
  }

 private:
  [[noreturn]] void refuse(const std::string& message) const {
    const std::string place = feature_ > 0 ? ": feature " + std::to_string(feature_) : "";
    throw InputError(file_.string() + place + ": " + message);
  }

  const json& geometry_of(const json& feature) const {
    if (!feature.is_object() || !feature.contains("geometry") || !feature["geometry"].is_object())
      refuse("expected a Feature with a geometry");
    return feature["geometry"];
  }

  bodies::WeakLine weak_line(const json& feature, const json& geometry) const {
    const json line = geometry.value("coordinates", json());
    if (!line.is_array() || line.size() < 2) refuse("expected coordinates: an array of two points or more");
    const double strength = feature.contains("properties") ? number(feature["properties"], "strength") : 0;
    if (!(strength > 0 && strength <= 1)) refuse("strength of a weak line: allowed a number > 0 and <= 1");
    return {points(line), strength};
  }

  FieldFloe floe(const json& feature, const json& geometry) const {
    const json type = geometry.value("type", json());
    if (type != "Polygon") refuse("geometry type: found " + type.dump() + ", allowed \"Polygon\", \"LineString\"");
    const json rings = geometry.value("coordinates", json());
    if (!rings.is_array() || rings.empty()) refuse("expected coordinates: an array with one ring of points");
    if (rings.size() > 1) refuse(fmt::format("found {} rings, allowed 1: a floe has no holes", rings.size()));
    FieldFloe floe;
    floe.outline = outline(rings[0]);
    if (feature.contains("properties") && !feature["properties"].is_null()) {
      for (const FloeProperty property : k_floe_properties)
        value_of(floe, property) = number(feature["properties"], std::string(column_of(property)));
      floe.fixed = feature["properties"].value("fixed", json()) == true;
    }
    return floe;
  }

  std::vector<Vec2> points(const json& list) const {
    std::vector<Vec2> all;
    for (const json& p : list) {
      if (!p.is_array() || p.size() != 2 || !p[0].is_number() || !p[1].is_number())
        refuse("point " + std::to_string(all.size() + 1) + ": found " + p.dump() + ", allowed [x, y] in metres");
      all.emplace_back(p[0].get<double>(), p[1].get<double>());
      if (!all.back().allFinite()) refuse("point " + std::to_string(all.size()) + " is not finite");
    }
    return all;
  }

  std::vector<Vec2> outline(const json& ring) const {
    if (!ring.is_array()) refuse("expected a ring: an array of points");
    std::vector<Vec2> points = this->points(ring);
    constexpr std::size_t k_fewest_points = 4;  // a triangle and its closing point
    if (points.size() < k_fewest_points) refuse(fmt::format("found {} points, allowed 4 or more", points.size()));
    if (points.size() > k_most_corners)
      refuse(fmt::format("found {} points, allowed {} or fewer", points.size(), k_most_corners));
    if (points.front() != points.back()) refuse("the ring is not closed: its last point must repeat the first");
    points.pop_back();
    if (!geometry::is_simple(points)) refuse("the outline crosses or touches itself");
    if (geometry::is_clockwise(points)) std::reverse(points.begin(), points.end());
    return points;
  }

  double number(const json& properties, const std::string& name) const {
    if (!properties.is_object() || !properties.contains(name)) return 0;
    const json& value = properties[name];
    if (!value.is_number() || !(value.get<double>() >= 0) || !std::isfinite(value.get<double>()))
      refuse(name + ": found " + value.dump() + ", allowed a number of 0 or more");
    return value.get<double>();
  }

  const std::filesystem::path& file_;
  int feature_ = 0;  ///< counted from 1; 0: the file as a whole
};

double deepest_of_pieces(const std::vector<std::vector<Vec2>>& a, const std::vector<std::vector<Vec2>>& b) {
  double deepest = 0;
  for (const auto& piece : a)
    for (const auto& other : b) deepest = std::max(deepest, geometry::convex_overlap(piece, other));
  return deepest;
}

double deepest_between(const std::vector<FieldFloe>& floes) {
  std::vector<LooseFloe> circles;
  std::vector<std::vector<std::vector<Vec2>>> pieces;
  for (const FieldFloe& floe : floes) {
    circles.push_back(loose_floe(floe.outline));
    pieces.emplace_back();
    if (geometry::is_convex(floe.outline))
      pieces.back().push_back(floe.outline);
    else
      pieces.back() = geometry::convex_pieces(floe.outline);
  }
  double deepest = 0;
  for (const auto& [a, b] : near_pairs(circles, 1, 0))
    deepest = std::max(deepest, deepest_of_pieces(pieces[a], pieces[b]));
  return deepest;
}

json feature_of(const FieldFloe& floe) {
  json ring = json::array();
  for (const Vec2& p : floe.outline) ring.push_back({p.x(), p.y()});
  ring.push_back(ring.front());
  json properties = json::object();
  for (const FloeProperty property : k_floe_properties)
    if (const double value = value_of(floe, property); value > 0) properties[std::string(column_of(property))] = value;
  if (floe.fixed) properties["fixed"] = true;
  return {{"type", "Feature"},
          {"properties", properties},
          {"geometry", {{"type", "Polygon"}, {"coordinates", json::array({ring})}}}};
}

json feature_of(const bodies::WeakLine& line) {
  json points = json::array();
  for (const Vec2& p : line.points) points.push_back({p.x(), p.y()});
  return {{"type", "Feature"},
          {"properties", {{"strength", line.strength}}},
          {"geometry", {{"type", "LineString"}, {"coordinates", points}}}};
}

}  // namespace

void scale_field(FieldResult& field, double scale) {
  const double by_toughness = scale * std::sqrt(scale);
  for (FieldFloe& floe : field.floes) {
    for (Vec2& p : floe.outline) p *= scale;
    floe.thickness *= scale;
    floe.flexural_strength *= scale;
    floe.compressive_strength *= scale;
    floe.fracture_toughness *= by_toughness;
  }
  for (bodies::WeakLine& line : field.weak_lines)
    for (Vec2& p : line.points) p *= scale;
  field.worst_overlap *= scale;
}

FieldResult read_field(const std::filesystem::path& file) {
  FieldResult result = FieldReader(file).read();
  result.worst_overlap = deepest_between(result.floes);
  return result;
}

void write_field(const FieldResult& field, const std::filesystem::path& file) {
  json features = json::array();
  for (const FieldFloe& floe : field.floes) features.push_back(feature_of(floe));
  for (const bodies::WeakLine& line : field.weak_lines) features.push_back(feature_of(line));
  const json root = {{"type", "FeatureCollection"},
                     {"properties", {{"concentration", field.concentration}, {"worst_overlap_m", field.worst_overlap}}},
                     {"features", std::move(features)}};
  std::ofstream out(file);
  out << root.dump() << '\n';
  out.close();
  if (!out) throw FileError(file.string() + ": cannot write the ice field");
}

}  // namespace nilas::field
