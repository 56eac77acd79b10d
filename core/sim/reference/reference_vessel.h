#pragma once
/// The vessel in the reference integrator: hull and parts as one tree, with a free, towed or fixed hull.
#include <optional>
#include <utility>
#include <vector>

#include "contact/assemble.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/sim/reference/reference_carriage.h"
#include "core/vessel/tree/jointed_tree.h"

namespace nilas::sim {

class ReferenceVessel {
 public:
  /// `hull`: index of the hull among the bodies; its parts follow it. `start`: coordinates and speeds of a towed vessel
  /// at t0 [s].
  ReferenceVessel(const vessel::VesselModel& model, int hull, double t0, const VecX& start);

  bool holds(int body) const { return body >= hull_ && body < hull_ + tree_.num_bodies(); }
  int hull() const { return hull_; }
  bool is_free() const { return tree_.hull_is_free(); }
  bool is_towed() const { return carriage_.has_value(); }
  /// Whether all loads on hull and parts are known, including the carriage's, so that its momenta can be balanced.
  bool has_known_loads() const { return is_free() || is_towed(); }

  /// Moves the carriage of a towed vessel to the instant t [s] of its stretch. The bodies follow at the next
  /// set_state().
  void go_to(double t);
  /// Time of the next kink in the carriage's motion; infinite without a carriage [s].
  double stretch_end() const;
  /// Enters the stretch after that kink. Where the carriage's speed jumps there, the vessel takes up the jump.
  void enter_next_stretch(bodies::Bodies& bodies);
  /// The carriage's loads on a towed vessel at this instant.
  vessel::CarriageLoads carriage_loads(const bodies::Wrenches& loads);
  /// Converts an impulse of the carriage on the vessel, about the hull's centre of mass, to the joint and the cells.
  vessel::CarriageLoads carriage_impulse(const Wrench& about_com) const {
    return carriage_->loads(about_com, tree_.pose(0).p);
  }
  /// Throws SimulationError, naming the instant t [s], where the joint has left its range.
  void demand_regular(double t) const;

  int size() const;  ///< size of the state: coordinates, then speeds
  VecX state() const;
  /// Moves the tree and the bodies to the state y.
  void set_state(const VecX& y, bodies::Bodies& bodies);
  /// Rate of the state for these accelerations of the speeds.
  VecX state_rate(const VecX& accelerations) const;

  /// Accelerations of the speeds, including springs, dampers and load cells. `loads`: one per body of the scene.
  VecX accelerations(const bodies::Wrenches& loads) const;
  /// Rate of the twist (v; w) of a body's centre of mass in G for these accelerations of the speeds.
  Vec6 twist_rate(int body, const VecX& accelerations) const;
  /// The part of twist_rate() that is independent of the accelerations of the speeds, the carriage's part included.
  Vec6 bias(int body) const;
  /// Generalised force of a wrench (force; torque) about a body's centre of mass, frame G.
  VecX generalised(int body, const Vec6& load) const;
  /// Change of the speeds through a generalised impulse.
  VecX response(const VecX& impulse) const;
  /// Adds `change` to the speeds, and updates the bodies' velocities.
  void add_to_speeds(const VecX& change, bodies::Bodies& bodies);
  /// The vessel's block of the contact problem with these speeds as those without contact. Speeds that the carriage
  /// prescribes count as zero.
  contact::ArticulatedBlock block(const VecX& speeds) const;
  /// The block for the present speeds, including those that the carriage prescribes.
  contact::ArticulatedBlock velocity_block() const;
  VecX speeds() const { return tree_.speeds(); }
  void set_speeds(const VecX& u, bodies::Bodies& bodies);

  double joint_power() const;  ///< power of springs and dampers on the vessel [W]
  /// The present state of the parts, with their joint loads under `loads`.
  std::vector<vessel::PartState> parts(const bodies::Wrenches& loads);

 private:
  std::vector<Wrench> of_vessel(const bodies::Wrenches& loads) const;
  vessel::CarriageMotion::State carriage_acceleration() const;
  VecX joint_forces() const;
  void copy_to(bodies::Bodies& bodies) const;

  vessel::JointedTree tree_;
  int hull_;
  std::optional<ReferenceCarriage> carriage_;
  bool has_three_angles_ = false;  ///< the carriage's joint has three angles, the first three coordinates
};

}  // namespace nilas::sim
