#pragma once
/// How rods hold a vessel: the speeds that they leave, and their tensions. docs/theory/vessel.md
#include <optional>
#include <string>

#include "core/vessel/tree/jointed_tree.h"

namespace nilas {

/// Speeds (or accelerations) that obey the rods, and the impulses (or forces) of tension that bring them about.
struct HeldByRods {
  VecX speeds;    ///< n
  VecX tensions;  ///< m
};

/// By Gauss's principle: of all speeds with jacobian * speeds + imposed = 0 those nearest to `free` in the metric of
/// `mass` (n x n), with mass * (speeds - free) = -jacobian^T * tensions. The jacobian (m x n) has full rank.
HeldByRods held_by_rods(const MatX& mass, const MatX& jacobian, const VecX& imposed, const VecX& free);

/// Whether some of the speeds alone, by their indices, can obey the rods, whatever the carriage imposes.
bool obey_with(const MatX& jacobian, const std::vector<int>& some);

/// The contact problem's block in the n - m coordinates z that rods leave: speeds = N z + what the carriage imposes,
/// the columns of N orthonormal. Impulses on it obey the rods exactly.
VesselBlock block_on_rods(const VesselBlock& block, const MatX& jacobian, const VecX& imposed);

/// Where the ends have come apart: moves the tree, nearest in the metric of its mass, until lengths are right to
/// rounding.
void return_to_lengths(JointedTree& tree);
/// Changes the speeds so that no length changes; returns the impulses of tension for it [N s].
VecX return_to_rates(JointedTree& tree);

/// The first rod that holds nothing that the rods before it leave free, or none. At a dead point, where a rod stands in
/// line with the hinge of what it holds, it is that rod.
std::optional<int> idle_rod(const JointedTree& tree, const std::vector<RodModel>& rods);
/// That rod, or the first whose length could not be kept, or none.
std::optional<int> failed_rod(const JointedTree& tree, const std::vector<RodModel>& rods);

struct RodFault {
  int rod;
  std::string message;  ///< what is wrong, and what is allowed
};
/// What is wrong with a vessel's rods at its start at t0 [s], if anything.
std::optional<RodFault> rod_fault(const VesselModel& model, double t0);
/// Gives the rods of a tree at the model's start their lengths, and the tree a start that obeys them.
void start_on_rods(const VesselModel& model, JointedTree& tree);

}  // namespace nilas
