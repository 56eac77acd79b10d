#pragma once
/// Finds the leaves of FCL's tree of boxes whose boxes overlap. The search is divided into pieces that several threads
/// can take.
#include <fcl/broadphase/detail/node_base.h>
#include <fcl/math/bv/AABB.h>

#include <cstddef>
#include <vector>

namespace nilas::detect {

using TreeNode = fcl::detail::NodeBase<fcl::AABBd>;

/// Stands for all pairs of a leaf under `a` and one under `b`; with a == b for all pairs of two leaves under it.
struct NodePair {
  const TreeNode* a = nullptr;
  const TreeNode* b = nullptr;
};

// Inline, because FCL's own tests of nodes and boxes are calls into the library.
inline bool is_leaf(const TreeNode& node) { return node.children[1] == nullptr; }

inline bool overlap(const fcl::AABBd& a, const fcl::AABBd& b) {
  return !(a.min_.array() > b.max_.array()).any() && !(a.max_.array() < b.min_.array()).any();
}

inline bool is_pair_of_leaves(const NodePair& pair) { return pair.a != pair.b && is_leaf(*pair.a) && is_leaf(*pair.b); }

/// Calls visit(NodePair) for the pairs into which a pair opens that is none of two leaves. The larger box is opened, as
/// in FCL.
template <class Visit>
void open_pair(const NodePair& pair, const Visit& visit) {
  const auto [a, b] = pair;
  if (a == b) {
    if (is_leaf(*a)) return;
    visit({a->children[0], a->children[0]});
    visit({a->children[1], a->children[1]});
    visit({a->children[0], a->children[1]});
    return;
  }
  if (!overlap(a->bv, b->bv)) return;
  const auto size = [](const TreeNode& node) { return (node.bv.max_ - node.bv.min_).squaredNorm(); };
  if (is_leaf(*b) || (!is_leaf(*a) && size(*a) > size(*b))) {
    visit({a->children[0], b});
    visit({a->children[1], b});
  } else {
    visit({a, b->children[0]});
    visit({a, b->children[1]});
  }
}

/// Calls meet(object, object) with the `data` of each two leaves of the pair whose boxes overlap.
template <class Meet>
void meet_leaves(const NodePair& pair, const Meet& meet) {
  if (!is_pair_of_leaves(pair))
    open_pair(pair, [&](const NodePair& part) { meet_leaves(part, meet); });
  else if (overlap(pair.a->bv, pair.b->bv))
    meet(pair.a->data, pair.b->data);
}

/// Calls visit(node) for all leaves under a node (null: none).
template <class Visit>
void for_each_leaf(const TreeNode* node, const Visit& visit) {
  if (node == nullptr) return;
  if (is_leaf(*node)) return visit(node);
  for_each_leaf(node->children[0], visit);
  for_each_leaf(node->children[1], visit);
}

/// Divides the pairs of all leaves under `root` (null: none) into at least `wanted` pieces, as far as there are so
/// many.
inline std::vector<NodePair> cut_into_pieces(const TreeNode* root, std::size_t wanted) {
  std::vector<NodePair> pieces, parts;
  if (root != nullptr) pieces.push_back({root, root});
  for (bool opened = true; opened && pieces.size() < wanted; pieces.swap(parts)) {
    parts.clear();
    opened = false;
    for (const NodePair& piece : pieces) {
      if (is_pair_of_leaves(piece)) {
        parts.push_back(piece);
        continue;
      }
      opened = true;
      open_pair(piece, [&](const NodePair& part) { parts.push_back(part); });
    }
  }
  return pieces;
}

}  // namespace nilas::detect
