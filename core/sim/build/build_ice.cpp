#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/field/field.h"
#include "core/field/spec/keep_out.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/sim/build/packed_ice.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

namespace {

/// Initial distance between ice and the hull's outline [thicknesses].
constexpr double k_hull_margin_thicknesses = 0.5;

/// Outline of the hull at and below height z, frame G; the ice must leave it free. Empty when the hull stays above z.
std::vector<Vec2> hull_outline(const bodies::Bodies& bodies, int vessel, double z) {
  const auto v = static_cast<std::size_t>(vessel);
  std::vector<Vec2> points;
  for (const auto& part : bodies.shape[v]->parts) {
    std::vector<Vec3> corners;
    for (const auto& x : part.vertices) corners.push_back(bodies.p_GB[v] + bodies.R_GB[v] * x);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i].z() <= z) points.push_back(corners[i].head<2>());
      for (const int j : part.vertex_neighbours[i]) {
        const Vec3& a = corners[i];
        const Vec3& b = corners[j];
        if (a.z() < z && b.z() > z) points.push_back((a + (z - a.z()) / (b.z() - a.z()) * (b - a)).head<2>());
      }
    }
  }
  return points.size() < 3 ? std::vector<Vec2>{} : geometry::convex_hull(points);
}

/// Whether a convex counter-clockwise outline contains all points. The hull's outline contains those of everything that
/// hangs below it.
bool lies_within(const std::vector<Vec2>& points, const std::vector<Vec2>& outline) {
  return std::all_of(points.begin(), points.end(), [&](const Vec2& p) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
      if ((b - a).x() * (p - a).y() - (b - a).y() * (p - a).x() < 0) return false;
    }
    return true;
  });
}

/// Height of the mid-plane of a floe that floats flat; the still-water plane z = 0 where the scene has no water.
double floating_mid_plane(const WorldParts& parts, bool buoyant, double thickness, double density) {
  if (!parts.water || !buoyant) return parts.water ? parts.water->level : 0;
  return parts.water->level + thickness * (0.5 - density / parts.water->density);
}

class IceBuilder {
 public:
  IceBuilder(const scene::Scene& scene, int threads, WorldParts& parts, WarningCounts& warnings)
      : scene_(scene), ice_(*scene.ice), threads_(threads), parts_(parts), warnings_(warnings) {}

  void build() {
    for (std::size_t k = 0; k < ice_.fields.size(); ++k) plan_field(ice_.fields[k], k);
    if (!ice_.floes.empty()) plan_single_floes();
    if (!ice_.vary.empty()) vary();
    for (auto& planned : parts_.ice)
      for (auto& floe : planned.floes) add_floe(floe, planned);
    parts_.info.ice_thickness = ice_.thickness;
    parts_.info.modules.emplace_back("ice", "<ice>: " + std::to_string(parts_.info.floes) + " floes");
    for (const scene::VaryScene& one : ice_.vary)
      parts_.info.modules.emplace_back("vary " + name_of(one.property), reason(one));
    if (scene_.fracture) name_breakable();
  }

 private:
  /// Plans the single floes, with numbers that continue those of the fields' floes. Numbers start at 1.
  void plan_single_floes() {
    int number = 0;
    for (const auto& planned : parts_.ice) number += static_cast<int>(planned.floes.size());
    PlannedIce singles;
    singles.name = "single floes";
    for (const auto& floe : ice_.floes) singles.floes.push_back(single(floe, ++number));
    parts_.ice.push_back(std::move(singles));
  }

  PlannedFloe single(const scene::FloeScene& floe, int number) const {
    PlannedFloe planned;
    planned.floe.outline = floe.outline;
    if (!geometry::is_simple(floe.outline))
      throw InputError(scene_.file.string() + ":" + std::to_string(floe.line) +
                       ": <floe>: the outline crosses or touches itself, or lists a point twice");
    if (geometry::is_clockwise(floe.outline)) std::reverse(planned.floe.outline.begin(), planned.floe.outline.end());
    planned.name = floe.name.empty() ? "floe " + std::to_string(number) : floe.name;
    planned.fixed = floe.fixed;
    planned.breakable = floe.breakable;
    planned.velocity = floe.velocity;
    planned.z = floe.z;
    planned.means = means_of(floe.thickness);
    return planned;
  }

  /// Mean properties of floes that neither state nor vary them.
  field::FloeValues means_of(const std::optional<double>& thickness) const {
    field::FloeValues means{};
    if (const auto& fracture = scene_.fracture) {
      means[static_cast<std::size_t>(FloeProperty::flexural_strength)] = fracture->flexural_strength;
      means[static_cast<std::size_t>(FloeProperty::compressive_strength)] = fracture->compressive_strength;
      means[static_cast<std::size_t>(FloeProperty::fracture_toughness)] = fracture->fracture_toughness;
    }
    means[static_cast<std::size_t>(FloeProperty::thickness)] = thickness.value_or(ice_.thickness);
    means[static_cast<std::size_t>(FloeProperty::density)] = ice_.density;
    for (const scene::VaryScene& one : ice_.vary)
      if (one.mean > 0) means[static_cast<std::size_t>(one.property)] = one.mean;
    return means;
  }

  void plan_field(const scene::FieldScene& field, std::size_t index) {
    const auto start = std::chrono::steady_clock::now();
    PlannedIce planned;
    planned.name = "field " + std::to_string(index + 1);
    planned.field = field;
    field::FieldResult result = generate(field, index, planned);
    planned.concentration = result.concentration;
    planned.worst_overlap = result.worst_overlap;
    planned.left_out = result.left_out;
    planned.weak_lines = std::move(result.weak_lines);
    for (field::FieldFloe& floe : result.floes) {
      const bool stays = floe.fixed;
      planned.floes.push_back({std::move(floe),
                               planned.name + " floe " + std::to_string(planned.floes.size() + 1),
                               field.fixed || stays,
                               field.breakable,
                               stays ? Vec3::Zero() : field.velocity,
                               field.z,
                               means_of(field.thickness),
                               {}});
    }
    planned.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!field.fixed && result.concentration > 0) parts_.info.concentration = result.concentration;
    if (result.left_out > 0)
      warnings_.warn("ice left out", "<field> " + std::to_string(index + 1) + ": " + std::to_string(result.left_out) +
                                         " floes left out because they met the hull");
    parts_.ice.push_back(std::move(planned));
  }

  void vary() {
    const field::FloeVariation variation = floe_variation(scene_);
    for (auto& planned : parts_.ice)
      parallel_for(static_cast<std::ptrdiff_t>(planned.floes.size()), threads_, [&](std::ptrdiff_t i) {
        PlannedFloe& one = planned.floes[i];
        one.texture = variation.draw(one.floe, one.name, one.means);
      });
  }

  /// The reason for the list of what was built.
  static std::string reason(const scene::VaryScene& vary) {
    return fmt::format("<ice><vary>: {}, cov {:g}, {}", name_of(vary.distribution), vary.cov,
                       vary.correlation_length > 0 ? fmt::format("within floes over {:g} m", vary.correlation_length)
                                                   : std::string("one value per floe"));
  }

  field::FieldResult generate(const scene::FieldScene& field, std::size_t index, PlannedIce& planned) const {
    const double thickness = field.thickness.value_or(ice_.thickness);
    std::vector<std::vector<Vec2>> keep_out;
    const double top = mid_plane(thickness, ice_.density) + field.z + 0.5 * thickness;
    for (int body = parts_.vessel_index; parts_.is_of_vessel(body); ++body) {
      auto outline = hull_outline(parts_.bodies, body, top);
      const auto covers = [&](const std::vector<Vec2>& other) { return lies_within(outline, other); };
      if (!outline.empty() && std::none_of(keep_out.begin(), keep_out.end(), covers))
        keep_out.push_back(std::move(outline));
    }
    const double margin = k_hull_margin_thicknesses * thickness;
    planned.hull = keep_out;
    planned.keep_out = field::grown_outlines(keep_out, margin);
    for (auto& outline : keep_out)
      for (Vec2& p : outline) p /= scene_.scale;
    field::FieldResult result = in_scale(field, index, {std::move(keep_out), margin / scene_.scale}, planned);
    field::scale_field(result, scene_.scale);
    return result;
  }

  /// What a field keeps clear of, in the scene's unit of length.
  struct KeptClear {
    std::vector<std::vector<Vec2>> outlines;
    double margin = 0;
  };

  /// The field with the scene's scale as the unit of length: a scene that was scaled draws the same numbers as before.
  field::FieldResult in_scale(const scene::FieldScene& field, std::size_t index, const KeptClear& clear,
                              PlannedIce& planned) const {
    const double unit = scene_.scale;
    const auto place = [&](field::PackedSpec spec) {
      const auto [low, high] = corners(field);
      spec.low = low;
      spec.high = high;
      spec.keep_out = clear.outlines;
      spec.keep_out_margin = clear.margin;
      spec.seed = scene_.seed + index;
      return spec;
    };
    const auto noted = [&](const field::PackedSpec& spec) -> const field::PackedSpec& {
      planned.packed = scaled(spec, unit);
      return spec;
    };
    const auto make =
        Overloaded{[](const scene::FileFieldScene& file) { return field::read_field(file.file); },
                   [&](const scene::GridFieldScene& grid) {
                     const auto [low, high] = corners(field);
                     return field::grid_field({low, high, grid.rows, grid.columns, grid.gap / unit,
                                               grid.shear_deg * k_deg, grid.stagger, clear.outlines, clear.margin});
                   },
                   [&](const scene::LevelFieldScene&) {
                     const auto [low, high] = corners(field);
                     return field::level_field({low, high, clear.outlines, clear.margin, aft()});
                   },
                   [&](const scene::VoronoiFieldScene& cells) {
                     const field::PackedSpec spec = place(cell_spec(cells, unit));
                     if (cells.bond) return field::frozen_field(spec, aft(), *cells.bond);
                     return field::voronoi_field(noted(spec));
                   },
                   [&](const scene::ChannelFieldScene& channel) {
                     const field::PackedSpec spec = noted(place(packed_spec(channel.ice, unit)));
                     const double width = channel.width ? *channel.width / unit : 0.5 * (spec.high.y() - spec.low.y());
                     return field::channel_field({spec, width, aft()});
                   },
                   [&](const scene::PackedFieldScene& packed) {
                     return field::pack_field(noted(place(packed_spec(packed, unit))));
                   }};
    return std::visit(make, field.form);
  }

  /// The corners of a field's region, in the scene's unit of length.
  std::pair<Vec2, Vec2> corners(const scene::FieldScene& field) const {
    const scene::RegionScene& region = *field.region();
    return {Vec2(region[0], region[1]) / scene_.scale, Vec2(region[2], region[3]) / scene_.scale};
  }

  /// Horizontal direction from which the vessel comes: -x of its own frame.
  Vec2 aft() const {
    const int v = parts_.vessel_index;
    return v < 0 ? Vec2(-Vec2::UnitX()) : Vec2(-parts_.bodies.R_GB[v].col(0).head<2>());
  }

  bool is_buoyant() const { return scene_.hydro && scene_.hydro->buoyancy; }
  double mid_plane(double thickness, double density) const {
    return floating_mid_plane(parts_, is_buoyant(), thickness, density);
  }

  void add_floe(PlannedFloe& planned, const PlannedIce& group) {
    field::FieldFloe& floe = planned.floe;
    for (const FloeProperty property : {FloeProperty::thickness, FloeProperty::density})
      if (field::value_of(floe, property) <= 0)
        field::value_of(floe, property) = planned.means[static_cast<std::size_t>(property)];
    const Vec2 centre = geometry::polygon_moments(floe.outline).centroid;
    std::vector<Vec2> about_centre = floe.outline;
    for (auto& x : about_centre) x -= centre;
    const geometry::MassProperties mass = geometry::prism_properties(about_centre, floe.thickness, floe.density);
    bodies::BodySpec spec;
    spec.name = planned.name;
    spec.kind = bodies::BodyKind::floe;
    spec.motion = planned.fixed ? bodies::Motion::fixed : bodies::Motion::free;
    spec.material = "ice";
    spec.shape = std::make_shared<const geometry::Shape>(geometry::prism_shape(about_centre, floe.thickness));
    spec.mass = mass.mass;
    spec.inertia_B = mass.inertia;
    spec.pose.p = {centre.x(), centre.y(), mid_plane(floe.thickness, floe.density) + planned.z};
    if (!planned.fixed) spec.v = planned.velocity;
    const int body = parts_.bodies.add(spec);
    if (scene_.fracture) {
      add_strengths(planned, body);
      add_weak_lines(group, centre, about_centre, body);
    }
    ++parts_.info.floes;
    if (!planned.fixed) parts_.info.ice_mass += mass.mass;
  }

  void add_strengths(const PlannedFloe& planned, int body) {
    const auto strength = [&](FloeProperty property) {
      bodies::FloeStrength of_floe{field::value_of(planned.floe, property), {}};
      if (of_floe.mean <= 0) of_floe.mean = planned.means[static_cast<std::size_t>(property)];
      for (const field::TexturedProperty& one : planned.texture)
        if (one.property == property)
          of_floe.at_xy = [texture = one.texture](double x, double y) { return texture.at(x, y); };
      return of_floe;
    };
    if (!parts_.ice_properties) parts_.ice_properties = std::make_unique<bodies::IceProperties>();
    bodies::IceProperties& ice = *parts_.ice_properties;
    ice.resize(parts_.bodies.id.size());
    const auto b = static_cast<std::size_t>(body);
    ice.breakable[b] = planned.breakable ? 1 : 0;
    ice.flexural_strength[b] = strength(FloeProperty::flexural_strength);
    ice.compressive_strength[b] = strength(FloeProperty::compressive_strength);
    ice.fracture_toughness[b] = strength(FloeProperty::fracture_toughness);
  }

  void add_weak_lines(const PlannedIce& group, const Vec2& centre, const std::vector<Vec2>& outline, int body) {
    std::vector<bodies::WeakLine> lines = group.weak_lines;
    for (const scene::WeakLineScene& line : ice_.weak_lines) lines.push_back({line.points, line.strength});
    parts_.ice_properties->weak_lines[body] = bodies::lines_near(lines, centre, outline);
  }

  void name_breakable() {
    long breakable = 0;
    for (const auto& planned : parts_.ice)
      breakable += std::count_if(planned.floes.begin(), planned.floes.end(), [](const auto& f) { return f.breakable; });
    parts_.info.modules.emplace_back("fracture", fmt::format("<fracture>: {} breakable floes", breakable));
  }

  const scene::Scene& scene_;
  const scene::IceScene& ice_;
  int threads_;
  WorldParts& parts_;
  WarningCounts& warnings_;
};

}  // namespace

void build_ice(const scene::Scene& scene, int threads, WorldParts& parts, WarningCounts& warnings) {
  IceBuilder(scene, threads, parts, warnings).build();
}

}  // namespace nilas::sim
