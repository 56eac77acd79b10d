#pragma once
/// The free bodies of a scene, and their accounts of energy and momentum, as one vector of a differential equation.
#include <utility>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/bodies/module.h"

namespace nilas {

/// All that acts on the bodies at one instant.
struct ReferenceLoads {
  Wrenches total;              ///< per body, contact included
  std::vector<double> powers;  ///< of each module that works [W]
  double friction_power = 0;   ///< taken by sliding contacts, >= 0 [W]
  double force_sum = 0;        ///< of the absolute forces of all sources: a scale [N]
  double moment_sum = 0;       ///< the same about G's origin [N m]
  explicit ReferenceLoads(std::size_t bodies, std::size_t works) : total(bodies), powers(works, 0) {}
};

/// Works and impulses over a stretch of time.
struct ReferenceAccount {
  std::vector<double> works;            ///< [J]
  double friction = 0, impact = 0;      ///< taken [J]
  Vec3 impulse = Vec3::Zero();          ///< of all loads on the free bodies [N s]
  Vec3 angular_impulse = Vec3::Zero();  ///< about G's origin [N m s]
  double impulse_scale = 0, angular_scale = 0;
};

/// y holds per free body: p, q (w x y z), v of the centre of mass, L = I w; all in G. Then the account.
class ReferenceState {
 public:
  ReferenceState(const Bodies& bodies, std::size_t works);

  /// The bodies as they are, with an empty account.
  VecX pack(const Bodies& bodies) const;
  void unpack(const VecX& y, Bodies& bodies) const;
  /// Adds what y has accounted for.
  void add_account(const VecX& y, ReferenceAccount& account) const;
  /// Of `bodies` as unpacked from y, under `loads`.
  void derivative(const Bodies& bodies, const VecX& y, const ReferenceLoads& loads, VecX& dy) const;
  /// Absolute tolerances that go with `relative`: as for poses and velocities of order one, in metres and seconds.
  VecX absolute_tolerances(const Bodies& bodies, double relative) const;

 private:
  std::vector<int> free_;
  Eigen::Index works_ = 0, account_ = 0;  ///< number of works; where the account begins
};

/// Linear momentum and angular momentum about G's origin of the free bodies [kg m/s, kg m^2/s].
std::pair<Vec3, Vec3> momenta(const Bodies& bodies);

}  // namespace nilas
