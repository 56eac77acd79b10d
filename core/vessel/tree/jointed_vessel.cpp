/// The vessel of several bodies: its step. docs/theory/vessel.md
#include <numeric>
#include <optional>

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "core/vessel/tree/carriage_changes.h"
#include "core/vessel/tree/carried_vessel.h"
#include "core/vessel/tree/held_speeds.h"
#include "core/vessel/tree/jointed_drift.h"
#include "core/vessel/tree/jointed_rest.h"
#include "core/vessel/tree/jointed_tree.h"
#include "core/vessel/tree/rods.h"
#include "core/vessel/tree/vessel_motion.h"

namespace nilas {

namespace {

/// Impulses of joints and rods in one step, in G [N s, N m s].
struct JointImpulses {
  std::vector<Wrench> joint;    ///< per body, hull first: impulse on it, about its joint point
  std::vector<Wrench> net;      ///< per body: sum over all joints, rods and the carriage, about its centre of mass
  Wrench carriage_about_point;  ///< impulse on the hull, about the point of the carriage
  VecX rods;                    ///< impulses of the rods' tensions
  JointImpulses(std::size_t bodies, int num_rods) : joint(bodies), net(bodies), rods(VecX::Zero(num_rods)) {}
};

void add(double share, const std::vector<Wrench>& part, std::vector<Wrench>& sum) {
  for (std::size_t b = 0; b < sum.size(); ++b) sum[b] += {share * part[b].force, share * part[b].torque};
}

Wrench over(const Wrench& impulse, double h) { return {impulse.force / h, impulse.torque / h}; }

/// A vessel of several bodies. A step consists of a velocity step at the pose where the contacts are found, and motions
/// before and after it. In the velocity step, weight, water, contact, springs and dampers act and nothing moves. In the
/// motions only the joints act: they last 0 and h with semi-implicit Euler, (1 - theta) h and theta h with theta. Rods
/// act in both. In a motion the carriage has its mean speeds over it; the changes between these speeds are impulses on
/// the vessel. Speeds that a spring or a cell holds do not take part in these impulses. Along them the velocity step
/// contains the whole acceleration of the carriage, so that it does not shake the springs.
class JointedVessel : public VesselMotion {
 public:
  JointedVessel(const VesselModel& model, double t0);

  Vec6 velocity_after_impulses() const override { return after_.front(); }
  std::vector<Vec6> part_velocities_after_impulses() const override { return {after_.begin() + 1, after_.end()}; }
  void displace(const Vec6&, double) override {}
  double spring_energy() const override;
  VesselRest settle(const RestModel& rest, bool start_there) override;
  bool can_move() const override { return tree_.has_carriage() || tree_.num_speeds() > 0; }
  VecX coordinates() const override;

 protected:
  void move_before_step(double h) override;
  void abandon_motion() override;
  VesselBlock begin_step() override;
  void finish_step(const Wrench& contact) override;
  void save_motion(StateWriter& out) const override;
  void restore_motion(const StateReader& in) override;

 private:
  void read_carriage(const Wrench& about_point);
  std::size_t size() const { return static_cast<std::size_t>(tree_.num_bodies()); }
  void begin_account();
  CarriageMotion::State with_mean_speed(double from, double to) const;
  struct SpeedChange {
    VecX jump;      ///< change of the speeds
    VecX borne;     ///< impulse along the speeds that springs and cells hold, which keeps the change from them
    VecX tensions;  ///< impulses of the rods
  };
  SpeedChange jump_with(const CarriageMotion::State& change) const;
  void change_speeds(const CarriageMotion::State& next, JointAccount::Motion& work);
  void move(double from, double to, JointAccount::Motion& work);
  void add_impulses(const CarriageMotion::State& carriage, double share, const std::vector<Wrench>& joints,
                    double& work);
  void add_rods(double share, const VecX& tensions);
  void demand_rods(double t) const;
  bool has_rods() const { return tree_.num_rods() > 0; }
  CarriageMotion::State mean_acceleration() const;
  CarriageMotion::State change_outside_step() const;
  void read_states();
  Wrench unbalanced(std::size_t b, const Wrench& given) const;
  void read_loads(const std::vector<Wrench>& given);
  std::vector<Wrench> free_loads() const;
  std::vector<Wrench> contact_impulses(const Wrench& on_hull) const;

  VesselModel model_;
  std::optional<CarriageMotion> motion_;
  std::optional<HullCells> cells_;
  JointedTree tree_;
  std::vector<RodModel> rods_;
  std::vector<int> loose_;            ///< speeds that neither a spring nor a cell holds
  double theta_;                      ///< share of the motion that follows the velocity step
  double damper_share_;               ///< weight of the speeds after the step in those that dampers use
  CarriageMotion::State now_, next_;  ///< carriage in the tree, and after the present velocity step
  VecX q_start_, u_start_;            ///< state at the start of the present step
  CarriageMotion::State start_;       ///< carriage at the start of the present step
  VecX u_before_;                     ///< speeds before the present velocity step
  VesselBlock block_;                 ///< block in all speeds, including those that rods hold
  MatX rod_jacobian_;                 ///< value in the present velocity step
  VecX rod_rates_;                    ///< rates that the carriage prescribes in it
  std::vector<Vec6> after_;
  std::vector<Vec6> momenta_;  ///< momenta at the step's start
  JointImpulses impulses_;
};

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
  const JointedRest found = jointed_rest(tree_, model_, rest, now_);
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

void JointedVessel::begin_account() {
  impulses_ = JointImpulses(size(), tree_.num_rods());
  joint_account_ = {};
  q_start_ = tree_.coordinates();
  u_start_ = tree_.speeds();
  start_ = now_;
  momenta_.clear();
  for (int b = 0; b < tree_.num_bodies(); ++b) momenta_.push_back(tree_.momentum(b));
}

/// The carriage at its present place, with its mean speeds between two instants; for equal instants, the speeds there.
CarriageMotion::State JointedVessel::with_mean_speed(double from, double to) const {
  CarriageMotion::State carriage = now_;
  if (!motion_) return carriage;
  const CarriageMotion::State a = motion_->at(from), b = motion_->at(to);
  carriage.v = to > from ? Vec3((b.p - a.p) / (to - from)) : a.v;
  carriage.yaw_rate = to > from ? (b.yaw - a.yaw) / (to - from) : a.yaw_rate;
  return carriage;
}

/// Adds joint impulses at the present pose, and the carriage's work on the hull in them to `work`.
void JointedVessel::add_impulses(const CarriageMotion::State& carriage, double share, const std::vector<Wrench>& joints,
                                 double& work) {
  add(share, joints, impulses_.joint);
  add(share, tree_.net_loads(joints), impulses_.net);
  if (!motion_) return;
  const Wrench& hull = joints.front();
  const Vec3 torque = hull.torque + (tree_.joint_point(0) - carriage.p).cross(hull.force);
  impulses_.carriage_about_point += {share * hull.force, share * torque};
  work += share * (hull.force.dot(carriage.v) + torque.z() * carriage.yaw_rate);
}

/// Adds impulses of tension at the present pose.
void JointedVessel::add_rods(double share, const VecX& tensions) {
  impulses_.rods += share * tensions;
  add(share, tree_.rod_loads(tensions), impulses_.net);
}

void JointedVessel::demand_rods(double t) const {
  if (!has_rods()) return;
  if (const auto failed = failed_rod(tree_, rods_))
    throw SimulationError("at " + std::to_string(t) + " s rod '" + rods_[*failed].name +
                          "' is at a dead point: what it holds can move along it no more");
}

/// Change of the speeds of a tree at rest when the carriage changes its speeds at one instant. Speeds other than the
/// loose ones move only if the rods require it.
JointedVessel::SpeedChange JointedVessel::jump_with(const CarriageMotion::State& change) const {
  VecX impulse = tree_.force(std::vector<Wrench>(size()), change);
  const MatX mass = tree_.mass_matrix(), rods = has_rods() ? tree_.rod_jacobian() : MatX();
  std::vector<int> moving = loose_;
  if (has_rods() && !obey_with(rods, loose_)) {
    moving.resize(static_cast<std::size_t>(impulse.size()));
    std::iota(moving.begin(), moving.end(), 0);
  }
  VecX jump = VecX::Zero(impulse.size()), tensions = VecX::Zero(tree_.num_rods());
  if (!moving.empty()) {
    const MatX of_moving = mass(moving, moving);
    VecX speeds = of_moving.llt().solve(VecX(impulse(moving)));
    if (has_rods()) {
      const HeldByRods held = held_by_rods(of_moving, rods(Eigen::all, moving), tree_.rod_rates(change), speeds);
      speeds = held.speeds;
      tensions = held.tensions;
      impulse -= rods.transpose() * tensions;
    }
    for (std::size_t i = 0; i < moving.size(); ++i) jump[moving[i]] = speeds[static_cast<Eigen::Index>(i)];
  }
  VecX borne = impulse - mass * jump;
  for (const int i : moving) borne[i] = 0;
  return {jump, borne, tensions};
}

/// Gives the carriage the speeds of `next` at one instant; the impulse acts on the vessel.
void JointedVessel::change_speeds(const CarriageMotion::State& next, JointAccount::Motion& work) {
  const CarriageMotion::State change = change_between(now_, next);
  if (change.v.isZero(0) && change.yaw_rate == 0) return;
  const VecX u = tree_.speeds();
  tree_.set_carriage(stopped(now_));
  tree_.set_speeds(VecX::Zero(u.size()));
  const auto [jump, borne, tensions] = jump_with(change);
  std::vector<Wrench> given(size());
  if (has_rods()) {
    given = tree_.rod_loads(tensions);
    add_rods(1, tensions);
  }
  add_impulses(between(now_, next), 1, tree_.joint_loads(jump, change, given), work.carriage);
  work.springs -= borne.dot(u);
  now_ = next;
  tree_.set_carriage(now_);
  tree_.set_speeds(u + jump);
}

/// Moves the vessel between two instants, with the carriage's mean speeds.
void JointedVessel::move(double from, double to, JointAccount::Motion& work) {
  if (!(to > from)) return;
  change_speeds(with_mean_speed(from, to), work);
  const VecX put_right =
      drift(tree_, now_, to - from,
            [&](const CarriageMotion::State& carriage, double time, const VecX& accelerations, const VecX& tensions) {
              std::vector<Wrench> given(size());
              if (has_rods()) {
                given = tree_.rod_loads(tensions);
                add_rods(time, tensions);
              }
              add_impulses(carriage, time, tree_.joint_loads(accelerations, {}, given), work.carriage);
            });
  if (has_rods()) add_rods(1, put_right);
  if (!motion_) return;
  const CarriageMotion::State end = motion_->at(to);
  now_.p = end.p;
  now_.yaw = end.yaw;
  tree_.set_carriage(now_);
}

void JointedVessel::move_before_step(double h) {
  begin_account();
  move(time_, time_ + (1 - theta_) * h, joint_account_.before);
  read_states();
}

void JointedVessel::abandon_motion() {
  now_ = start_;
  tree_.set_carriage(now_);
  tree_.set_coordinates(q_start_);
  tree_.set_speeds(u_start_);
  read_states();
}

std::vector<Wrench> JointedVessel::free_loads() const {
  std::vector<Wrench> loads{free_};
  loads.insert(loads.end(), free_on_parts_.begin(), free_on_parts_.end());
  return loads;
}

std::vector<Wrench> JointedVessel::contact_impulses(const Wrench& on_hull) const {
  std::vector<Wrench> impulses{on_hull};
  impulses.insert(impulses.end(), contact_on_parts_.begin(), contact_on_parts_.end());
  return impulses;
}

/// Acceleration of the carriage in the velocity step.
CarriageMotion::State JointedVessel::mean_acceleration() const {
  CarriageMotion::State acceleration = change_between(now_, next_);
  acceleration.v /= h_;
  acceleration.yaw_rate /= h_;
  return acceleration;
}

/// Change of the carriage's speeds over the present step outside of the velocity step, which takes them from now_ to
/// next_.
CarriageMotion::State JointedVessel::change_outside_step() const {
  CarriageMotion::State change = change_between(start_, motion_->at(time_ + h_));
  const CarriageMotion::State inside = change_between(now_, next_);
  change.v -= inside.v;
  change.yaw_rate -= inside.yaw_rate;
  return change;
}

/// Springs act at the mean of three poses: the present one and those before and after it. Dampers act at the speeds
/// after the step or at the mean of both. Therefore no stiffness or damping requires a shorter step. Cells take the
/// exact step of stiff_block.h, in which the parts' speeds are free.
VesselBlock JointedVessel::begin_step() {
  const double start = time_ + (1 - theta_) * h_;
  if (start == time_) begin_account();
  next_ = with_mean_speed(start, time_ + h_);
  const CarriageMotion::State acceleration = mean_acceleration();
  u_before_ = tree_.speeds();
  const VecX of_cells = tree_.cell_force();
  // The force is taken at rest, without Coriolis terms: those act while the vessel moves.
  const VecX still = VecX::Zero(u_before_.size());
  tree_.set_speeds(still);
  tree_.set_carriage(stopped(now_));
  VecX force = tree_.force(free_loads(), acceleration);
  if (motion_) force += jump_with(change_outside_step()).borne / h_;
  MatX mass = tree_.mass_matrix(), momentum = mass;
  if (cells_) {
    const StiffBlock step = stiff_block(mass, cells_->stiffness, cells_->damping_time, cells_->free, h_);
    mass = step.mass;
    momentum = step.mass * step.kept;
  }
  const VecX spring = 0.25 * h_ * h_ * tree_.stiffness(), damper = h_ * tree_.damping();
  block_ = {};
  block_.mass = mass;
  block_.mass.diagonal() += spring + damper_share_ * damper;
  block_.f = momentum * u_before_ + (spring - (1 - damper_share_) * damper).cwiseProduct(u_before_) +
             h_ * (force + of_cells - tree_.stiffness().cwiseProduct(tree_.stretch()));
  tree_.set_carriage(next_);
  block_.hull = {tree_.jacobian(0), tree_.twist(0)};
  for (int b = 1; b < tree_.num_bodies(); ++b) block_.parts.push_back({tree_.jacobian(b), tree_.twist(b)});
  if (!has_rods()) return block_;
  demand_rods(start);
  rod_jacobian_ = tree_.rod_jacobian();
  rod_rates_ = tree_.rod_rates();
  return block_on_rods(block_, rod_jacobian_, rod_rates_);
}

void JointedVessel::finish_step(const Wrench& contact) {
  const std::vector<Wrench> impulses = contact_impulses(contact);
  std::vector<Wrench> given = free_loads();
  add(1 / h_, impulses, given);

  // The velocity step.
  VecX momentum = block_.f;
  for (std::size_t b = 0; b < size(); ++b) {
    Vec6 r;
    r << impulses[b].force, impulses[b].torque;
    momentum += (b == 0 ? block_.hull : block_.parts[b - 1]).jacobian.transpose() * r;
  }
  VecX u(momentum.size());
  if (momentum.size() > 0) u = block_.mass.llt().solve(momentum);
  std::vector<Wrench> of_rods;  ///< means over the step
  if (has_rods()) {
    const HeldByRods held = held_by_rods(block_.mass, rod_jacobian_, rod_rates_, u);
    u = held.speeds;
    impulses_.rods += held.tensions;
    of_rods = tree_.rod_loads(held.tensions / h_);
    add(1, of_rods, given);
  }
  if (!u.allFinite())
    throw SimulationError("at " + std::to_string(time_ + h_) +
                          " s the speeds of the vessel's joints left finite numbers");
  const CarriageMotion::State acceleration = mean_acceleration();
  tree_.set_carriage(stopped(now_));
  tree_.set_speeds(VecX::Zero(u.size()));
  const std::vector<Wrench> joints = tree_.joint_loads((u - u_before_) / h_, acceleration, given);
  joint_account_.held = tree_.net_loads(joints);
  if (has_rods()) add(1, of_rods, joint_account_.held);
  add_impulses(between(now_, next_), h_, joints, joint_account_.carriage_work);
  const VecX mean = 0.5 * (u + u_before_);
  const VecX spring_impulse = tree_.mass_matrix() * (u - u_before_) - h_ * tree_.force(given, acceleration);
  joint_account_.spring_work = spring_impulse.dot(mean);
  now_ = next_;
  tree_.set_carriage(now_);
  tree_.set_speeds(u);
  for (int b = 0; b < tree_.num_bodies(); ++b) after_[b] = tree_.twist(b);

  // The motion after it.
  const double start = time_ + (1 - theta_) * h_, end = time_ + h_;
  move(start, end, joint_account_.after);
  change_speeds(with_mean_speed(end, end), joint_account_.after);
  demand_rods(end);
  read_states();
  read_loads(given);
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

}  // namespace

std::unique_ptr<VesselMotion> make_jointed_vessel(const VesselModel& model, double t0) {
  return std::make_unique<JointedVessel>(model, t0);
}

}  // namespace nilas
