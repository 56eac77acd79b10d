#pragma once
/// Rods of a Simbody tree: each is a Constraint::Rod between a body and the ground. Include it in sources only.
#include <vector>

#include "core/vessel/tree/simbody.h"

namespace nilas::vessel {

class TreeRods {
 public:
  /// Adds a rod before the tree is complete. `body`: index of the rod's body in the result of loads(). `at_B`: end in
  /// the body's frame; `to_G`: fixed end [m].
  void add(SimTK::SimbodyMatterSubsystem& matter, SimTK::MobilizedBody& mobilized, int body, const Vec3& at_B,
           const Vec3& to_G);
  int size() const { return static_cast<int>(rods_.size()); }
  double distance(int rod, const SimTK::State& state) const;  ///< distance of its ends [m]; state realised to Position
  void set_length(int rod, double length, SimTK::State& state) const;

  /// Distances minus lengths [m]; state realised to Position.
  VecX errors(const SimTK::State& state) const;
  /// Derivatives of the distances with respect to all speeds of the tree, one row per rod; state realised to Position.
  MatX jacobian(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const;
  VecX rates(const SimTK::State& state) const;  ///< rates of the distances [m/s]; state realised to Velocity
  /// Second rates of the distances at constant speeds [m/s^2]; state realised to Velocity.
  VecX bias(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const;
  /// Loads of the tensions on each of `bodies`, in G about its origin; state realised to Position.
  std::vector<Wrench> loads(const VecX& tensions, std::size_t bodies, const SimTK::State& state) const;

 private:
  struct Rod {
    SimTK::Constraint::Rod constraint;
    SimTK::MobilizedBody mobilized;
    int body;
    Vec3 at_B, to_G;
  };
  std::vector<Rod> rods_;
};

}  // namespace nilas::vessel
