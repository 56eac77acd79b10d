#pragma once
/// Rods that hold a vessel: the speeds that they allow, and their tensions. docs/theory/vessel.md
#include <optional>
#include <string>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas::vessel {

/// Speeds (or accelerations) that obey the rods, and the impulses (or forces) of tension that cause them.
struct HeldByRods {
  VecX speeds;    ///< n
  VecX tensions;  ///< m
};

/// Projects speeds by Gauss's principle. Of all speeds with jacobian * speeds + imposed = 0 it returns those nearest to
/// `free` in the metric of `mass` (n x n): mass * (speeds - free) = -jacobian^T * tensions. The jacobian (m x n) has
/// full rank.
HeldByRods held_by_rods(const MatX& mass, const MatX& jacobian, const VecX& imposed, const VecX& free);

/// Whether the speeds with these indices can obey the rods on their own, whatever the carriage prescribes.
bool obey_with(const MatX& jacobian, const std::vector<int>& some);

/// The contact problem's block in the n - m coordinates z that rods leave free: speeds = N z + speeds that the carriage
/// prescribes. The columns of N are orthonormal. Impulses on this block obey the rods exactly.
VesselBlock block_on_rods(const VesselBlock& block, const MatX& jacobian, const VecX& imposed);

/// Corrects the lengths of rods to rounding by the smallest motion of the tree in the metric of its mass.
void return_to_lengths(JointedTree& tree);
/// Changes the speeds so that no rod changes its length. Returns the impulses of tension for this [N s].
VecX return_to_rates(JointedTree& tree);

/// The first rod that holds nothing beyond the rods before it; empty if none. At a dead point it is the rod in line
/// with the hinge of the part that it holds.
std::optional<int> idle_rod(const JointedTree& tree, const std::vector<RodModel>& rods);
/// The idle rod, or the first whose length could not be kept; empty if none.
std::optional<int> failed_rod(const JointedTree& tree, const std::vector<RodModel>& rods);

struct RodFault {
  int rod;
  std::string message;  ///< the fault, and what is allowed
};
/// The fault of a vessel's rods at its start at t0 [s], if any.
std::optional<RodFault> rod_fault(const VesselModel& model, double t0);
/// Sets the lengths of the rods of a tree in the model's initial state, and moves the tree to a state that obeys them.
void start_on_rods(const VesselModel& model, JointedTree& tree);

}  // namespace nilas::vessel
