#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/field/field.h"
#include "core/field/pack/place_floes.h"
#include "core/field/shapes/power_diagram.h"
#include "core/field/sizes/floe_sizes.h"
#include "core/field/spec/keep_out.h"
#include "core/field/spec/packed_spec.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

constexpr int k_compact_rounds = 10;  ///< cells become compact, but differ in shape
constexpr double k_area_accuracy = 1e-9;

/// Drawn areas, scaled by one factor (by at most half a floe in total) to sum to `wanted` [m^2].
std::vector<double> areas_of(const PackedSpec& spec, double wanted) {
  RandomStream sizes(spec.seed, "field sizes");
  std::vector<double> areas = draw_areas(spec, wanted, sizes);
  if (areas.empty()) throw InputError(fmt::format("voronoi field: {:.3g} m^2 of ice is less than half a floe", wanted));
  double sum = 0;
  for (const double area : areas) sum += area;
  for (double& area : areas) area *= wanted / sum;
  return areas;
}

/// Initial sites, spread like circles of the floes' areas.
PowerSites first_sites(const std::vector<double>& areas, const FieldBounds& bounds, std::uint64_t seed) {
  std::vector<LooseFloe> circles(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) {
    circles[i].area = areas[i];
    circles[i].radius = std::sqrt(areas[i] / k_pi);
  }
  RandomStream places(seed, "field places");
  place_floes(circles, bounds, places);
  PowerSites sites;
  for (const LooseFloe& circle : circles) {
    sites.points.push_back(circle.centre);
    sites.weights.push_back(0);
  }
  return sites;
}

std::vector<PowerCell> cells_of(const std::vector<double>& areas, const FieldBounds& bounds, std::uint64_t seed) {
  PowerSites sites = first_sites(areas, bounds, seed);
  return cells_with_areas(sites, areas, bounds, k_compact_rounds, k_area_accuracy);
}

/// The cell shrunk about its centroid to `area` [m^2].
FieldFloe shrunk(const PowerCell& cell, double area) {
  const Vec2 centre = geometry::polygon_moments(cell.outline).centroid;
  const double scale = std::min(1.0, std::sqrt(area / cell.area));
  FieldFloe floe;
  for (const Vec2& corner : cell.outline) floe.outline.push_back(centre + scale * (corner - centre));
  return floe;
}

}  // namespace

FieldResult voronoi_field(const PackedSpec& spec) {
  check_packed_spec(spec);
  const FieldBounds bounds = field_bounds(spec);
  const double water = free_area(bounds);
  const std::vector<double> areas = areas_of(spec, spec.concentration * water);
  const std::vector<PowerCell> cells = cells_of(areas, bounds, spec.seed);
  double room = 1;
  for (std::size_t i = 0; i < cells.size(); ++i) room = std::min(room, cells[i].area / areas[i]);
  if (room < 1 - k_area_accuracy)
    throw InputError(fmt::format(
        "voronoi field: concentration: found {}, but convex cells beside the keep-out outlines leave room for about "
        "{:.3f}; lower it",
        spec.concentration, room * spec.concentration));
  FieldResult result;
  double ice = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    result.floes.push_back(shrunk(cells[i], areas[i]));
    ice += geometry::polygon_moments(result.floes.back().outline).area;
  }
  result.concentration = ice / water;
  return result;
}

/// The cells cover the whole region, including what is left out: a seam ends where the sheet does.
FieldResult frozen_field(const PackedSpec& spec, const Vec2& aft, double strength) {
  PackedSpec whole = spec;
  whole.concentration = 1;
  whole.keep_out.clear();
  check_packed_spec(whole);
  const FieldBounds bounds = field_bounds(whole);
  const std::vector<PowerCell> cells = cells_of(areas_of(whole, free_area(bounds)), bounds, whole.seed);
  FieldResult result = level_field({spec.low, spec.high, spec.keep_out, spec.keep_out_margin, aft});
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < cells[i].outline.size(); ++k)
      if (cells[i].beyond[k] > static_cast<int>(i))
        result.weak_lines.push_back(
            {{cells[i].outline[k], cells[i].outline[(k + 1) % cells[i].outline.size()]}, strength});
  return result;
}

}  // namespace nilas::field
