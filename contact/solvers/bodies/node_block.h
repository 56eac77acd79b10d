#pragma once
/// Blocks of a node's six coordinates, padded to eight so that they fill whole registers. The pads stay zero.
#include <cstddef>
#include <vector>

namespace nilas::solvers {

constexpr int k_node_size = 6;   ///< coordinates of a node
constexpr int k_node_width = 8;  ///< the same with the pads

/// 6 x 6 numbers by columns.
struct alignas(64) NodeBlock {
  double column[k_node_size][k_node_width] = {};
};

/// Three rows on one node: J of a contact.
struct alignas(64) NodeRows {
  double row[3][k_node_width] = {};
};

struct alignas(64) NodeNumbers {
  double value[k_node_width] = {};
};

/// One group of numbers per node.
using NodeVector = std::vector<NodeNumbers>;

}  // namespace nilas::solvers
