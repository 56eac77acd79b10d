#include "hydro/restoring/restoring.h"

#include <algorithm>
#include <cmath>

namespace nilas::hydro {

namespace {

class Restoring : public bodies::ForceModule {
 public:
  Restoring(const RestoredHull& hull, const Mat6& restoring)
      : hull_(hull),
        at_rest_(hull.lift * Vec3(-1, -hull.lift_centre.y(), hull.lift_centre.x())),
        stiffness_(restoring.block<3, 3>(2, 2)) {
    stiffness_ = (0.5 * (stiffness_ + stiffness_.transpose())).eval();
    const double of_weight = hull.mass * hull.gravity * -(hull.D_in_B.q.conjugate() * hull.D_in_B.p).z();
    stiffness_(1, 1) += of_weight;
    stiffness_(2, 2) += of_weight;
  }
  std::string name() const override { return "restoring"; }
  bool conservative() const override { return true; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }

  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    const State now = state(bodies);
    const Vec3 along = -gradient(now.q);  // forces along the three coordinates
    const Vec3 force(0, 0, along[0]);
    // The axes about which the angles turn: roll about X of D, pitch about Y after yaw; no load along yaw.
    Mat3 axes;
    axes.row(0) = (now.R * Vec3::UnitX()).transpose();
    axes.row(1) = (Eigen::AngleAxisd(now.yaw, Vec3::UnitZ()) * Vec3::UnitY()).transpose();
    axes.row(2) = Vec3::UnitZ().transpose();
    const Vec3 torque = axes.partialPivLu().solve(Vec3(along[1], along[2], 0));
    const auto b = static_cast<std::size_t>(hull_.body);
    out[b] += Wrench{force, torque + (now.origin - bodies.p_GB[b]).cross(force)};
  }

  double potential_energy(const bodies::Bodies& bodies) override {
    const Vec3 q = state(bodies).q;
    return at_rest_.dot(q) + 0.5 * q.dot(stiffness_ * q);
  }

 private:
  struct State {
    Vec3 origin;  ///< of D, in G
    Mat3 R;       ///< of D, in G
    double yaw;
    Vec3 q;  ///< heave, roll, pitch
  };
  State state(const bodies::Bodies& bodies) const {
    const auto b = static_cast<std::size_t>(hull_.body);
    State now;
    now.origin = bodies.p_GB[b] + bodies.R_GB[b] * hull_.D_in_B.p;
    now.R = bodies.R_GB[b] * hull_.D_in_B.q.toRotationMatrix();
    now.yaw = std::atan2(now.R(1, 0), now.R(0, 0));
    const double pitch = std::asin(std::clamp(-now.R(2, 0), -1.0, 1.0));
    const double roll = std::atan2(now.R(2, 1), now.R(2, 2));
    now.q = Vec3(now.origin.z() - hull_.level, roll, pitch);
    return now;
  }
  Vec3 gradient(const Vec3& q) const { return at_rest_ + stiffness_ * q; }

  RestoredHull hull_;
  Vec3 at_rest_;    ///< gradient of the potential at q = 0 [N, N m, N m]
  Mat3 stiffness_;  ///< of the water alone, in heave, roll and pitch
};

}  // namespace

Mat6 restoring_with_weight_at(const Database& database, double specific_weight, double weight, const Vec3& com_D) {
  // Hydrostatics are volumes, areas and their moments times the specific weight.
  const double ratio = specific_weight / (database.density * database.gravity);
  Mat6 restoring = ratio * database.restoring.value();
  if (!database.centre_of_gravity) return restoring;
  const double own = database.volume ? specific_weight * *database.volume : weight;
  const double change = own * database.centre_of_gravity->z() - weight * com_D.z();
  restoring(3, 3) += change;
  restoring(4, 4) += change;
  return restoring;
}

std::unique_ptr<bodies::ForceModule> make_restoring(const RestoredHull& hull, const Mat6& restoring) {
  return std::make_unique<Restoring>(hull, restoring);
}

}  // namespace nilas::hydro
