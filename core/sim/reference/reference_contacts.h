#pragma once
/// Contacts that stay closed while the reference integrator follows a smooth motion: their forces, and when they end.
#include <memory>
#include <vector>

#include "contact/assemble.h"
#include "contact/detect/detector.h"
#include "contact/law/friction.h"
#include "contact/solvers/solver.h"
#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/sim/reference/reference_vessel.h"

namespace nilas {

/// Points farther apart are not looked for [m].
constexpr double k_reference_margin = 1e-5;

/// Closed at one instant, all bodies together.
constexpr int k_most_reference_contacts = 16;

enum class Grip { sticks, slips };

struct SustainedContact {
  std::uint64_t key = 0;
  int a = -1, b = -1;
  ContactPoint point;  ///< where it was when this state began
  double mu_static = 0, mu_kinetic = 0;
  Grip grip = Grip::slips;
  Vec3 slip_axis = Vec3::UnitX();  ///< direction of slip when this state began, unit
  Vec3 force = Vec3::Zero();       ///< (N, T1, T2) when this state began: which of many distributions is meant [N]
};

/// Where one contact is, how its points move past each other, and what their acceleration is without any of the
/// bodies'.
struct ContactKinematics {
  bool found = false;
  ContactPoint point;
  Mat3 frame = Mat3::Identity();  ///< columns n, t1, t2
  Vec3 velocity = Vec3::Zero();   ///< of B's point relative to A's, in G [m/s]
  Vec3 bias = Vec3::Zero();       ///< rate of (u_N, u_T) at zero acceleration, along `frame` [m/s^2]
};

/// The forces of the sustained contacts at one instant.
struct SustainedForces {
  std::vector<ContactKinematics> at;
  std::vector<Vec3> force;    ///< (N, T1, T2) along the frame, on body B [N]
  double friction_power = 0;  ///< taken [W]
};

/// Impulses at points, on body B, in G [N s].
struct ContactImpulses {
  std::vector<ContactPoint> points;
  std::vector<Vec3> impulses;
};

/// The contact problem of the accelerations.
struct AccelerationProblem {
  AssembledContacts contacts;
  std::vector<Vec3> slip;  ///< direction of each contact's slip, zero where it has none
  double scale = 0;        ///< largest relative acceleration without contact forces [m/s^2]
};

class SustainedContacts {
 public:
  /// `solver` decides which contacts bear, stick and slip. `vessel`: null where none moves. `joined`: pairs of bodies
  /// that do not collide.
  SustainedContacts(const FrictionPairs& friction, std::unique_ptr<ContactSolver> solver, bool frictionless,
                    double rest_speed, ReferenceVessel* vessel, PairFilter joined);

  const std::vector<SustainedContact>& list() const { return list_; }
  /// All points closer than a hundredth of a millimetre.
  std::vector<ContactPoint> detect(const Bodies& bodies) {
    return detector_.detect(bodies, k_reference_margin, joined_);
  }

  /// Which of the points, closed and at rest along their normals, bear, and whether they slip: solves the contact
  /// problem of the accelerations, M a = f + H r with u the relative acceleration. `loads` without contact. Throws
  /// SimulationError when there is no answer.
  void decide(Bodies& bodies, const Wrenches& loads, const std::vector<ContactPoint>& points, double t);

  /// Takes from the bodies what speed the contacts just decided have left along their normals, or at all where they
  /// stick.
  ContactImpulses stop_creep(Bodies& bodies) const;

  /// Forces for the states decided: normal accelerations vanish, tangential ones where a contact sticks; sliding
  /// friction opposes the slip. They go on smoothly where the law would end a state.
  SustainedForces forces(Bodies& bodies, const Wrenches& loads);
  /// Two per contact, positive while its state lasts: the normal force; the slip along slip_axis, or what static
  /// friction has in reserve.
  void watch(const SustainedForces& forces, Eigen::Ref<VecX> out) const;
  /// Adds the contact forces to the wrenches of their bodies.
  void add(const SustainedForces& forces, const Bodies& bodies, Wrenches& loads) const;
  /// Forces are no longer watched: they are not unique, and the law has confirmed the states time and again.
  void trust_states() { trusted_ = true; }
  bool trusted() const { return trusted_; }

 private:
  std::vector<ContactKinematics> kinematics(Bodies& bodies, const std::vector<std::uint64_t>& keys);
  AccelerationProblem pose(Bodies& bodies, const Wrenches& loads, const std::vector<ContactPoint>& points);
  std::vector<std::uint64_t> keys() const;
  Vec3 vessel_bias(const Bodies& bodies, const ContactPoint& c, const Mat3& C) const;
  FrictionPair friction_of(const Bodies& bodies, const ContactPoint& point) const;

  const FrictionPairs& friction_;
  std::unique_ptr<ContactSolver> solver_;
  bool frictionless_;
  double rest_speed_;  ///< slower slip is none [m/s]
  ReferenceVessel* vessel_;
  PairFilter joined_;
  ContactDetector detector_;
  std::vector<SustainedContact> list_;
  bool trusted_ = false;
};

}  // namespace nilas
