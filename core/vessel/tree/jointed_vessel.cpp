/// The vessel of several bodies: its state, its rest and its readings.
#include "core/vessel/tree/jointed_vessel.h"

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "core/vessel/tree/jointed_rest.h"
#include "core/vessel/tree/rods.h"

namespace nilas::vessel {

namespace {

Wrench over(const Wrench& impulse, double h) { return {impulse.force / h, impulse.torque / h}; }

}  // namespace

JointedVessel::JointedVessel(const VesselModel& model, double t0)
    : VesselMotion(model, t0),
      model_(model),
      tree_(model),
      theta_(model.theta.value_or(1)),
      damper_share_(model.theta ? 0.5 : 1),
      impulses_(model.parts.size() + 1, tree_.num_rods()) {
  NILAS_DEMAND(model.gyroscopic);
  if (model.carriage) {
    if (model.carriage->balance == BalanceKind::six_cells) cells_ = hull_cells(*model.carriage, tree_.num_speeds());
    motion_ = model.carriage->motion;
    now_ = motion_->at(t0);
    tree_.set_carriage(now_);
  }
  if (has_rods()) {
    if (const auto fault = rod_fault(model, t0))
      throw InputError("rod '" + model.rods[fault->rod].name + "': " + fault->message);
    start_on_rods(model, tree_);
  }
  rods_ = model.rods;
  loose_ = loose_speeds(tree_, cells_);
  parts_.resize(model.parts.size());
  joint_account_.held.resize(size());
  read_states();
  for (int b = 0; b < tree_.num_bodies(); ++b) after_.push_back(tree_.twist(b));
}

double JointedVessel::spring_energy() const {
  const VecX x = tree_.stretch();
  return 0.5 * x.dot(tree_.stiffness().cwiseProduct(x)) + tree_.cell_energy();
}

VesselRest JointedVessel::settle(const RestModel& rest, bool start_there) {
  NILAS_DEMAND(h_ == 0);
  if (!motion_) return {};
  const VecX placed = tree_.coordinates(), u = tree_.speeds();
  const auto put_back = [&] {
    tree_.set_carriage(now_);
    tree_.set_speeds(u);
    tree_.set_coordinates(placed);
  };
  const JointedRest found = [&] {
    try {
      return jointed_rest(tree_, model_, rest, now_);
    } catch (...) {
      put_back();  // the search left the tree where it failed
      throw;
    }
  }();
  const CarriageLoads before = loads_;
  tree_.set_carriage(now_);
  tree_.set_speeds(u);
  tree_.set_coordinates(found.coordinates);
  read_states();
  read_carriage(found.carried);
  const CarriageLoads carried = loads_;
  if (found.moving || !start_there) {
    tree_.set_coordinates(placed);
    read_states();
    loads_ = before;
  }
  for (int b = 0; b < tree_.num_bodies(); ++b) after_[b] = tree_.twist(b);
  if (!found.moving) return {carried, {}};
  if (*found.moving == 0) return {};
  return {{}, static_cast<std::size_t>(*found.moving - 1)};
}

VecX JointedVessel::coordinates() const {
  const VecX q = tree_.coordinates(), u = tree_.speeds();
  VecX all(q.size() + u.size());
  all << q, u;
  return all;
}

void JointedVessel::read_states() {
  const auto state = [this](int b) -> VesselState {
    const Vec6 twist = tree_.twist(b);
    return {tree_.pose(b), twist.head<3>(), twist.tail<3>()};
  };
  state_ = state(0);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const int part = static_cast<int>(k);
    parts_[k].state = state(part + 1);
    parts_[k].coordinates = tree_.part_coordinates(part);
    parts_[k].rates = tree_.part_rates(part);
  }
}

/// Change of a body's momenta minus the impulses of all loads on it, as a mean over the step.
Wrench JointedVessel::unbalanced(std::size_t b, const Wrench& given) const {
  const Vec6 gained = (tree_.momentum(static_cast<int>(b)) - momenta_[b]) / h_;
  const Wrench net = over(impulses_.net[b], h_);
  return {gained.head<3>() - given.force - net.force, gained.tail<3>() - given.torque - net.torque};
}

void JointedVessel::read_carriage(const Wrench& about_point) {
  loads_.about_joint = loads_.about_com = about_point;
  loads_.about_com.torque += (now_.p - state_.pose.p).cross(about_point.force);
  if (cells_) loads_.cells = cell_readings(cells_->layout, about_point, now_.yaw);
}

/// Writes the means over the step, and the residuals of the momenta. `given` includes the rods' loads in the velocity
/// step.
void JointedVessel::read_loads(const std::vector<Wrench>& given) {
  joint_account_.rods = impulses_.rods / h_;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    parts_[k].joint = over(impulses_.joint[k + 1], h_);
    const Wrench lack = unbalanced(k + 1, given[k + 1]);
    parts_[k].unbalanced_force = lack.force.norm();
    parts_[k].unbalanced_torque = lack.torque.norm();
  }
  if (!motion_) return;
  read_carriage(over(impulses_.carriage_about_point, h_));
  const Wrench lack = unbalanced(0, given.front());
  loads_.disagreement = {-lack.force, -lack.torque};
}

void JointedVessel::save_motion(StateWriter& out) const {
  out.add("coordinates", tree_.coordinates());
  out.add("speeds", tree_.speeds());
  out.add("carriage_p", now_.p);
  out.add("carriage_yaw", now_.yaw);
  out.add("carriage_v", now_.v);
  out.add("carriage_yaw_rate", now_.yaw_rate);
  for (std::size_t b = 0; b < size(); ++b) out.add("after_impulses_" + std::to_string(b), after_[b]);
}

void JointedVessel::restore_motion(const StateReader& in) {
  VecX q = tree_.coordinates(), u = tree_.speeds();
  in.get("coordinates", q);
  in.get("speeds", u);
  in.get("carriage_p", now_.p);
  in.get("carriage_yaw", now_.yaw);
  in.get("carriage_v", now_.v);
  in.get("carriage_yaw_rate", now_.yaw_rate);
  for (std::size_t b = 0; b < size(); ++b) in.get("after_impulses_" + std::to_string(b), after_[b]);
  tree_.set_coordinates(q);
  tree_.set_speeds(u);
  tree_.set_carriage(now_);
  read_states();
}

std::unique_ptr<VesselMotion> make_jointed_vessel(const VesselModel& model, double t0) {
  return std::make_unique<JointedVessel>(model, t0);
}

}  // namespace nilas::vessel
