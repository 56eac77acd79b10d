#include "contact/detect/broad_phase.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "core/base/error.h"

namespace nilas {

namespace {

/// A part may move this far before its box is made anew: so many margins, since a margin is about the way of the
/// fastest body in one step, but within these shares of its radius. A box lasts some steps and few pairs are listed in
/// vain.
constexpr double k_allowed_margins = 4.0;
constexpr double k_least_allowed_radii = 0.01;
constexpr double k_most_allowed_radii = 0.05;

bool can_move(const Bodies& bodies, const Part& part) { return bodies.motion[part.body] != Motion::fixed; }

/// Half sizes and centre of the part's box in G.
struct Box {
  Vec3 centre, half;
};

Box box_of(const Bodies& bodies, const Part& part) {
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

/// One part's fattened box in the tree, and the pose it was made for.
struct Leaf {
  int part = 0;
  bool moving = false;
  int body = 0;
  std::shared_ptr<fcl::Boxd> shape;
  std::unique_ptr<fcl::CollisionObjectd> object;
  Vec3 p = Vec3::Zero();
  Mat3 R = Mat3::Zero();
  double fat = -1;   ///< what was added on every side [m]
  double reach = 0;  ///< of the part from the body's origin [m]

  /// Bound on the way of any point of the part since the box was made.
  double way(const Bodies& bodies) const {
    return (bodies.p_GB[body] - p).norm() + (bodies.R_GB[body] - R).norm() * reach;
  }

  void fit(const Bodies& bodies, const Part& of, double half_margin) {
    const double r = of.bounding_radius;
    const double allowance =
        std::clamp(2.0 * k_allowed_margins * half_margin, k_least_allowed_radii * r, k_most_allowed_radii * r);
    const Box box = box_of(bodies, of);
    p = bodies.p_GB[body];
    R = bodies.R_GB[body];
    fat = half_margin + (moving ? allowance : 0.0);
    const Vec3 half = box.half + Vec3::Constant(fat);
    shape->aabb_local = fcl::AABBd(-half, half);
    object->setTranslation(box.centre);
    object->computeAABB();
  }

  void set_box(const fcl::AABBd& box) {
    shape->aabb_local = box;
    object->setTranslation(Vec3::Zero());
    object->computeAABB();
  }
};

std::unique_ptr<Leaf> make_leaf(const Bodies& bodies, const Part& part, int index) {
  auto leaf = std::make_unique<Leaf>();
  leaf->part = index;
  leaf->body = part.body;
  leaf->reach = part.centre.norm() + part.bounding_radius;
  leaf->shape = std::make_shared<fcl::Boxd>(1.0, 1.0, 1.0);
  leaf->object = std::make_unique<fcl::CollisionObjectd>(leaf->shape);
  leaf->object->setUserData(leaf.get());
  leaf->moving = can_move(bodies, part);
  return leaf;
}

}  // namespace

struct BroadPhase::Tree {
  fcl::DynamicAABBTreeCollisionManagerd manager;
  std::vector<std::unique_ptr<Leaf>> leaves;
  std::vector<int> planes;
  std::size_t known_parts = 0;
  std::vector<PartPair> pairs;

  /// Calls fit(leaf) for each part that is new and no plane.
  template <class Fit>
  void add_new_parts(const Bodies& bodies, const std::vector<Part>& parts, const Fit& fit);
  std::vector<fcl::AABBd> boxes() const;
  void refit(const Bodies& bodies, const std::vector<Part>& parts, double margin);
  void list_tree_pairs();
  void list_plane_pairs(const Bodies& bodies, const std::vector<Part>& parts, double margin);
};

template <class Fit>
void BroadPhase::Tree::add_new_parts(const Bodies& bodies, const std::vector<Part>& parts, const Fit& fit) {
  std::vector<fcl::CollisionObjectd*> fresh;
  for (; known_parts < parts.size(); ++known_parts) {
    const Part& part = parts[known_parts];
    if (part.kind == PartKind::plane) {
      planes.push_back(static_cast<int>(known_parts));
      continue;
    }
    auto leaf = make_leaf(bodies, part, static_cast<int>(known_parts));
    fit(*leaf);
    fresh.push_back(leaf->object.get());
    leaves.push_back(std::move(leaf));
  }
  if (fresh.empty()) return;
  manager.registerObjects(fresh);
  manager.setup();
}

/// Of each leaf as the tree has it: FCL leaves a box in the tree as it is when the new one lies within it.
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
  for (const auto& leaf : leaves) boxes.push_back(*of_object.at(leaf->object.get()));
  return boxes;
}

void BroadPhase::Tree::refit(const Bodies& bodies, const std::vector<Part>& parts, double margin) {
  std::vector<fcl::CollisionObjectd*> moved;
  for (const auto& leaf : leaves) {
    leaf->moving = can_move(bodies, parts[leaf->part]);
    if (leaf->way(bodies) + 0.5 * margin <= leaf->fat) continue;
    leaf->fit(bodies, parts[leaf->part], 0.5 * margin);
    moved.push_back(leaf->object.get());
  }
  if (!moved.empty()) manager.update(moved);
}

void BroadPhase::Tree::list_tree_pairs() {
  const auto list = [](fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* data) {
    const Leaf* a = static_cast<const Leaf*>(one->getUserData());
    const Leaf* b = static_cast<const Leaf*>(other->getUserData());
    if (a->body == b->body || (!a->moving && !b->moving)) return false;
    if (b->body < a->body) std::swap(a, b);
    static_cast<std::vector<PartPair>*>(data)->push_back({a->body, b->body, a->part, b->part});
    return false;
  };
  manager.collide(&pairs, list);
}

void BroadPhase::Tree::list_plane_pairs(const Bodies& bodies, const std::vector<Part>& parts, double margin) {
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
        pairs.push_back({host, leaf->body, plane, leaf->part});
      else
        pairs.push_back({leaf->body, host, leaf->part, plane});
    }
  }
}

BroadPhase::BroadPhase() : tree_(std::make_unique<Tree>()) {}
BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

const std::vector<PartPair>& BroadPhase::candidates(const Bodies& bodies, const std::vector<Part>& parts,
                                                    double margin) {
  tree_->refit(bodies, parts, margin);
  tree_->add_new_parts(bodies, parts, [&](Leaf& leaf) { leaf.fit(bodies, parts[leaf.part], 0.5 * margin); });
  tree_->pairs.clear();
  tree_->list_tree_pairs();
  tree_->list_plane_pairs(bodies, parts, margin);
  std::sort(tree_->pairs.begin(), tree_->pairs.end());
  return tree_->pairs;
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

void BroadPhase::restore(const Bodies& bodies, const std::vector<Part>& parts, const StateReader& in) {
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

}  // namespace nilas
