#include <btBulletCollisionCommon.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "contact/detect/narrow_phase.h"
#include "tests/bench/collision/collision.h"
#include "tests/bench/peers/floe_scene.h"
#include "tests/support/collision/pair_judge.h"

namespace nilas::bench {

namespace {

using Answer = std::optional<pairs::Verdict>;  ///< The deepest point, when there is one.

/// A pair in the data structures of Nilas.
class OwnPair {
 public:
  explicit OwnPair(const bodies::Bodies& bodies)
      : bodies_(bodies),
        a_(std::move(detect::make_parts(bodies, 0)[0])),
        b_(std::move(detect::make_parts(bodies, 1)[0])) {}
  void forget() { memory_ = {}; }
  Answer query(detect::AxisSearchRoom& room, std::vector<detect::ContactPoint>& points) {
    points.clear();
    detect::find_pair_contacts(bodies_, a_, b_, 0, {NarrowPhase::nilas, fcl_}, room, memory_, points);
    Answer deepest;
    for (const detect::ContactPoint& p : points)
      if (!deepest || p.gap < deepest->gap) deepest = {p.n, p.gap};
    return deepest;
  }

 private:
  const bodies::Bodies& bodies_;
  detect::Part a_, b_;
  detect::FclShapes fcl_;
  detect::PairMemory memory_;
};

/// The same pair as FCL's convex shapes; FCL's query uses libccd and asks for one contact.
class FclPair {
 public:
  explicit FclPair(const bodies::Bodies& bodies) {
    for (const std::size_t b : {0u, 1u}) {
      const geometry::ConvexPolytope& polytope = bodies.shape[b]->parts[0];
      const auto vertices = std::make_shared<std::vector<Vec3>>(polytope.vertices);
      const auto faces = std::make_shared<std::vector<int>>();
      for (const auto& loop : polytope.faces) {
        faces->push_back(static_cast<int>(loop.size()));
        faces->insert(faces->end(), loop.begin(), loop.end());
      }
      shapes_[b] = std::make_unique<fcl::Convexd>(vertices, static_cast<int>(polytope.faces.size()), faces);
      poses_[b].linear() = bodies.R_GB[b];
      poses_[b].translation() = bodies.p_GB[b];
    }
  }
  Answer query() const {
    fcl::CollisionRequestd request(1, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::CollisionResultd result;
    fcl::collide(shapes_[0].get(), poses_[0], shapes_[1].get(), poses_[1], request, result);
    if (result.numContacts() == 0) return {};
    const auto& contact = result.getContact(0);
    return pairs::Verdict{contact.normal, -contact.penetration_depth};
  }

 private:
  std::array<std::unique_ptr<fcl::Convexd>, 2> shapes_;
  std::array<fcl::Transform3d, 2> poses_{fcl::Transform3d::Identity(), fcl::Transform3d::Identity()};
};

/// Bullet's dispatcher as programs usually set it up: GJK and EPA with its manifolds.
struct BulletWorld {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDispatcherInfo info;
};

/// The same pair as Bullet's hulls, with a margin of a thousandth of the size that is subtracted from the distances.
class BulletPair {
 public:
  BulletPair(const bodies::Bodies& bodies, double size) : margin_(1e-3 * size) {
    for (const std::size_t b : {0u, 1u}) {
      auto shape = std::make_unique<btConvexHullShape>();
      for (const Vec3& v : bodies.shape[b]->parts[0].vertices) shape->addPoint(btVector3(v.x(), v.y(), v.z()), false);
      shape->recalcLocalAabb();
      shape->setMargin(margin_);
      const Quat& q = bodies.q_GB[b];
      const Vec3& p = bodies.p_GB[b];
      objects_[b].setWorldTransform(
          btTransform(btQuaternion(q.x(), q.y(), q.z(), q.w()), btVector3(p.x(), p.y(), p.z())));
      objects_[b].setCollisionShape(shape.get());
      shapes_[b] = std::move(shape);
    }
  }
  Answer query(BulletWorld& world) const {
    const auto wrap = [&](std::size_t b) {
      return btCollisionObjectWrapper(nullptr, shapes_[b].get(), &objects_[b], objects_[b].getWorldTransform(), -1, -1);
    };
    const btCollisionObjectWrapper a = wrap(0), b = wrap(1);
    btCollisionAlgorithm* algorithm = world.dispatcher.findAlgorithm(&a, &b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
    btManifoldResult result(&a, &b);
    algorithm->processCollision(&a, &b, world.info, &result);
    Answer deepest;
    const btPersistentManifold* manifold = result.getPersistentManifold();
    for (int k = 0; manifold != nullptr && k < manifold->getNumContacts(); ++k) {
      const btManifoldPoint& point = manifold->getContactPoint(k);
      const double gap = point.getDistance() + 2 * margin_;
      const btVector3& n = point.m_normalWorldOnB;  // Bullet's normal points from B towards A.
      if (!deepest || gap < deepest->gap) deepest = pairs::Verdict{Vec3(-n.x(), -n.y(), -n.z()), gap};
    }
    algorithm->~btCollisionAlgorithm();
    world.dispatcher.freeCollisionAlgorithm(algorithm);
    return deepest;
  }

 private:
  double margin_;
  std::array<std::unique_ptr<btConvexHullShape>, 2> shapes_;
  std::array<btCollisionObject, 2> objects_;
};

/// Time and errors of one engine on the pairs of a class that overlap.
struct Score {
  double best_ms = oracle::k_infinite;
  pairs::Tally tally;

  void time(const std::function<void()>& work) {
    const double start = peers::now_ms();
    work();
    best_ms = std::min(best_ms, peers::now_ms() - start);
  }
  void judge(const pairs::KnownPair& known, const Answer& answer) {
    const pairs::PartsInQuestion& parts = known.parts[0];
    if (parts.gap.s >= -known.right()) return;
    ++tally.contacts;
    if (answer)
      pairs::judge_verdict(known, parts, *answer, tally);
    else
      ++tally.missed;
  }
};

struct Engines {
  std::vector<std::unique_ptr<OwnPair>> own;
  std::vector<FclPair> fcl;
  std::vector<std::unique_ptr<BulletPair>> bullet;
  BulletWorld world;
  detect::AxisSearchRoom room;
  std::vector<detect::ContactPoint> points;
  double sink = 0;  ///< Sum of all gaps, so that the compiler removes no query.

  void add(const pairs::KnownPair& known) {
    own.push_back(std::make_unique<OwnPair>(known.bodies));
    fcl.emplace_back(known.bodies);
    bullet.push_back(std::make_unique<BulletPair>(known.bodies, known.size));
  }
  void count(const Answer& answer) { sink += answer ? answer->gap : 0; }
};

using Scores = std::array<Score, 4>;  ///< Nilas on new pairs, Nilas on remembered pairs, FCL, Bullet.

/// Times each engine over all pairs, in turn, for the given number of rounds.
void time_engines(Engines& engines, int rounds, Scores& scores) {
  for (int round = 0; round < rounds; ++round) {
    scores[0].time([&] {
      for (auto& pair : engines.own) {
        pair->forget();
        engines.count(pair->query(engines.room, engines.points));
      }
    });
    scores[1].time([&] {
      for (auto& pair : engines.own) engines.count(pair->query(engines.room, engines.points));
    });
    scores[2].time([&] {
      for (const auto& pair : engines.fcl) engines.count(pair.query());
    });
    scores[3].time([&] {
      for (const auto& pair : engines.bullet) engines.count(pair->query(engines.world));
    });
  }
}

void judge_engines(Engines& engines, const std::vector<pairs::KnownPair>& known, Scores& scores) {
  for (std::size_t k = 0; k < known.size(); ++k) {
    engines.own[k]->forget();
    scores[0].judge(known[k], engines.own[k]->query(engines.room, engines.points));
    scores[1].judge(known[k], engines.own[k]->query(engines.room, engines.points));
    scores[2].judge(known[k], engines.fcl[k].query());
    scores[3].judge(known[k], engines.bullet[k]->query(engines.world));
  }
}

Scores compare(const pairs::PairClass& c, int count, int rounds, double& sink) {
  RandomStream random(9, c.name);
  std::vector<pairs::KnownPair> known;
  for (int k = 0; k < count; ++k) known.push_back(pairs::find_truth(c, pairs::draw_pair(c, random)));
  Engines engines;
  for (const auto& pair : known) engines.add(pair);
  Scores scores;
  time_engines(engines, rounds, scores);
  judge_engines(engines, known, scores);
  sink += engines.sink;
  return scores;
}

}  // namespace

bool peer_table(int count, int rounds) {
  std::printf("us per pair (best of %d), ratios of pairs per second, and missed / wrong normals of the overlapping\n",
              rounds);
  std::printf("%-25s %8s %8s %8s %8s %8s %8s %8s  %-12s %-12s %-12s\n", "class", "new", "again", "FCL", "Bullet",
              "new/FCL", "new/Blt", "overlap", "Nilas", "FCL", "Bullet");
  double sink = 0;
  bool right = true;
  for (const pairs::PairClass& c : pairs::all_classes()) {
    if (pairs::has_cylinder(c) || std::string_view(c.name) == "concave_floes") continue;
    const Scores scores = compare(c, count, rounds, sink);
    const auto us = [&](std::size_t k) { return 1e3 * scores[k].best_ms / count; };
    const auto faults = [&](std::size_t k) {
      return std::to_string(scores[k].tally.missed) + " / " + std::to_string(scores[k].tally.wrong_normals);
    };
    std::printf("%-25s %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %8ld  %-12s %-12s %-12s\n", c.name, us(0), us(1), us(2),
                us(3), us(2) / us(0), us(3) / us(0), scores[0].tally.contacts, faults(0).c_str(), faults(2).c_str(),
                faults(3).c_str());
    std::fflush(stdout);
    for (const std::size_t k : {0u, 1u})
      right = right && scores[k].tally.missed + scores[k].tally.wrong_normals + scores[k].tally.wrong_depths == 0;
  }
  return right && std::isfinite(sink);
}

}  // namespace nilas::bench
