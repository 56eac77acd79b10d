#pragma once
/// The bodies of a scene that move, and their accounts of energy and momentum, as one vector of a differential
/// equation.
#include <optional>
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/bodies/module.h"
#include "core/sim/reference/reference_vessel.h"

namespace nilas {

/// Loads on the vessel at one instant, or their impulses: hull and parts together, torques about the hull's centre of
/// mass, in G.
struct ReferenceVesselLoads {
  Wrench contact, hydro;
  Vec3 ice = Vec3::Zero();       ///< the part of the contact force that floes exert
  std::vector<Wrench> on_parts;  ///< contact on each part about its centre of mass, that of the vessel's own included
  std::optional<CarriageLoads> carriage;  ///< of a towed vessel

  ReferenceVesselLoads(int num_parts, bool towed);
  Eigen::Index size() const;
  VecX numbers() const;
  void add(const VecX& numbers);
};

/// All that acts on the bodies at one instant.
struct ReferenceLoads {
  Wrenches total;              ///< per body, contact included
  std::vector<double> powers;  ///< of each module that works [W]
  double friction_power = 0;   ///< taken by sliding contacts, >= 0 [W]
  double force_sum = 0;        ///< of the absolute forces of all sources: a scale [N]
  double moment_sum = 0;       ///< the same about G's origin [N m]
  ReferenceVesselLoads vessel;
  ReferenceLoads(std::size_t bodies, std::size_t works, ReferenceVesselLoads none)
      : total(bodies), powers(works, 0), vessel(std::move(none)) {}
};

/// Works and impulses over a stretch of time.
struct ReferenceAccount {
  std::vector<double> works;            ///< [J]
  double friction = 0, impact = 0;      ///< taken [J]
  Vec3 impulse = Vec3::Zero();          ///< of all loads on the bodies of momenta() [N s]
  Vec3 angular_impulse = Vec3::Zero();  ///< about G's origin [N m s]
  double impulse_scale = 0, angular_scale = 0;
  ReferenceVesselLoads vessel{0, false};
};

/// y holds per free body: p, q (w x y z), v of the centre of mass, L = I w; all in G. Then the vessel's state and the
/// account.
class ReferenceState {
 public:
  /// `vessel`: null where none moves. `sums`: on the scene's vessel, null without one.
  ReferenceState(const Bodies& bodies, std::size_t works, ReferenceVessel* vessel, const ReferenceVesselLoads* sums);

  /// The bodies as they are, with an empty account.
  VecX pack(const Bodies& bodies) const;
  /// Of the instant t [s].
  void unpack(double t, const VecX& y, Bodies& bodies) const;
  /// Adds what y has accounted for.
  void add_account(const VecX& y, ReferenceAccount& account) const;
  /// Of `bodies` as unpacked from y, under `loads`.
  void derivative(const Bodies& bodies, const VecX& y, const ReferenceLoads& loads, VecX& dy) const;
  /// Absolute tolerances that go with `relative`: as for poses and velocities of order one, in metres and seconds.
  VecX absolute_tolerances(const Bodies& bodies, double relative) const;

 private:
  Eigen::Index size() const;

  std::vector<int> free_;
  ReferenceVessel* vessel_;
  Eigen::Index vessel_sums_ = 0;  ///< number of the loads on the vessel
  Eigen::Index at_vessel_ = 0, works_ = 0,
               account_ = 0;  ///< where the vessel begins; number of works; where these begin
};

/// Linear momentum and angular momentum about G's origin of the free bodies, and with_vessel of the vessel
/// [kg m/s, kg m^2/s].
std::pair<Vec3, Vec3> momenta(const Bodies& bodies, bool with_vessel);

}  // namespace nilas
