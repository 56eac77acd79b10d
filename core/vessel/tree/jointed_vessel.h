#pragma once
/// The vessel of several bodies. docs/theory/vessel.md
#include <optional>
#include <vector>

#include "core/vessel/tree/held_speeds.h"
#include "core/vessel/tree/jointed_tree.h"
#include "core/vessel/tree/vessel_motion.h"

namespace nilas::vessel {

/// Impulses of joints and rods in one step, in G [N s, N m s].
struct JointImpulses {
  std::vector<Wrench> joint;    ///< per body, hull first: impulse on it, about its joint point
  std::vector<Wrench> net;      ///< per body: sum over all joints, rods and the carriage, about its centre of mass
  Wrench carriage_about_point;  ///< impulse on the hull, about the point of the carriage
  VecX rods;                    ///< impulses of the rods' tensions
  JointImpulses(std::size_t bodies, int num_rods) : joint(bodies), net(bodies), rods(VecX::Zero(num_rods)) {}
};

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

}  // namespace nilas::vessel
