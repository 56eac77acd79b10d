#include "core/field/outline_library.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/field/field.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace nilas::field {

namespace {

using nlohmann::json;

/// Reads one list of outlines and describes its faults.
class LibraryReader {
 public:
  explicit LibraryReader(const std::filesystem::path& file) : file_(file) {}

  std::vector<std::vector<Vec2>> read(const json& list) {
    if (!list.is_array() || list.empty()) refuse("expected a list of outlines");
    std::vector<std::vector<Vec2>> outlines;
    for (const json& points : list) {
      ++outline_;
      outlines.push_back(outline(points));
    }
    return outlines;
  }

  [[noreturn]] void refuse(const std::string& message) const {
    const std::string place = outline_ > 0 ? ": outline " + std::to_string(outline_) : "";
    throw InputError(file_.string() + place + ": " + message);
  }

 private:
  std::vector<Vec2> outline(const json& points) const {
    if (!points.is_array() || points.empty()) refuse("expected a list of points");
    std::vector<Vec2> corners;
    if (points.front().is_number()) {
      if (points.size() % 2 != 0) refuse(fmt::format("found {} numbers, allowed x y pairs", points.size()));
      for (std::size_t k = 0; k < points.size(); k += 2) corners.push_back(point(points[k], points[k + 1]));
    } else {
      for (const json& p : points) {
        if (!p.is_array() || p.size() != 2) refuse("found " + p.dump() + ", allowed [x, y] in metres");
        corners.push_back(point(p[0], p[1]));
      }
    }
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) refuse(fmt::format("found {} corners, allowed 3 or more", corners.size()));
    if (corners.size() > k_most_corners)
      refuse(fmt::format("found {} corners, allowed {} or fewer", corners.size(), k_most_corners));
    if (!geometry::is_simple(corners)) refuse("the outline crosses or touches itself");
    if (geometry::is_clockwise(corners)) std::reverse(corners.begin(), corners.end());
    if (!(geometry::polygon_moments(corners).area > 0)) refuse("the outline has no area");
    return corners;
  }

  Vec2 point(const json& x, const json& y) const {
    if (!x.is_number() || !y.is_number()) refuse("found " + x.dump() + " " + y.dump() + ", allowed x y in metres");
    const Vec2 p(x.get<double>(), y.get<double>());
    if (!p.allFinite()) refuse("a point is not finite");
    return p;
  }

  const std::filesystem::path& file_;
  int outline_ = 0;  ///< counted from 1; 0: the file as a whole
};

}  // namespace

std::vector<std::vector<Vec2>> read_outlines(const std::filesystem::path& file) {
  const json root = json::parse(json_file_text(file), nullptr, false);
  LibraryReader reader(file);
  if (root.is_discarded()) reader.refuse("the file is not JSON, or is cut short");
  if (!root.is_object()) return reader.read(root);
  if (root.contains("bodies")) return reader.read(root["bodies"]);
  std::vector<std::vector<Vec2>> outlines;
  for (FieldFloe& floe : read_field(file).floes) outlines.push_back(std::move(floe.outline));
  if (outlines.empty()) reader.refuse("the file has no outlines");
  return outlines;
}

}  // namespace nilas::field
