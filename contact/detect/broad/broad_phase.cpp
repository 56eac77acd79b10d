#include "contact/detect/broad/broad_phase.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "contact/detect/broad/tree_walk.h"
#include "core/base/error.h"
#include "core/base/parallel.h"

namespace nilas::detect {

namespace {

/// Distance that a part may move before its box is made again, in margins, and its limits as shares of the part's
/// radius. A margin is about the path of the fastest body in one step. So a box lasts some steps, and few pairs are
/// listed in vain.
constexpr double k_allowed_margins = 4.0;
constexpr double k_least_allowed_radii = 0.01;
constexpr double k_most_allowed_radii = 0.05;
/// Number of pieces of the tree per thread, and the least number of parts per piece.
constexpr std::size_t k_pieces_per_thread = 16;
constexpr std::size_t k_parts_per_piece = 32;

bool can_move(const bodies::Bodies& bodies, const Part& part) {
  return bodies.motion[part.body] != bodies::Motion::fixed;
}

/// Half sizes and centre of the part's box in G.
struct Box {
  Vec3 centre, half;
};

Box box_of(const bodies::Bodies& bodies, const Part& part) {
  Box box;
  const Mat3& R = bodies.R_GB[part.body];
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = R.row(i).transpose();
    const double up = extent(part, axis), down = extent(part, -axis);
    box.half[i] = 0.5 * (up + down);
    box.centre[i] = bodies.p_GB[part.body][i] + 0.5 * (up - down);
  }
  return box;
}

/// The fattened box of one part in the tree, and the pose for which it was made.
struct Leaf : fcl::CollisionObjectd {
  explicit Leaf(std::shared_ptr<fcl::Boxd> box) : CollisionObject(box), shape(std::move(box)) {}

  int part = 0;
  bool moving = false;
  int body = 0;
  std::shared_ptr<fcl::Boxd> shape;
  Vec3 p = Vec3::Zero();
  Mat3 R = Mat3::Zero();
  double fat = -1;   ///< amount added on every side [m]
  double reach = 0;  ///< largest distance of the part from the body's origin [m]

  /// A bound on the distance that any point of the part has moved since the box was made [m].
  double way(const bodies::Bodies& bodies) const {
    return (bodies.p_GB[body] - p).norm() + (bodies.R_GB[body] - R).norm() * reach;
  }

  void fit(const bodies::Bodies& bodies, const Part& of, double half_margin) {
    const double r = of.bounding_radius;
    const double allowance =
        std::clamp(2.0 * k_allowed_margins * half_margin, k_least_allowed_radii * r, k_most_allowed_radii * r);
    const Box box = box_of(bodies, of);
    p = bodies.p_GB[body];
    R = bodies.R_GB[body];
    fat = half_margin + (moving ? allowance : 0.0);
    const Vec3 half = box.half + Vec3::Constant(fat);
    shape->aabb_local = fcl::AABBd(-half, half);
    setTranslation(box.centre);
    computeAABB();
  }

  void set_box(const fcl::AABBd& box) {
    shape->aabb_local = box;
    setTranslation(Vec3::Zero());
    computeAABB();
  }
};

std::unique_ptr<Leaf> make_leaf(const bodies::Bodies& bodies, const Part& part, int index) {
  auto leaf = std::make_unique<Leaf>(std::make_shared<fcl::Boxd>(1.0, 1.0, 1.0));
  leaf->part = index;
  leaf->body = part.body;
  leaf->reach = part.centre.norm() + part.bounding_radius;
  leaf->moving = can_move(bodies, part);
  return leaf;
}

/// Returns the leaf of an entry of FCL's tree.
const Leaf* leaf_of(void* entry) { return static_cast<const Leaf*>(static_cast<fcl::CollisionObjectd*>(entry)); }

/// Where more than one leaf in so many changed, one walk over the whole tree is quicker than one per leaf.
constexpr std::size_t k_leaves_per_changed = 8;

}  // namespace

struct BroadPhase::Tree {
  fcl::DynamicAABBTreeCollisionManagerd manager;
  std::vector<std::unique_ptr<Leaf>> leaves;
  std::vector<int> planes;
  std::vector<char> refitted;  ///< whether the last call of refit changed a leaf
  std::size_t known_parts = 0;
  std::vector<char> changed;                 ///< per part: its box changed since the pairs of the tree were listed
  std::vector<PartPair> of_tree, of_planes;  ///< the pairs of the last call, in rising order
  std::vector<PartPair> anew;                ///< the pairs of changed parts
  std::vector<std::vector<PartPair>> lists;  ///< the pairs of each piece of the tree

  /// Adds the parts that are new and no planes, and calls fit(leaf) for each.
  template <class Fit>
  void add_new_parts(const bodies::Bodies& bodies, const std::vector<Part>& parts, const Fit& fit);
  std::vector<fcl::AABBd> boxes() const;
  void refit(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin, int threads);
  void update_tree_pairs(int bodies, int threads);
  void list_tree_pairs(int bodies, int threads);
  void list_changed_pairs();
  void list_plane_pairs(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin);
  void sort_lists(int bodies, int threads);
};

template <class Fit>
void BroadPhase::Tree::add_new_parts(const bodies::Bodies& bodies, const std::vector<Part>& parts, const Fit& fit) {
  std::vector<fcl::CollisionObjectd*> fresh;
  for (; known_parts < parts.size(); ++known_parts) {
    const Part& part = parts[known_parts];
    changed.push_back(1);
    if (part.kind == PartKind::plane) {
      planes.push_back(static_cast<int>(known_parts));
      continue;
    }
    auto leaf = make_leaf(bodies, part, static_cast<int>(known_parts));
    fit(*leaf);
    fresh.push_back(leaf.get());
    leaves.push_back(std::move(leaf));
  }
  if (fresh.empty()) return;
  manager.registerObjects(fresh);
  manager.setup();
}

/// The box of each leaf as the tree has it. FCL keeps the old box in the tree where the new one lies within it.
std::vector<fcl::AABBd> BroadPhase::Tree::boxes() const {
  if (leaves.empty()) return {};
  using Node = fcl::detail::NodeBase<fcl::AABBd>;
  std::vector<const Node*> nodes{manager.getTree().getRoot()};
  std::map<const void*, const fcl::AABBd*> of_object;
  while (!nodes.empty()) {
    const Node* node = nodes.back();
    nodes.pop_back();
    if (node->isLeaf())
      of_object[node->data] = &node->bv;
    else
      nodes.insert(nodes.end(), {node->children[0], node->children[1]});
  }
  std::vector<fcl::AABBd> boxes;
  for (const auto& leaf : leaves) boxes.push_back(*of_object.at(leaf.get()));
  return boxes;
}

void BroadPhase::Tree::refit(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin, int threads) {
  refitted.resize(leaves.size());
  parallel_chunks(static_cast<std::ptrdiff_t>(leaves.size()), k_chunk, threads,
                  [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
                    for (std::ptrdiff_t k = first; k < last; ++k) {
                      Leaf& leaf = *leaves[k];
                      const bool moves = can_move(bodies, parts[leaf.part]);
                      if (moves != leaf.moving) changed[leaf.part] = 1;
                      leaf.moving = moves;
                      refitted[k] = leaf.way(bodies) + 0.5 * margin > leaf.fat ? 1 : 0;
                      if (refitted[k]) leaf.fit(bodies, parts[leaf.part], 0.5 * margin);
                    }
                  });
  std::vector<fcl::CollisionObjectd*> moved;
  for (std::size_t k = 0; k < leaves.size(); ++k)
    if (refitted[k]) {
      moved.push_back(leaves[k].get());
      changed[leaves[k]->part] = 1;
    }
  if (!moved.empty()) manager.update(moved);
}

/// Appends the pair of two leaves whose boxes overlap, unless they are of one body or cannot move.
static void add_pair(const Leaf* a, const Leaf* b, std::vector<PartPair>& list) {
  if (a->body == b->body || (!a->moving && !b->moving)) return;
  if (b->body < a->body) std::swap(a, b);
  list.push_back({a->body, b->body, a->part, b->part});
}

/// Brings the list of the tree's pairs up to date. The boxes change little from step to step, so few pairs do.
void BroadPhase::Tree::update_tree_pairs(int bodies, int threads) {
  const auto count = static_cast<std::size_t>(std::count(changed.begin(), changed.end(), 1));
  if (k_leaves_per_changed * count > leaves.size())
    list_tree_pairs(bodies, threads);
  else if (count > 0)
    list_changed_pairs();
  std::fill(changed.begin(), changed.end(), 0);
}

/// Lists the pairs that DynamicAABBTreeCollisionManager::collide() finds, with several threads.
void BroadPhase::Tree::list_tree_pairs(int bodies, int threads) {
  const std::size_t wanted =
      threads > 1 ? std::min(k_pieces_per_thread * static_cast<std::size_t>(threads), leaves.size() / k_parts_per_piece)
                  : 1;
  const std::vector<NodePair> pieces = cut_into_pieces(manager.getTree().getRoot(), wanted);
  lists.resize(pieces.size());
  parallel_pieces(static_cast<std::ptrdiff_t>(pieces.size()), threads, [&](std::ptrdiff_t k) {
    std::vector<PartPair> list = std::move(lists[k]);  // local, so that no other thread writes to its cache lines
    list.clear();
    meet_leaves(pieces[k], [&](void* one, void* other) { add_pair(leaf_of(one), leaf_of(other), list); });
    lists[k] = std::move(list);
  });
  sort_lists(bodies, threads);
}

/// Lists anew the pairs of parts that changed. All other pairs are those of the last call.
void BroadPhase::Tree::list_changed_pairs() {
  const TreeNode* const root = manager.getTree().getRoot();
  anew.clear();
  for_each_leaf(root, [&](const TreeNode* node) {
    const Leaf* const leaf = leaf_of(node->data);
    if (!changed[leaf->part]) return;
    meet_leaves({node, root}, [&](void* one, void* other) {
      const Leaf *a = leaf_of(one), *b = leaf_of(other);
      if (changed[b->part] && b->part < a->part) return;  // b lists this pair
      add_pair(a, b, anew);
    });
  });
  std::sort(anew.begin(), anew.end());
  std::erase_if(of_tree, [&](const PartPair& pair) { return changed[pair.part_a] || changed[pair.part_b]; });
  const auto kept = static_cast<std::ptrdiff_t>(of_tree.size());
  of_tree.insert(of_tree.end(), anew.begin(), anew.end());
  std::inplace_merge(of_tree.begin(), of_tree.begin() + kept, of_tree.end());
}

void BroadPhase::Tree::list_plane_pairs(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin) {
  of_planes.clear();
  for (int plane : planes) {
    const int host = parts[plane].body;
    const Vec3 up = bodies.R_GB[host].col(2);
    const bool plane_moves = can_move(bodies, parts[plane]);
    for (const auto& leaf : leaves) {
      if (leaf->body == host || !(leaf->moving || plane_moves)) continue;
      const Vec3 down = -(bodies.R_GB[leaf->body].transpose() * up);
      const double gap = up.dot(bodies.p_GB[leaf->body] - bodies.p_GB[host]) - extent(parts[leaf->part], down);
      if (!(gap < margin)) continue;
      if (host < leaf->body)
        of_planes.push_back({host, leaf->body, plane, leaf->part});
      else
        of_planes.push_back({leaf->body, host, leaf->part, plane});
    }
  }
  std::sort(of_planes.begin(), of_planes.end());
}

/// Sorts the pairs of all lists into buckets by the first body, and then within each bucket.
void BroadPhase::Tree::sort_lists(int bodies, int threads) {
  std::vector<std::size_t> ends(static_cast<std::size_t>(bodies) + 1, 0);  // ends of the buckets
  for (const auto& list : lists)
    for (const PartPair& pair : list) ++ends[pair.body_a + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  of_tree.resize(ends.back());
  for (const auto& list : lists)
    for (const PartPair& pair : list) of_tree[ends[pair.body_a]++] = pair;
  parallel_chunks(bodies, k_chunk, threads, [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t b = first; b < last; ++b)
      std::sort(of_tree.data() + (b == 0 ? 0 : ends[b - 1]), of_tree.data() + ends[b]);
  });
}

BroadPhase::BroadPhase() : tree_(std::make_unique<Tree>()) {}
BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

void BroadPhase::list_pairs(const bodies::Bodies& bodies, const std::vector<Part>& parts, double margin, int threads,
                            std::vector<PartPair>& pairs) {
  tree_->refit(bodies, parts, margin, threads);
  tree_->add_new_parts(bodies, parts, [&](Leaf& leaf) { leaf.fit(bodies, parts[leaf.part], 0.5 * margin); });
  tree_->update_tree_pairs(bodies.size(), threads);
  tree_->list_plane_pairs(bodies, parts, margin);
  const auto &of_tree = tree_->of_tree, &of_planes = tree_->of_planes;
  pairs.resize(of_tree.size() + of_planes.size());
  std::merge(of_tree.begin(), of_tree.end(), of_planes.begin(), of_planes.end(), pairs.begin());
}

void BroadPhase::save(StateWriter out) const {
  std::vector<Vec3> low, high, p;
  std::vector<Mat3> R;
  std::vector<double> fat;
  for (const auto& box : tree_->boxes()) {
    low.push_back(box.min_);
    high.push_back(box.max_);
  }
  for (const auto& leaf : tree_->leaves) {
    p.push_back(leaf->p);
    R.push_back(leaf->R);
    fat.push_back(leaf->fat);
  }
  out.add("low", low);
  out.add("high", high);
  out.add("made_at_p", p);
  out.add("made_at_R", R);
  out.add("fat", fat);
}

void BroadPhase::restore(const bodies::Bodies& bodies, const std::vector<Part>& parts, const StateReader& in) {
  NILAS_DEMAND(tree_->known_parts == 0);
  std::vector<Vec3> low, high, p;
  std::vector<Mat3> R;
  std::vector<double> fat;
  in.get("low", low);
  if (low.empty()) return;  // saved before the first call
  const auto bounded =
      std::count_if(parts.begin(), parts.end(), [](const Part& x) { return x.kind != PartKind::plane; });
  const auto count = static_cast<std::size_t>(bounded);
  in.get("low", low, count);
  in.get("high", high, count);
  in.get("made_at_p", p, count);
  in.get("made_at_R", R, count);
  in.get("fat", fat, count);
  std::size_t k = 0;
  tree_->add_new_parts(bodies, parts, [&](Leaf& leaf) {
    leaf.p = p[k];
    leaf.R = R[k];
    leaf.fat = fat[k];
    leaf.set_box(fcl::AABBd(low[k], high[k]));
    ++k;
  });
}

}  // namespace nilas::detect
