#include "hydro/wind/wind.h"

#include <cmath>
#include <vector>

#include "core/geometry/mass_properties.h"

namespace nilas::hydro {

namespace {

class WindLoads : public bodies::ForceModule {
 public:
  WindLoads(const WindSettings& settings, double level, std::uint64_t seed, const std::optional<WindOnVessel>& vessel)
      : settings_(settings), wind_(settings, seed), level_(level), vessel_(vessel) {}
  std::string name() const override { return "wind"; }
  bodies::VesselLoad load_on_vessel() const override {
    return vessel_ ? bodies::VesselLoad::own : bodies::VesselLoad::none;
  }
  /// It sets floes in motion, at no one velocity.
  std::optional<Vec3> drift() const override {
    return settings_.speed > 0 && settings_.floe_drag > 0 ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
  }
  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override {
    if (vessel_) out[static_cast<std::size_t>(vessel_->hull)] += on_vessel(bodies, t);
    if (settings_.floe_drag > 0) add_to_floes(bodies, t, out);
  }

 private:
  Wrench on_vessel(const bodies::Bodies& bodies, double t) const;
  void add_to_floes(const bodies::Bodies& bodies, double t, bodies::Wrenches& out);
  double face_area(const std::shared_ptr<const geometry::Shape>& shape, std::size_t b);

  struct Face {
    std::shared_ptr<const geometry::Shape> shape;
    double area = 0;  ///< of the upper face [m^2]
  };

  WindSettings settings_;
  Wind wind_;
  double level_;
  std::optional<WindOnVessel> vessel_;
  std::vector<Face> faces_;  ///< one per body, computed again where another shape takes the place
};

Wrench WindLoads::on_vessel(const bodies::Bodies& bodies, double t) const {
  const int hull = vessel_->hull;
  const WindArea& area = vessel_->area;
  const Mat3& R = bodies.R_GB[hull];
  const Vec3 up = Vec3::UnitZ(), bow(R(0, 0), R(1, 0), 0);
  if (bow.isZero(0)) return {};  // the vessel stands on end
  const Vec3 forward = bow.normalized(), port = up.cross(forward);
  Vec3 midship = bodies.p_GB[hull] + R * vessel_->midship;
  const Vec3 relative = wind_.velocity(area.height, t) - bodies.velocity_at(hull, midship);
  midship.z() = level_;
  const double along = relative.dot(forward), across = relative.dot(port);
  const double q = 0.5 * settings_.density * (along * along + across * across);
  const WindCoefficients c = wind_coefficients(area, std::atan2(across, -along));
  const Vec3 surge = q * c.CX * area.frontal * forward, sway = q * c.CY * area.lateral * port;
  const Vec3 arm = midship - bodies.p_GB[hull];
  return {surge + sway, (arm + area.height * up).cross(surge) + (arm + c.heel * area.height * up).cross(sway) +
                            q * c.CN * area.lateral * area.length * up};
}

double WindLoads::face_area(const std::shared_ptr<const geometry::Shape>& shape, std::size_t b) {
  if (faces_[b].shape != shape) faces_[b] = {shape, geometry::polygon_moments(shape->outline).area};
  return faces_[b].area;
}

/// There is no limit for long steps: a step changes the velocity of ice of thickness H by the share
/// h rho C_a |w| / (rho_ice H) of w, below 1e-3 for ice of 1 cm in a storm and a step of 0.1 s.
void WindLoads::add_to_floes(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) {
  faces_.resize(out.size());
  const Vec3 wind = wind_.reference_velocity(t);
  for (std::size_t b = 0; b < out.size(); ++b) {
    if (bodies.kind[b] != bodies::BodyKind::floe || bodies.motion[b] != bodies::Motion::free) continue;
    const auto& shape = bodies.shape[b];
    const Vec3 normal = bodies.R_GB[b].col(2);
    const Vec3 arm = (normal.z() < 0 ? -0.5 : 0.5) * shape->thickness * normal;
    if (!(bodies.p_GB[b].z() + arm.z() > level_)) continue;
    const Vec3 v = bodies.v_GB[b], w(wind.x() - v.x(), wind.y() - v.y(), 0);
    const double area = face_area(shape, b) * std::abs(normal.z());
    const Vec3 force = settings_.density * settings_.floe_drag * area * w.norm() * w;
    out[b].force += force;
    out[b].torque += arm.cross(force);
  }
}

}  // namespace

std::unique_ptr<bodies::ForceModule> make_wind(const WindSettings& settings, double level, std::uint64_t seed,
                                               const std::optional<WindOnVessel>& vessel) {
  return std::make_unique<WindLoads>(settings, level, seed, vessel);
}

}  // namespace nilas::hydro
