#include <cmath>

#include "core/base/error.h"
#include "core/bodies/orientation.h"
#include "core/bodies/polygon.h"
#include "core/field/field.h"
#include "core/sim/world.h"

namespace nilas {

namespace {

/// Ice keeps this many thicknesses away from the hull's outline at the start.
constexpr double k_hull_margin_thicknesses = 0.5;

/// Outline of the hull at and below height z, in G: what the ice must leave free. Empty when the hull stays above z.
std::vector<Vec2> hull_outline(const Bodies& bodies, int vessel, double z) {
  const auto v = static_cast<std::size_t>(vessel);
  std::vector<Vec2> points;
  for (const auto& part : bodies.shape[v]->parts) {
    std::vector<Vec3> corners;
    for (const auto& x : part.vertices) corners.push_back(bodies.p_GB[v] + bodies.R_GB[v] * x);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i].z() <= z) points.push_back(corners[i].head<2>());
      for (const int j : part.vertex_neighbours[i]) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[static_cast<std::size_t>(j)];
        if (a.z() < z && b.z() > z) points.push_back((a + (z - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
      }
    }
  }
  return points.size() < 3 ? std::vector<Vec2>{} : convex_hull(points);
}

/// Height of the mid-plane of a floe that floats flat; the still-water plane z = 0 where the scene has no water.
double floating_mid_plane(const WorldParts& parts, bool buoyant, double thickness, double density) {
  if (!parts.water || !buoyant) return parts.water ? parts.water->level : 0;
  return parts.water->level + thickness * (0.5 - density / parts.water->density);
}

struct FloePlacement {
  bool fixed = false;
  Vec3 velocity = Vec3::Zero();
  double z = 0;
};

class IceBuilder {
 public:
  IceBuilder(const Scene& scene, WorldParts& parts, WarningCounts& warnings)
      : scene_(scene), ice_(*scene.ice), parts_(parts), warnings_(warnings) {}

  void build() {
    for (std::size_t k = 0; k < ice_.fields.size(); ++k) add_field(ice_.fields[k], k);
    for (const auto& floe : ice_.floes) add_single(floe);
    parts_.info.ice_thickness = ice_.thickness;
    parts_.info.modules.emplace_back("ice", "<ice>: " + std::to_string(parts_.info.floes) + " floes");
  }

 private:
  void add_single(const FloeScene& floe) {
    FieldFloe shape;
    shape.outline = floe.outline;
    if (!is_simple(shape.outline))
      throw InputError(scene_.file.string() + ":" + std::to_string(floe.line) +
                       ": <floe>: the outline crosses or touches itself, or lists a point twice");
    if (is_clockwise(shape.outline)) std::reverse(shape.outline.begin(), shape.outline.end());
    shape.thickness = floe.thickness.value_or(ice_.thickness);
    const int number = parts_.info.floes + 1;
    add_floe(shape, floe.name.empty() ? "floe " + std::to_string(number) : floe.name,
             {floe.fixed, floe.velocity, floe.z});
  }

  void add_field(const FieldScene& field, std::size_t index) {
    const FieldResult result = generate(field, index);
    const double thickness = field.thickness.value_or(ice_.thickness);
    for (std::size_t i = 0; i < result.floes.size(); ++i) {
      FieldFloe floe = result.floes[i];
      if (floe.thickness <= 0) floe.thickness = thickness;
      add_floe(floe, "field " + std::to_string(index + 1) + " floe " + std::to_string(i + 1),
               {field.fixed || floe.fixed, floe.fixed ? Vec3::Zero() : field.velocity, field.z});
    }
    if (!field.fixed && result.concentration > 0) parts_.info.concentration = result.concentration;
    if (result.left_out > 0)
      warnings_.warn("ice left out", "<field> " + std::to_string(index + 1) + ": " + std::to_string(result.left_out) +
                                         " floes left out because they met the hull");
  }

  FieldResult generate(const FieldScene& field, std::size_t index) const {
    const double thickness = field.thickness.value_or(ice_.thickness);
    std::vector<std::vector<Vec2>> keep_out;
    if (parts_.vessel_index >= 0) {
      const double top = mid_plane(thickness, ice_.density) + field.z + 0.5 * thickness;
      auto outline = hull_outline(parts_.bodies, parts_.vessel_index, top);
      if (!outline.empty()) keep_out.push_back(std::move(outline));
    }
    const double margin = k_hull_margin_thicknesses * thickness;
    const Vec2 low(field.region[0], field.region[1]), high(field.region[2], field.region[3]);
    if (field.kind == "file") return read_field(field.file);
    if (field.kind == "grid")
      return grid_field(
          {low, high, field.rows, field.columns, field.gap, field.shear_deg * k_deg, field.stagger, keep_out, margin});
    if (field.kind == "level") return level_field({low, high, keep_out, margin, aft()});
    PackedSpec spec = broken_ice(field, index);
    spec.low = low;
    spec.high = high;
    spec.keep_out = std::move(keep_out);
    spec.keep_out_margin = margin;
    if (field.kind == "voronoi") return voronoi_field(spec);
    if (field.kind == "channel")
      return channel_field({spec, field.channel_width.value_or(0.5 * (high.y() - low.y())), aft()});
    return pack_field(spec);
  }

  /// Where the vessel came from, in plan: -x of its own frame.
  Vec2 aft() const {
    const int v = parts_.vessel_index;
    return v < 0 ? Vec2(-Vec2::UnitX()) : Vec2(-parts_.bodies.R_GB[static_cast<std::size_t>(v)].col(0).head<2>());
  }

  PackedSpec broken_ice(const FieldScene& field, std::size_t index) const {
    PackedSpec spec;
    spec.concentration = field.concentration;
    spec.overlap_tolerance = field.overlap_tolerance;
    spec.distribution = distribution(field.size.distribution);
    spec.mean = field.size.mean;
    spec.sd = field.size.sd;
    spec.min = field.size.min;
    spec.max = field.size.max;
    spec.exponent = field.size.exponent;
    spec.shape = field.shape.library.empty() ? shape(field.shape.kind) : FloeShape::library;
    if (spec.shape == FloeShape::library) spec.library = read_outlines(field.shape.library);
    spec.vertices_min = field.shape.vertices_min;
    spec.vertices_max = field.shape.vertices_max;
    spec.aspect = field.shape.aspect;
    spec.shear = field.shear_deg * k_deg;
    spec.seed = scene_.seed + index;
    return spec;
  }

  static SizeDistribution distribution(const std::string& name) {
    if (name == "fixed") return SizeDistribution::fixed;
    if (name == "uniform") return SizeDistribution::uniform;
    if (name == "as-library") return SizeDistribution::as_library;
    return name == "power-law" ? SizeDistribution::power_law : SizeDistribution::lognormal;
  }

  static FloeShape shape(const std::string& name) {
    if (name == "rectangle") return FloeShape::rectangle;
    if (name == "square") return FloeShape::square;
    if (name == "parallelogram") return FloeShape::parallelogram;
    return name == "disc" ? FloeShape::disc : FloeShape::polygon;
  }

  double mid_plane(double thickness, double density) const {
    return floating_mid_plane(parts_, scene_.hydro && scene_.hydro->buoyancy, thickness, density);
  }

  void add_floe(const FieldFloe& floe, const std::string& name, const FloePlacement& placement) {
    const double density = floe.density > 0 ? floe.density : ice_.density;
    const Vec2 centre = polygon_moments(floe.outline).centroid;
    std::vector<Vec2> about_centre = floe.outline;
    for (auto& x : about_centre) x -= centre;
    const MassProperties mass = prism_properties(about_centre, floe.thickness, density);
    BodySpec spec;
    spec.name = name;
    spec.kind = BodyKind::floe;
    spec.motion = placement.fixed ? Motion::fixed : Motion::free;
    spec.material = "ice";
    spec.shape = std::make_shared<const Shape>(prism_shape(about_centre, floe.thickness));
    spec.mass = mass.mass;
    spec.inertia_B = mass.inertia;
    spec.pose.p = {centre.x(), centre.y(), mid_plane(floe.thickness, density) + placement.z};
    if (!placement.fixed) spec.v = placement.velocity;
    parts_.bodies.add(spec);
    ++parts_.info.floes;
    if (!placement.fixed) parts_.info.ice_mass += mass.mass;
  }

  const Scene& scene_;
  const IceScene& ice_;
  WorldParts& parts_;
  WarningCounts& warnings_;
};

}  // namespace

void build_ice(const Scene& scene, WorldParts& parts, WarningCounts& warnings) {
  IceBuilder(scene, parts, warnings).build();
}

}  // namespace nilas
