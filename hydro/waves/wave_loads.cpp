#include "hydro/waves/wave_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "hydro/sphere_surface.h"
#include "hydro/waves/even_surface.h"
#include "hydro/waves/wave_surface.h"
#include "hydro/wet_body.h"

namespace nilas::hydro {

namespace {

using bodies::BodyKind;

/// The hull is the first body of the vessel; -1 without a vessel.
int hull_of(const bodies::Bodies& bodies) {
  const auto found = std::find(bodies.kind.begin(), bodies.kind.end(), BodyKind::vessel);
  return found == bodies.kind.end() ? -1 : static_cast<int>(found - bodies.kind.begin());
}

class WaveLoads : public bodies::ForceModule {
 public:
  WaveLoads(const Water& water, std::shared_ptr<const WaveField> field, const WaveLoadSettings& settings,
            const bodies::Bodies& bodies, int threads);
  std::string name() const override { return "wave_loads"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }
  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override;
  void end_substep(const bodies::Bodies& bodies, double t, double /*h*/) override {
    elevation_ = field_->elevation(reference(bodies).head<2>(), t);
  }
  std::vector<std::string> columns() const override { return {"wave_elevation_m"}; }
  void append_values(std::vector<double>& values) const override { values.push_back(elevation_); }

 private:
  struct Surfaced {
    std::shared_ptr<const geometry::Shape> shape;
    std::unique_ptr<const WaveSurface> surface;
  };

  bool takes_pressure(const bodies::Bodies& bodies, int b) const;
  std::unique_ptr<const WaveSurface> surface_of(const geometry::Shape& shape) const;
  void follow_shapes(const bodies::Bodies& bodies);
  void refuse_coarse_hull(const bodies::Bodies& bodies) const;
  void prepare_database(const bodies::Bodies& bodies);
  double yaw_of(const bodies::Bodies& bodies) const;
  Vec3 reference(const bodies::Bodies& bodies) const;
  Wrench load_from_database(const bodies::Bodies& bodies, double t) const;
  Wrench load_of_added_mass(const bodies::Bodies& bodies, int b, double t) const;

  Water water_;
  std::shared_ptr<const WaveField> field_;
  WaveLoadSettings settings_;
  int threads_;
  std::vector<Surfaced> list_;
  std::optional<VesselExcitation> excitation_;
  double elevation_ = 0;  ///< at the end of the last substep [m]
};

WaveLoads::WaveLoads(const Water& water, std::shared_ptr<const WaveField> field, const WaveLoadSettings& settings,
                     const bodies::Bodies& bodies, int threads)
    : water_(water), field_(std::move(field)), settings_(settings), threads_(threads) {
  if (field_->components().empty() || hull_of(bodies) < 0) return;
  if (settings_.hull_pressure) refuse_coarse_hull(bodies);
  if (settings_.database) prepare_database(bodies);
}

void WaveLoads::refuse_coarse_hull(const bodies::Bodies& bodies) const {
  const auto b = static_cast<std::size_t>(hull_of(bodies));
  const double edge = longest_wet_edge(bodies.shape[b]->surface, bodies.R_GB[b], bodies.p_GB[b], water_.level);
  const double shortest = field_->shortest_length();
  if (shortest < 2 * edge)
    throw InputError(fmt::format(
        "Froude-Krylov loads on '{}': found a wave {:.3g} m long, and a wet edge of the hull mesh {:.3g} m long; "
        "allowed are waves of at least twice the longest edge, {:.3g} m; refine the mesh or set <waves "
        "shortest_period>",
        bodies.name[b], shortest, edge, 2 * edge));
}

void WaveLoads::prepare_database(const bodies::Bodies& bodies) {
  const DatabaseWaveLoads& given = *settings_.database;
  excitation_.emplace(*given.database, *field_, given.drift);
  const double yaw = yaw_of(bodies);
  excitation_->check_headings(*field_, yaw);
  if (!settings_.hull_pressure) return;
  // The pose of the hull in the axes of D, with still water at z = 0.
  const auto b = static_cast<std::size_t>(hull_of(bodies));
  const Mat3 turn = Eigen::AngleAxisd(-yaw, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 origin = reference(bodies);
  const Vec3 foot(origin.x(), origin.y(), water_.level);
  const auto surface = surface_of(*bodies.shape[b]);
  const Mat3 R = turn * bodies.R_GB[b];
  const Vec3 p = turn * (bodies.p_GB[b] - foot);
  excitation_->subtract([&](std::size_t i, double heading) {
    const WaveComponent& wave = field_->components()[i];
    return surface->linear_load(R, p, water_, wave_direction(heading), wave.number, field_->trains()[wave.train].depth);
  });
}

double WaveLoads::yaw_of(const bodies::Bodies& bodies) const {
  const Mat3& R = bodies.R_GB[static_cast<std::size_t>(hull_of(bodies))];
  return std::atan2(R(1, 0), R(0, 0)) + settings_.database->yaw_BD;
}

Vec3 WaveLoads::reference(const bodies::Bodies& bodies) const {
  const int hull = hull_of(bodies);
  if (hull < 0) return Vec3::Zero();
  const auto b = static_cast<std::size_t>(hull);
  return bodies.p_GB[b] + (settings_.database ? Vec3(bodies.R_GB[b] * settings_.database->origin_B) : Vec3::Zero());
}

Wrench WaveLoads::load_from_database(const bodies::Bodies& bodies, double t) const {
  const Vec3 origin = reference(bodies);
  const double yaw = yaw_of(bodies);
  const Vec6 load = excitation_->load(*field_, WaveColumn(*field_, origin.head<2>(), t), yaw, t);
  const Mat3 turn = Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 force = turn * load.head<3>();
  const Vec3 arm = origin - bodies.p_GB[static_cast<std::size_t>(hull_of(bodies))];
  return {force, turn * load.tail<3>() + arm.cross(force)};
}

Wrench WaveLoads::load_of_added_mass(const bodies::Bodies& bodies, int b, double t) const {
  const Vec3& p = bodies.p_GB[b];
  const WaveColumn column(*field_, p.head<2>(), t);
  const double z = p.z() - water_.level;
  Vec6 water;
  water << column.acceleration(z), column.tilt_acceleration(z);
  const Vec6 load = bodies.added_mass_G(b) * water;
  return {load.head<3>(), load.tail<3>()};
}

bool WaveLoads::takes_pressure(const bodies::Bodies& bodies, int b) const {
  const bool of_vessel = bodies.kind[b] == BodyKind::vessel;
  return (of_vessel ? settings_.hull_pressure : settings_.floe_pressure) && takes_water(bodies, b);
}

std::unique_ptr<const WaveSurface> WaveLoads::surface_of(const geometry::Shape& shape) const {
  constexpr double k_edges_per_wave = 8;  // then loads of the shortest wave differ by less than 1e-3 from the integrals
  const double longest = field_->shortest_length() / k_edges_per_wave;
  if (shape.kind == geometry::ShapeKind::sphere)
    return std::make_unique<const WaveSurface>(sphere_surface(shape.radius), longest);
  if (shape.kind == geometry::ShapeKind::prism)
    return std::make_unique<const WaveSurface>(even_surface(shape), longest);
  return std::make_unique<const WaveSurface>(water_surface(shape), longest);
}

/// Bodies come and go as ice breaks.
void WaveLoads::follow_shapes(const bodies::Bodies& bodies) {
  list_.resize(bodies.shape.size());
  parallel_for(bodies.size(), threads_, [&](std::ptrdiff_t i) {
    const int b = static_cast<int>(i);
    if (list_[b].shape != bodies.shape[b] && takes_pressure(bodies, b))
      list_[b] = {bodies.shape[b], surface_of(*bodies.shape[b])};
  });
}

void WaveLoads::add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) {
  if (field_->components().empty()) return;
  follow_shapes(bodies);
  parallel_for(bodies.size(), threads_, [&](std::ptrdiff_t i) {
    const int b = static_cast<int>(i);
    if (!takes_pressure(bodies, b)) return;
    out[b] += list_[b].surface->load(bodies.R_GB[b], bodies.p_GB[b], water_, *field_, t);
    if (bodies.has_added_mass() && bodies.is_free(b)) out[b] += load_of_added_mass(bodies, b, t);
  });
  if (excitation_) out[static_cast<std::size_t>(hull_of(bodies))] += load_from_database(bodies, t);
}

}  // namespace

std::unique_ptr<bodies::ForceModule> make_wave_loads(const Water& water, std::shared_ptr<const WaveField> field,
                                                     const WaveLoadSettings& settings, const bodies::Bodies& bodies,
                                                     int threads) {
  NILAS_DEMAND(field != nullptr && (!settings.database || settings.database->database != nullptr));
  return std::make_unique<WaveLoads>(water, std::move(field), settings, bodies, threads);
}

}  // namespace nilas::hydro
