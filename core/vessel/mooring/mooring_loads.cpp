#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/vessel/mooring/line_shape.h"
#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

namespace {

/// Where a line pulls on the hull, in G.
struct Fairlead {
  Vec3 arm;                   ///< from the centre of mass
  Vec3 spoke = Vec3::Zero();  ///< from the turret's centre; zero for a line on the hull
};

class Geometry {
 public:
  Geometry(const MooringModel& model, const Pose& pose)
      : model_(model), R_(pose.q.toRotationMatrix()), p_(pose.p), axis_(R_.col(2)) {
    if (model.turret) centre_ = R_ * model.turret->at_B;
  }
  Fairlead at(const MooringLine& line, double angle) const {
    if (!line.on_turret) return {R_ * line.fairlead_B};
    const Vec3 spoke = R_ * (Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Vec3(line.fairlead_B - model_.turret->at_B));
    return {centre_ + spoke, spoke};
  }
  LineForce force(const MooringLine& line, const Fairlead& fairlead) const {
    return line_force(line, model_.bed, p_ + fairlead.arm);
  }
  const Vec3& axis() const { return axis_; }      ///< the turret's axis
  const Vec3& centre() const { return centre_; }  ///< the turret's centre from the centre of mass

 private:
  const MooringModel& model_;
  Mat3 R_;
  Vec3 p_, axis_, centre_ = Vec3::Zero();
};

bool turns(const MooringModel& model, const MooringState& state, std::size_t k) {
  return model.lines[k].on_turret && state.broken[k] == 0;
}

/// Moment of the lines about the turret's axis, and its derivative by the turret's angle.
struct Moment {
  double value = 0, slope = 0;
};
Moment moment_at(const MooringModel& model, const MooringState& state, const Geometry& geometry, double angle) {
  Moment sum;
  for (std::size_t k = 0; k < model.lines.size(); ++k) {
    if (!turns(model, state, k)) continue;
    const Fairlead fairlead = geometry.at(model.lines[k], angle);
    const LineForce force = geometry.force(model.lines[k], fairlead);
    const Vec3 moved = geometry.axis().cross(fairlead.spoke);
    sum.value += geometry.axis().dot(fairlead.spoke.cross(force.on_fairlead));
    sum.slope += geometry.axis().dot(moved.cross(force.on_fairlead) - fairlead.spoke.cross(force.stiffness * moved));
  }
  return sum;
}

/// The damped pull of a line on a fairlead with velocity v: the tension grows where the fairlead moves against it.
Vec3 damped(const MooringLine& line, const LineForce& force, const Vec3& v, double& tension) {
  const double still = force.on_fairlead.norm();
  tension = force.tension();
  if (!(line.damping > 0) || !(still > 0)) return force.on_fairlead;
  const Vec3 pull = force.on_fairlead / still;
  const double moving = std::max(0.0, still - line.damping * v.dot(pull));
  tension = std::max(moving, force.anchor_tension + moving - still);
  return moving * pull;
}

}  // namespace

double turret_angle(const MooringModel& model, const MooringState& state, const Pose& pose) {
  if (!model.turret) return 0;
  const Geometry geometry(model, pose);
  const Moment start = moment_at(model, state, geometry, state.turret_angle);
  const double friction = model.turret->friction;
  if (!(std::abs(start.value) > friction)) return state.turret_angle;
  constexpr double k_stride = 0.1;       // longest turn of one pass [rad]
  constexpr double k_last_turn = 1e-13;  // about the rounding of an angle [rad]
  constexpr int k_passes = 200;
  const double way = start.value > 0 ? 1 : -1;
  const auto excess = [&](const Moment& moment) { return way * moment.value - friction; };
  double turned = 0, low = 0, high = 2 * k_pi;  // along the way
  Moment here = start;
  for (int pass = 0; pass < k_passes; ++pass) {
    const double over = excess(here);
    (over > 0 ? low : high) = turned;
    const double before = turned, newton = here.slope < 0 ? -over / here.slope : k_stride;
    turned += std::clamp(newton, -k_stride, k_stride);
    if (!(turned >= low && turned <= high)) turned = 0.5 * (low + high);
    if (std::abs(turned - before) <= k_last_turn) return state.turret_angle + way * turned;
    here = moment_at(model, state, geometry, state.turret_angle + way * turned);
  }
  throw SimulationError("the mooring lines of the turret find no balance about its axis");
}

MooringLoads mooring_loads(const MooringModel& model, const MooringState& state, const HullMotion& hull) {
  const Geometry geometry(model, hull.pose);
  const Vec3 rolling = hull.w - hull.w.dot(geometry.axis()) * geometry.axis();
  MooringLoads loads;
  loads.tensions.assign(model.lines.size(), 0);
  for (std::size_t k = 0; k < model.lines.size(); ++k) {
    if (state.broken[k] != 0) continue;
    const MooringLine& line = model.lines[k];
    const Fairlead fairlead = geometry.at(line, state.turret_angle);
    const LineForce force = geometry.force(line, fairlead);
    Vec3 v = hull.v + hull.w.cross(fairlead.arm);
    if (line.on_turret) v = hull.v + hull.w.cross(geometry.centre()) + rolling.cross(fairlead.spoke);
    const Vec3 pull = damped(line, force, v, loads.tensions[k]);
    loads.on_hull += {pull, fairlead.arm.cross(pull)};
  }
  return loads;
}

Mat6 mooring_damping(const MooringModel& model, const MooringState& state, const Pose& pose) {
  const Geometry geometry(model, pose);
  Mat6 sum = Mat6::Zero();
  for (std::size_t k = 0; k < model.lines.size(); ++k) {
    if (state.broken[k] != 0) continue;
    const MooringLine& line = model.lines[k];
    const Fairlead fairlead = geometry.at(line, state.turret_angle);
    // A slack spring pulls once it is tight, along the straight line.
    const Vec3 pull = geometry.force(line, fairlead).on_fairlead;
    const Vec3 along = (pull.norm() > 0 ? pull : Vec3(line.anchor - pose.p - fairlead.arm)).normalized();
    Vec6 way;
    way << along, fairlead.arm.cross(along);
    sum += line.damping * way * way.transpose();
  }
  return sum;
}

Mat6 mooring_stiffness(const MooringModel& model, const MooringState& state, const Pose& pose) {
  const Geometry geometry(model, pose);
  Mat6 sum = Mat6::Zero();
  Vec6 mixed = Vec6::Zero();  // by the turret's angle
  double turret = 0;
  for (std::size_t k = 0; k < model.lines.size(); ++k) {
    if (state.broken[k] != 0) continue;
    const Fairlead fairlead = geometry.at(model.lines[k], state.turret_angle);
    const LineForce force = geometry.force(model.lines[k], fairlead);
    const Mat3 arm = skew(fairlead.arm);
    sum.topLeftCorner<3, 3>() += force.stiffness;
    sum.topRightCorner<3, 3>() -= force.stiffness * arm;
    sum.bottomLeftCorner<3, 3>() += arm * force.stiffness;
    sum.bottomRightCorner<3, 3>() -= arm * force.stiffness * arm + skew(force.on_fairlead) * arm;
    if (!model.lines[k].on_turret) continue;
    const Vec3 moved = geometry.axis().cross(fairlead.spoke), change = force.stiffness * moved;
    mixed.head<3>() += change;
    mixed.tail<3>() += fairlead.arm.cross(change) - moved.cross(force.on_fairlead);
    turret += geometry.axis().dot(fairlead.spoke.cross(change) - moved.cross(force.on_fairlead));
  }
  if (model.turret && model.turret->friction == 0 && turret > 0) sum -= mixed * mixed.transpose() / turret;
  return sum;
}

std::vector<std::vector<Vec3>> mooring_shapes(const MooringModel& model, const MooringState& state, const Pose& pose) {
  const Geometry geometry(model, pose);
  std::vector<std::vector<Vec3>> shapes(model.lines.size());
  for (std::size_t k = 0; k < model.lines.size(); ++k) {
    if (state.broken[k] != 0) continue;
    const Fairlead fairlead = geometry.at(model.lines[k], state.turret_angle);
    shapes[k] = line_shape(model.lines[k], model.bed, pose.p + fairlead.arm);
  }
  return shapes;
}

}  // namespace nilas::vessel
