#pragma once
/// Exchange of floes: overlapping floes swap places with others of similar size, or move, if that reduces the overlaps.
/// Relaxation alone cannot do this once floes block each other.
#include <vector>

#include "core/base/random.h"
#include "core/field/pack/centre_grid.h"
#include "core/field/spec/loose_floe.h"

namespace nilas::field {

class Exchange {
 public:
  /// Outlines closer than `gap` [m] count as overlapping. Floes must be sorted by size; references must outlive this.
  Exchange(std::vector<LooseFloe>& floes, const FieldBounds& bounds, double gap, RandomStream& random);

  /// Tries `trials` random changes and keeps those that reduce the sum of squared overlaps.
  void run(int trials);

 private:
  struct Trial {
    int floe;
    LooseFloe moved;
    ConvexOutline outline;
  };
  void read_positions();
  void try_swap(int i);
  void try_move(int i);
  /// Sum of squared overlaps of a floe with all others except `other`, the obstacles and the edge [m^2].
  double overlap(int floe, const Vec2& centre, const ConvexOutline& outline, int other) const;
  double overlap_now(int floe) const;
  void keep(Trial& trial);

  std::vector<LooseFloe>& floes_;
  const FieldBounds& bounds_;
  double gap_;
  RandomStream& random_;
  double largest_radius_ = 0;
  CentreGrid grid_;
  std::vector<ConvexOutline> outlines_;
};

}  // namespace nilas::field
