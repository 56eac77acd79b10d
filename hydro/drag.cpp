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
    add_force(area, centroid, normal, relative_at(centroid));
  }
  Wrench sum() const { return {force_.value(), torque_.value()}; }

 protected:
  Vec3 relative_at(const Vec3& centroid) const { return flow_ - spin_.cross(centroid); }
  Vec3 add_force(double area, const Vec3& centroid, const Vec3& normal, const Vec3& relative) {
    const double inflow = relative.dot(normal);
    const Vec3 along = relative - inflow * normal;
    Vec3 force = skin_ * area * along.norm() * along;
    if (inflow < 0) force -= form_ * area * inflow * inflow * normal;
    force_.add(force);
    torque_.add(centroid.cross(force));
    return force;
  }

 private:
  Vec3 flow_, spin_;
  double form_, skin_;  ///< [kg/m^3]
  VectorSum force_, torque_;
};

/// The same where the water moves past each face by a velocity of its own.
template <class VectorSum>
class FlowDrag : public FaceDrag<VectorSum> {
 public:
  using FaceDrag<VectorSum>::FaceDrag;
  /// `more` is the velocity of the water at this face in addition to `flow` [m/s], in B.
  void add(double area, const Vec3& centroid, const Vec3& normal, const Vec3& more) {
    const Vec3 relative = this->relative_at(centroid) + more;
    power_.add(relative.cwiseProduct(this->add_force(area, centroid, normal, relative)));
  }
  /// What the forces take from the motion through the water [W].
  double power() const { return power_.value().sum(); }

 private:
  VectorSum power_;  ///< along each axis of B
};

/// The motion of a body through the water that its drag sees. Out of plane, it sees no surge, sway and yaw, and gives
/// no such load.
struct SeenMotion {
  Vec3 flow, spin;  ///< velocity of the water past the centre of mass [m/s], angular velocity of the body [rad/s], in G
  bool out_of_plane;

  SeenMotion(const Vec3& flow_G, const Vec3& spin_G, bool only_out_of_plane)
      : flow(flow_G), spin(spin_G), out_of_plane(only_out_of_plane) {
    if (!out_of_plane) return;
    flow.head<2>().setZero();
    spin.z() = 0;
  }
  Wrench kept(Wrench load) const {
    if (!out_of_plane) return load;
    load.force.head<2>().setZero();
    load.torque.z() = 0;
    return load;
  }
};

Flows flows_on_vessel(const Flows& flows) {
  Flows found;
  for (const auto& flow : flows)
    if (flow->acts_on_vessel()) found.push_back(flow);
  return found;
}

class Drag : public bodies::ForceModule {
 public:
  Drag(const Water& water, const DragCoefficients& coefficients, int threads, bool order_free,
       bool vessel_in_plane_elsewhere)
      : water_(water),
        flows_on_vessel_(nilas::hydro::flows_on_vessel(water.flows)),
        coefficients_(coefficients),
        threads_(threads),
        order_free_(order_free),
        vessel_in_plane_elsewhere_(vessel_in_plane_elsewhere) {}
  std::string name() const override { return "drag"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }
  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override;
  void limit(const bodies::Bodies& bodies, double h, bodies::Wrenches& out) const override;

 private:
  struct Dissipation {
    double power = 0;  ///< What the drag of add_forces() takes from the motion through water that has flows [W].
  };
  const Flows& flows_on(const bodies::Bodies& bodies, std::size_t b) const {
    return bodies.kind[b] == bodies::BodyKind::vessel ? flows_on_vessel_ : water_.flows;
  }
  template <class VectorSum>
  Wrench drag_on(const bodies::Bodies& bodies, std::size_t b);
  template <class VectorSum>
  Wrench drag_in_flows_on(const bodies::Bodies& bodies, std::size_t b, double t);
  SeenMotion seen_motion(const bodies::Bodies& bodies, std::size_t b) const {
    return {water_.current - bodies.v_GB[b], bodies.w_GB[b],
            vessel_in_plane_elsewhere_ && bodies.kind[b] == bodies::BodyKind::vessel};
  }
  double power_taken(const bodies::Bodies& bodies, std::size_t b, const Wrench& drag) const;

  Water water_;
  Flows flows_on_vessel_;
  DragCoefficients coefficients_;
  int threads_;
  bool order_free_, vessel_in_plane_elsewhere_;
  std::vector<WetBody<Dissipation>> list_;
};

/// Visits the wet faces of a body; nothing of a shape without faces.
template <class Visit>
void for_each_wet_face(WetGeometry& geometry, const WaterPlane& plane, const Visit& visit) {
  if (auto* prism = std::get_if<PrismWater>(&geometry)) prism->for_each_wet_face(plane, visit);
  if (auto* mesh = std::get_if<MeshWater>(&geometry)) mesh->for_each_wet_face(plane, visit);
}

template <class VectorSum>
Wrench Drag::drag_on(const bodies::Bodies& bodies, std::size_t b) {
  const Mat3& R = bodies.R_GB[b];
  const WaterPlane plane = water_plane(R, bodies.p_GB[b], water_.level);
  const SeenMotion seen = seen_motion(bodies, b);
  FaceDrag<VectorSum> drag(R.transpose() * seen.flow, R.transpose() * seen.spin,
                           0.5 * water_.density * coefficients_.form, 0.5 * water_.density * coefficients_.skin);
  for_each_wet_face(list_[b].geometry, plane,
                    [&](double area, const Vec3& centroid, const Vec3& normal) { drag.add(area, centroid, normal); });
  const Wrench sum = drag.sum();
  return seen.kept({R * sum.force, R * sum.torque});
}

template <class VectorSum>
Wrench Drag::drag_in_flows_on(const bodies::Bodies& bodies, std::size_t b, double t) {
  const Mat3& R = bodies.R_GB[b];
  const Flows& flows = flows_on(bodies, b);
  const WaterPlane plane = water_plane(R, bodies.p_GB[b], water_.level);
  const SeenMotion seen = seen_motion(bodies, b);
  FlowDrag<VectorSum> drag(R.transpose() * seen.flow, R.transpose() * seen.spin,
                           0.5 * water_.density * coefficients_.form, 0.5 * water_.density * coefficients_.skin);
  for_each_wet_face(list_[b].geometry, plane, [&](double area, const Vec3& centroid, const Vec3& normal) {
    const Vec3 p = bodies.p_GB[b] + R * centroid;
    Vec3 more = Vec3::Zero();
    for (const auto& flow : flows) more += flow->velocity(p, t);
    if (seen.out_of_plane) more.head<2>().setZero();
    drag.add(area, centroid, normal, R.transpose() * more);
  });
  list_[b].result.power = drag.power();
  const Wrench sum = drag.sum();
  return seen.kept({R * sum.force, R * sum.torque});
}

void Drag::add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) {
  nilas::hydro::follow(bodies, list_, [](const geometry::Shape& shape) -> WetGeometry {
    if (shape.kind == geometry::ShapeKind::sphere) return MeshWater(sphere_surface(shape.radius));
    return prepare_geometry(shape);
  });
  parallel_for(bodies.size(), threads_, [&](std::ptrdiff_t i) {
    const auto b = static_cast<std::size_t>(i);
    if (!takes_water(bodies, static_cast<int>(i))) return;
    if (flows_on(bodies, b).empty())
      out[b] += order_free_ ? drag_on<OrderFreeVectorSum>(bodies, b) : drag_on<PlainVectorSum>(bodies, b);
    else
      out[b] += order_free_ ? drag_in_flows_on<OrderFreeVectorSum>(bodies, b, t)
                            : drag_in_flows_on<PlainVectorSum>(bodies, b, t);
  });
}

/// The power that the drag takes from the motion through the water [W]. Where the water moves as a whole it follows
/// from the wrench. Elsewhere it is the sum over the faces that add_forces() made: with the velocity of the water at
/// one point alone, drag on a body at the edge of a jet could seem to give energy, or to take almost none.
double Drag::power_taken(const bodies::Bodies& bodies, std::size_t b, const Wrench& drag) const {
  if (!flows_on(bodies, b).empty()) return list_[b].result.power;
  return drag.force.dot(water_.current - bodies.v_GB[b]) - drag.torque.dot(bodies.w_GB[b]);
}

/// A bound on the gain of limit(), which spares nearly all bodies the solution with their inertia.
static double most_gain(const bodies::Bodies& bodies, std::size_t b, const Wrench& drag) {
  constexpr double k_rounding = 1e-9;
  const double turning = bodies.inertia_inverse_B[b].trace();
  return (1 + k_rounding) * (drag.force.squaredNorm() / bodies.mass[b] + turning * drag.torque.squaredNorm());
}

void Drag::limit(const bodies::Bodies& bodies, double h, bodies::Wrenches& out) const {
  for (std::size_t b = 0; b < out.size(); ++b) {
    Wrench& drag = out[b];
    if (!bodies.is_free(static_cast<int>(b)) || (drag.force.isZero(0) && drag.torque.isZero(0))) continue;
    const double power = power_taken(bodies, b, drag);
    if (power > h * most_gain(bodies, b, drag)) continue;
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
                                               bool order_free, bool vessel_in_plane_elsewhere) {
  return std::make_unique<Drag>(water, coefficients, threads, order_free, vessel_in_plane_elsewhere);
}

}  // namespace nilas::hydro
