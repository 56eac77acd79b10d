#pragma once
/// The vessel as the reference integrator moves it: hull and parts as one tree, free, towed, or on a fixed hull.
#include <optional>
#include <utility>
#include <vector>

#include "contact/assemble.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/sim/reference/reference_carriage.h"
#include "core/vessel/tree/jointed_tree.h"

namespace nilas {

class ReferenceVessel {
 public:
  /// `hull`: its place among the bodies; the parts follow it. `start`: of a towed vessel its coordinates and speeds at
  /// t0 [s].
  ReferenceVessel(const VesselModel& model, int hull, double t0, const VecX& start);

  bool holds(int body) const { return body >= hull_ && body < hull_ + tree_.num_bodies(); }
  int hull() const { return hull_; }
  bool is_free() const { return tree_.hull_is_free(); }
  bool is_towed() const { return carriage_.has_value(); }
  /// Whether all loads on hull and parts are known, the carriage's included, and its momenta so have an account.
  bool has_known_loads() const { return is_free() || is_towed(); }

  /// Of a towed vessel: the carriage at the instant t [s] of its stretch. Bodies follow with the next set_state().
  void go_to(double t);
  /// When the carriage's motion has its next kink; infinite without a carriage [s].
  double stretch_end() const;
  /// Goes on with the stretch after that kink. Where the carriage's speed jumps there, the vessel bears it.
  void enter_next_stretch(Bodies& bodies);
  /// Of a towed vessel: what the carriage does to it at this instant.
  CarriageLoads carriage_loads(const Wrenches& loads);
  /// What an impulse of the carriage on the vessel about the hull's centre of mass is at the joint and in the cells.
  CarriageLoads carriage_impulse(const Wrench& about_com) const { return carriage_->loads(about_com, tree_.pose(0).p); }
  /// Throws SimulationError, naming the instant t [s], where the joint has left its range.
  void demand_regular(double t) const;

  int size() const;  ///< of its state: coordinates, then speeds
  VecX state() const;
  /// Moves the tree and the bodies there.
  void set_state(const VecX& y, Bodies& bodies);
  /// Rate of the state with these accelerations of the speeds.
  VecX state_rate(const VecX& accelerations) const;

  /// Of the speeds, springs, dampers and load cells included. `loads`: one per body of the scene.
  VecX accelerations(const Wrenches& loads) const;
  /// Rate of the twist (v; w) of a body's centre of mass in G with these accelerations of the speeds.
  Vec6 twist_rate(int body, const VecX& accelerations) const;
  /// The part of it that is there without accelerations of the speeds, the carriage's included.
  Vec6 bias(int body) const;
  /// Generalised force of a wrench (force; torque) about a body's centre of mass.
  VecX generalised(int body, const Vec6& load) const;
  /// Change of the speeds by a generalised impulse.
  VecX response(const VecX& impulse) const;
  /// Changes the speeds, of the bodies too.
  void add_to_speeds(const VecX& change, Bodies& bodies);
  /// The contact problem's block with these speeds in place of those without contact, of what the carriage prescribes
  /// nothing.
  ArticulatedBlock block(const VecX& speeds) const;
  /// The block of the speeds that the vessel has, what the carriage prescribes included.
  ArticulatedBlock velocity_block() const;
  VecX speeds() const { return tree_.speeds(); }
  void set_speeds(const VecX& u, Bodies& bodies);

  double joint_power() const;  ///< of springs and dampers on the vessel [W]
  /// The parts now, with their joint loads under `loads` at this instant.
  std::vector<PartState> parts(const Wrenches& loads);

 private:
  std::vector<Wrench> of_vessel(const Wrenches& loads) const;
  CarriageMotion::State carriage_acceleration() const;
  VecX joint_forces() const;
  void copy_to(Bodies& bodies) const;

  JointedTree tree_;
  int hull_;
  std::optional<ReferenceCarriage> carriage_;
  bool has_three_angles_ = false;  ///< of a joint on the carriage; then they are the first three coordinates
};

}  // namespace nilas
