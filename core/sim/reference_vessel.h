#pragma once
/// The vessel as the reference integrator moves it: hull and parts as one tree, free or on a fixed hull.
#include <utility>
#include <vector>

#include "contact/assemble.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/vessel/jointed_tree.h"

namespace nilas {

class ReferenceVessel {
 public:
  /// `hull`: its place among the bodies; the parts follow it.
  ReferenceVessel(const VesselModel& model, int hull);

  bool holds(int body) const { return body >= hull_ && body < hull_ + tree_.num_bodies(); }
  int hull() const { return hull_; }
  bool is_free() const { return tree_.hull_is_free(); }

  int size() const;  ///< of its state: coordinates, then speeds
  VecX state() const;
  /// Moves the tree and the bodies there.
  void set_state(const VecX& y, Bodies& bodies);
  /// Rate of the state with these accelerations of the speeds.
  VecX state_rate(const VecX& accelerations) const;

  /// Of the speeds, springs and dampers included. `loads`: one per body of the scene.
  VecX accelerations(const Wrenches& loads) const;
  /// Rate of the twist (v; w) of a body's centre of mass in G with these accelerations of the speeds.
  Vec6 twist_rate(int body, const VecX& accelerations) const;
  /// The part of it that is there without accelerations.
  Vec6 bias(int body) const;
  /// Generalised force of a wrench (force; torque) about a body's centre of mass.
  VecX generalised(int body, const Vec6& load) const;
  /// Change of the speeds by a generalised impulse.
  VecX response(const VecX& impulse) const;
  /// Changes the speeds, of the bodies too.
  void add_to_speeds(const VecX& change, Bodies& bodies);
  /// The contact problem's block with these speeds in place of those without contact.
  ArticulatedBlock block(const VecX& speeds) const;
  VecX speeds() const { return tree_.speeds(); }
  void set_speeds(const VecX& u, Bodies& bodies);

  double joint_power() const;  ///< of springs and dampers on the vessel [W]
  /// The parts now, with their joint loads under `loads` at this instant.
  std::vector<PartState> parts(const Wrenches& loads);

 private:
  std::vector<Wrench> of_vessel(const Wrenches& loads) const;
  VecX joint_forces() const;
  void copy_to(Bodies& bodies) const;

  JointedTree tree_;
  int hull_;
};

}  // namespace nilas
