#pragma once
/// Rods of a Simbody tree: each is a Constraint::Rod between a body and the ground. Include it in sources only.
#include <vector>

#include "core/vessel/tree/simbody.h"

namespace nilas {

class TreeRods {
 public:
  /// Before the tree stands, to `body`, the place of its loads among those of loads(). `at_B`: in the frame of the
  /// body; `to_G`: the fixed end [m].
  void add(SimTK::SimbodyMatterSubsystem& matter, SimTK::MobilizedBody& mobilized, int body, const Vec3& at_B,
           const Vec3& to_G);
  int size() const { return static_cast<int>(rods_.size()); }
  double distance(int rod, const SimTK::State& state) const;  ///< between its ends [m]; realised to Position
  void set_length(int rod, double length, SimTK::State& state) const;

  /// Distances less lengths [m]; realised to Position.
  VecX errors(const SimTK::State& state) const;
  /// Of the distances by all speeds of the tree, one row per rod; realised to Position.
  MatX jacobian(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const;
  VecX rates(const SimTK::State& state) const;  ///< of the distances [m/s]; realised to Velocity
  /// Second rates of the distances where no speed changes [m/s^2]; realised to Velocity.
  VecX bias(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const;
  /// What tensions do to each of `bodies`, in G about its origin; realised to Position.
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

}  // namespace nilas
