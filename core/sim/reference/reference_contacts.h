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
#include "core/sim/account/step_record.h"
#include "core/sim/reference/reference_kinematics.h"
#include "core/sim/reference/reference_vessel.h"

namespace nilas::sim {

/// Gap above which contact points are ignored [m].
constexpr double k_reference_margin = 1e-5;

/// Points within this distance are closed, and belong to one impact [m].
constexpr double k_reference_touch = 2e-9;

/// Largest number of contacts closed at one instant, over all bodies.
constexpr int k_most_reference_contacts = 16;

enum class Grip { sticks, slips };

struct SustainedContact {
  std::uint64_t key = 0;
  int a = -1, b = -1;
  detect::ContactPoint point;  ///< the contact point when this state began
  double mu_static = 0, mu_kinetic = 0;
  Grip grip = Grip::slips;
  Vec3 slip_axis = Vec3::UnitX();  ///< direction of slip when this state began, unit
  Vec3 force = Vec3::Zero();       ///< (N, T1, T2) when this state began, to select one of many distributions [N]
};

/// The forces of the sustained contacts at one instant.
struct SustainedForces {
  std::vector<ContactKinematics> at;
  std::vector<Vec3> force;    ///< (N, T1, T2) along the frame, on body B [N]
  double friction_power = 0;  ///< power lost to friction [W]
};

/// Impulses at contact points, on body B, frame G [N s].
struct ContactImpulses {
  std::vector<detect::ContactPoint> points;
  std::vector<Vec3> impulses;
};

/// The contact problem of the accelerations.
struct AccelerationProblem {
  contact::AssembledContacts contacts;
  std::vector<Vec3> slip;  ///< direction of slip per contact, zero where it has none
  double scale = 0;        ///< largest relative acceleration without contact forces [m/s^2]
};

/// Adds the events that make the difference between two lists of sustained contacts at the instant t [s].
void note_changes(double t, const std::vector<SustainedContact>& before, const std::vector<SustainedContact>& after,
                  std::vector<ContactEvent>& events);

class SustainedContacts {
 public:
  /// `solver` decides which contacts carry load, stick and slip. `vessel`: null where none moves. `joined`: pairs of
  /// bodies that do not collide.
  SustainedContacts(const contact::FrictionPairs& friction, std::unique_ptr<solvers::ContactSolver> solver,
                    bool frictionless, double rest_speed, ReferenceVessel* vessel, detect::PairFilter joined);

  const std::vector<SustainedContact>& list() const { return list_; }
  /// All contact points with a gap below k_reference_margin.
  std::vector<detect::ContactPoint> detect(const bodies::Bodies& bodies) {
    return detector_.detect(bodies, k_reference_margin, joined_);
  }

  /// Decides which of the points carry load, and whether they slip. The points are closed and at rest along their
  /// normals. Solves the contact problem of the accelerations, M a = f + H r with u the relative acceleration. `loads`:
  /// without contact. Throws SimulationError when there is no solution.
  void decide(bodies::Bodies& bodies, const bodies::Wrenches& loads, const std::vector<detect::ContactPoint>& points,
              double t);

  /// Removes the remaining speed of the contacts just decided: along the normals, and the whole of it where they stick.
  /// Returns the impulses for this.
  ContactImpulses stop_creep(bodies::Bodies& bodies) const;

  /// Forces for the decided states: normal accelerations vanish, and tangential ones where a contact sticks; sliding
  /// friction opposes the slip. The forces continue smoothly where the law would end a state.
  SustainedForces forces(bodies::Bodies& bodies, const bodies::Wrenches& loads);
  /// Writes two event functions per contact, positive while its state lasts: the normal force, or how far the normal
  /// speed is below that of a point that has jumped; and the slip along slip_axis or the reserve of static friction.
  void watch(const SustainedForces& forces, Eigen::Ref<VecX> out) const;
  /// Adds the contact forces to the wrenches of their bodies.
  void add(const SustainedForces& forces, const bodies::Bodies& bodies, bodies::Wrenches& loads) const;
  /// Stops watching the forces, for states that are not unique and that the law has confirmed repeatedly.
  void trust_states() { trusted_ = true; }
  bool trusted() const { return trusted_; }

 private:
  std::vector<ContactKinematics> kinematics(bodies::Bodies& bodies, const std::vector<detect::ContactPoint>& began);
  AccelerationProblem pose(bodies::Bodies& bodies, const bodies::Wrenches& loads,
                           const std::vector<detect::ContactPoint>& points);
  double most_normal_speed(const ContactKinematics& at) const;
  Vec3 vessel_bias(const bodies::Bodies& bodies, const detect::ContactPoint& c, const Mat3& C) const;
  contact::FrictionPair friction_of(const bodies::Bodies& bodies, const detect::ContactPoint& point) const;

  const contact::FrictionPairs& friction_;
  std::unique_ptr<solvers::ContactSolver> solver_;
  bool frictionless_;
  double rest_speed_;  ///< slip below this speed counts as none [m/s]
  ReferenceVessel* vessel_;
  detect::PairFilter joined_;
  detect::ContactDetector detector_;
  std::vector<SustainedContact> list_;
  bool trusted_ = false;
};

}  // namespace nilas::sim
