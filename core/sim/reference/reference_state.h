#pragma once
/// The moving bodies of a scene and their accounts of energy and momentum, as the state vector of a differential
/// equation.
#include <optional>
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/sim/reference/reference_vessel.h"

namespace nilas::sim {

/// Loads on the vessel at one instant, or their impulses, frame G: hull and parts together, torques about the hull's
/// centre of mass.
struct ReferenceVesselLoads {
  Wrench contact, hydro;
  std::vector<Wrench> modules;  ///< one per entry of RunInfo::vessel_loads
  Vec3 ice = Vec3::Zero();      ///< the contact force that floes exert
  /// Contact load on each part about its centre of mass, contacts within the vessel included.
  std::vector<Wrench> on_parts;
  std::optional<vessel::CarriageLoads> carriage;  ///< only for a towed vessel

  ReferenceVesselLoads(int num_parts, std::size_t num_modules, bool towed);
  Eigen::Index size() const;
  VecX numbers() const;
  void add(const VecX& numbers);
};

/// All loads on the bodies at one instant.
struct ReferenceLoads {
  bodies::Wrenches total;      ///< load per body, contact included
  std::vector<double> powers;  ///< power of each module that does work [W]
  double friction_power = 0;   ///< power lost to friction, >= 0 [W]
  double force_sum = 0;        ///< sum of the absolute forces of all sources, a scale [N]
  double moment_sum = 0;       ///< sum of the absolute moments about G's origin, a scale [N m]
  ReferenceVesselLoads vessel;
  ReferenceLoads(std::size_t bodies, std::size_t works, ReferenceVesselLoads none)
      : total(bodies), powers(works, 0), vessel(std::move(none)) {}
};

/// Works and impulses over a stretch of time.
struct ReferenceAccount {
  std::vector<double> works;            ///< [J]
  double friction = 0, impact = 0;      ///< energy lost [J]
  Vec3 impulse = Vec3::Zero();          ///< impulse of all loads on the bodies of momenta() [N s]
  Vec3 angular_impulse = Vec3::Zero();  ///< angular impulse about G's origin [N m s]
  double impulse_scale = 0, angular_scale = 0;
  ReferenceVesselLoads vessel{0, 0, false};
};

/// Packs and unpacks the state y. Per free body y holds p, q (w x y z), v of the centre of mass and L = I w, all in G.
/// The vessel's state and the account follow.
class ReferenceState {
 public:
  /// `vessel`: null where none moves. `sums`: loads on the scene's vessel, null without one.
  ReferenceState(const bodies::Bodies& bodies, std::size_t works, ReferenceVessel* vessel,
                 const ReferenceVesselLoads* sums);

  /// The present state of the bodies, with an empty account.
  VecX pack(const bodies::Bodies& bodies) const;
  /// Sets the bodies to the state y at the instant t [s].
  void unpack(double t, const VecX& y, bodies::Bodies& bodies) const;
  /// Adds the account in y.
  void add_account(const VecX& y, ReferenceAccount& account) const;
  /// The derivative of y under `loads`. `bodies` must be as unpacked from y.
  void derivative(const bodies::Bodies& bodies, const VecX& y, const ReferenceLoads& loads, VecX& dy) const;
  /// Absolute tolerances for the relative one, for poses and velocities of order one in metres and seconds.
  VecX absolute_tolerances(const bodies::Bodies& bodies, double relative) const;

 private:
  Eigen::Index size() const;

  std::vector<int> free_;
  ReferenceVessel* vessel_;
  Eigen::Index vessel_sums_ = 0;  ///< number of the loads on the vessel
  Eigen::Index at_vessel_ = 0, works_ = 0,
               account_ = 0;  ///< offset of the vessel; number of works; offset of the works
};

/// Momenta of several bodies: their sums, and the sums of their sizes, which their rounding grows with.
struct Momenta {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  ///< [kg m/s]; about G's origin [kg m^2/s]
  double linear_size = 0, angular_size = 0;            ///< [kg m/s, kg m^2/s]
};

/// The momenta of the free bodies, including the vessel if `with_vessel`.
Momenta momenta(const bodies::Bodies& bodies, bool with_vessel);

}  // namespace nilas::sim
