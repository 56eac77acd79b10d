#include <limits>

#include "core/base/error.h"
#include "core/vessel/tree/carried_vessel.h"

namespace nilas::vessel {

namespace {

/// The vessel on a carriage in the theta scheme: (1 - theta) h before the impulses, theta h after them. The carriage
/// follows its own motion at every instant.
class MoreauCarriedVessel : public CarriedVessel {
 public:
  MoreauCarriedVessel(const VesselModel& model, double t0) : CarriedVessel(model, t0), theta_(*model.theta) {}

 protected:
  void move_before_step(double h) override;
  void abandon_motion() override;
  VesselBlock begin_step() override;
  void finish_step(const Wrench& contact) override;

 private:
  VecX speeds_under(const VecX& force) const;
  Vec6 momentum_at_end(const VecX& q_middle);
  void keep_free_momentum(const VecX& q_middle, const Vec6& given_momentum);
  void place_halfway(const VecX& q_end);

  double theta_;
  StepEnd start_;
  Vec6 momentum_start_ = Vec6::Zero();
  CarriageMotion::State end_;  ///< carriage at the end of the present step
  VecX of_cells_;              ///< force of the cells before the impulses
  MatX free_mass_;             ///< mass matrix of the free coordinates at the middle pose
};

void MoreauCarriedVessel::move_before_step(double h) {
  start_ = {q_, u_, now_};
  momentum_start_ = momentum();
  q_ += (1 - theta_) * h * u_;
  const double t = time_ + (1 - theta_) * h;
  demand_regular(t);
  now_ = motion_.at(t);
  place(now_, u_);
}

void MoreauCarriedVessel::abandon_motion() {
  q_ = start_.q;
  now_ = start_.carriage;
  place(now_, u_);
}

VecX MoreauCarriedVessel::speeds_under(const VecX& force) const {
  return step_.kept * u_ + h_ * (step_.response * (force + of_cells_));
}

VesselBlock MoreauCarriedVessel::begin_step() {
  end_ = motion_.at(time_ + h_);
  // The mean acceleration over the step keeps the momenta exact at kinks of the motion.
  CarriageMotion::State acceleration;
  acceleration.v = (end_.v - start_.carriage.v) / h_;
  acceleration.yaw_rate = (end_.yaw_rate - start_.carriage.yaw_rate) / h_;
  jacobian_ = tree_.jacobian();
  const MatX mass = tree_.mass_matrix();
  free_mass_ = mass(free_coordinates_, free_coordinates_);
  step_ = stiff_block(mass, stiffness_, damping_time_, free_coordinates_, h_);
  of_cells_ = tree_.cell_force();
  // Coriolis terms use the mean of the speeds at both ends; the speeds before alone would make them first-order.
  const VecX predicted = speeds_under(tree_.force(free_, acceleration));
  tree_.set_speeds(0.5 * (u_ + predicted));
  u_without_contact_ = speeds_under(tree_.force(free_, acceleration));
  // this motion lasts until the impulses of the next step
  const Vec6 prescribed = mean_carriage_twist(motion_.at(time_ + (1 - theta_) * h_ + h_));
  return {step_.mass, step_.mass * u_without_contact_, {jacobian_, prescribed}, {}};
}

void MoreauCarriedVessel::finish_step(const Wrench& contact) {
  Vec6 impulse;
  impulse << contact.force, contact.torque;
  Vec6 given = impulse;
  given.head<3>() += h_ * free_.force;
  given.tail<3>() += h_ * free_.torque;

  const VecX q_middle = q_;
  u_ = u_without_contact_ + step_.response * (jacobian_.transpose() * impulse);
  keep_free_momentum(q_middle, momentum_start_ + given);

  // The change of the momenta that no other load explains is the carriage's impulse.
  const Vec6 reaction = (momentum_at_end(q_middle) - momentum_start_ - given) / h_;
  place_halfway(q_);
  read_loads(reaction, tree_.pose().p, motion_.at(time_ + 0.5 * h_));
  ask_simbody(start_, {q_, u_, end_}, given / h_);
  now_ = end_;
  place(now_, u_);
}

/// Moves the vessel to the step's end with the speeds u_. Returns its momentum there.
Vec6 MoreauCarriedVessel::momentum_at_end(const VecX& q_middle) {
  q_ = q_middle + theta_ * h_ * u_;
  demand_regular(time_ + h_);
  place(end_, u_);
  return momentum();
}

/// Moves the tree to the middle of the step, where the reaction is read; the state stays at the end.
void MoreauCarriedVessel::place_halfway(const VecX& q_end) {
  tree_.set_coordinates(0.5 * (start_.q + q_end));
  tree_.set_carriage(motion_.at(time_ + 0.5 * h_));
}

/// Chooses the speeds of the free coordinates, and with them the pose at the step's end, so that the reaction halfway
/// through the step has no component along these coordinates. The condition is symmetric in time.
void MoreauCarriedVessel::keep_free_momentum(const VecX& q_middle, const Vec6& given_momentum) {
  if (free_coordinates_.empty()) return;
  const Eigen::LLT<MatX> mass(free_mass_);
  // Each pass reduces the error by a factor of about h times the rate at which the axes turn, until rounding remains.
  constexpr int k_most_passes = 50;
  double last_move = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < k_most_passes; ++pass) {
    const Vec6 lack = given_momentum - momentum_at_end(q_middle);
    place_halfway(q_);
    const VecX along = tree_.jacobian().transpose() * lack;
    const VecX change = mass.solve(VecX(along(free_coordinates_)));
    const double move = change.dot(free_mass_ * change);
    if (!(move < last_move)) break;
    u_(free_coordinates_) += change;
    last_move = move;
  }
}

}  // namespace

std::unique_ptr<VesselMotion> make_moreau_carried_vessel(const VesselModel& model, double t0) {
  return std::make_unique<MoreauCarriedVessel>(model, t0);
}

}  // namespace nilas::vessel
