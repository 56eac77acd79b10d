#include "core/base/order_free_sum.h"
#include "core/base/parallel.h"
#include "hydro/modules.h"
#include "hydro/prism_faces.h"
#include "hydro/sphere_surface.h"
#include "hydro/wet_body.h"

namespace nilas::hydro {

namespace {

/// A plain sum, cheaper than OrderFreeVectorSum. Its rounding depends on the order of the terms.
class PlainVectorSum {
 public:
  void add(const Vec3& x) { sum_ += x; }
  const Vec3& value() const { return sum_; }

 private:
  Vec3 sum_ = Vec3::Zero();
};

/// Form and skin drag on the faces of one body, summed in its frame B.
template <class VectorSum>
class FaceDrag {
 public:
  /// `flow` is the velocity of the water past the centre of mass [m/s], `spin` the angular velocity of the body
  /// [rad/s], both in B. `form` and `skin` are the drag coefficients times half the water's density [kg/m^3].
  FaceDrag(const Vec3& flow, const Vec3& spin, double form, double skin)
      : flow_(flow), spin_(spin), form_(form), skin_(skin) {}
  void add(double area, const Vec3& centroid, const Vec3& normal) {
    const Vec3 relative = flow_ - spin_.cross(centroid);
    const double inflow = relative.dot(normal);
    const Vec3 along = relative - inflow * normal;
    Vec3 force = skin_ * area * along.norm() * along;
    if (inflow < 0) force -= form_ * area * inflow * inflow * normal;
    force_.add(force);
    torque_.add(centroid.cross(force));
  }
  Wrench sum() const { return {force_.value(), torque_.value()}; }

 private:
  Vec3 flow_, spin_;
  double form_, skin_;  ///< [kg/m^3]
  VectorSum force_, torque_;
};

class Drag : public bodies::ForceModule {
 public:
  Drag(const Water& water, const DragCoefficients& coefficients, int threads, bool order_free)
      : water_(water), coefficients_(coefficients), threads_(threads), order_free_(order_free) {}
  std::string name() const override { return "drag"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override;
  void limit(const bodies::Bodies& bodies, double h, bodies::Wrenches& out) const override;

 private:
  struct NoResult {};
  template <class VectorSum>
  Wrench drag_on(const bodies::Bodies& bodies, std::size_t b);

  Water water_;
  DragCoefficients coefficients_;
  int threads_;
  bool order_free_;
  std::vector<WetBody<NoResult>> list_;
};

template <class VectorSum>
Wrench Drag::drag_on(const bodies::Bodies& bodies, std::size_t b) {
  const Mat3& R = bodies.R_GB[b];
  const WaterPlane plane = water_plane(R, bodies.p_GB[b], water_.level);
  FaceDrag<VectorSum> drag(R.transpose() * (water_.current - bodies.v_GB[b]), R.transpose() * bodies.w_GB[b],
                           0.5 * water_.density * coefficients_.form, 0.5 * water_.density * coefficients_.skin);
  const auto add = [&](double area, const Vec3& centroid, const Vec3& normal) { drag.add(area, centroid, normal); };
  WetGeometry& geometry = list_[b].geometry;
  if (auto* prism = std::get_if<PrismWater>(&geometry)) prism->for_each_wet_face(plane, add);
  if (auto* mesh = std::get_if<MeshWater>(&geometry)) mesh->for_each_wet_face(plane, add);
  const Wrench sum = drag.sum();
  return {R * sum.force, R * sum.torque};
}

void Drag::add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) {
  nilas::hydro::follow(bodies, list_, [](const geometry::Shape& shape) -> WetGeometry {
    if (shape.kind == geometry::ShapeKind::sphere) return MeshWater(sphere_surface(shape.radius));
    return prepare_geometry(shape);
  });
  parallel_for(bodies.size(), threads_, [&](std::ptrdiff_t i) {
    const auto b = static_cast<std::size_t>(i);
    if (!takes_water(bodies, static_cast<int>(i))) return;
    out[b] += order_free_ ? drag_on<OrderFreeVectorSum>(bodies, b) : drag_on<PlainVectorSum>(bodies, b);
  });
}

void Drag::limit(const bodies::Bodies& bodies, double h, bodies::Wrenches& out) const {
  for (std::size_t b = 0; b < out.size(); ++b) {
    Wrench& drag = out[b];
    if (!bodies.is_free(static_cast<int>(b)) || (drag.force.isZero(0) && drag.torque.isZero(0))) continue;
    const double power = drag.force.dot(water_.current - bodies.v_GB[b]) - drag.torque.dot(bodies.w_GB[b]);
    const double gain = drag.force.squaredNorm() / bodies.mass[b] +
                        drag.torque.dot(bodies.inertia_G(static_cast<int>(b)).ldlt().solve(drag.torque));
    if (!(power > 0 && h * gain > power)) continue;
    const double share = power / (h * gain);
    drag.force *= share;
    drag.torque *= share;
  }
}

}  // namespace

std::unique_ptr<bodies::ForceModule> make_drag(const Water& water, const DragCoefficients& coefficients, int threads,
                                               bool order_free) {
  return std::make_unique<Drag>(water, coefficients, threads, order_free);
}

}  // namespace nilas::hydro
