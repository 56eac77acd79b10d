/// The packed scene on Bullet in its most accurate setting: float64, 1 mm margins, clipped polyhedral manifolds, two
/// friction directions.
/// usage: peer_bullet SCENE SWEEPS
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "tests/bench/peers/yardstick.h"

namespace {

/// Bullet's world with timings of its two phases.
class TimedWorld : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;
  double detect_ms = 0, solve_ms = 0;
  void performDiscreteCollisionDetection() override {
    const double t = peers::now_ms();
    btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
    detect_ms += peers::now_ms() - t;
  }

 protected:
  void solveConstraints(btContactSolverInfo& info) override {
    const double t = peers::now_ms();
    btDiscreteDynamicsWorld::solveConstraints(info);
    solve_ms += peers::now_ms() - t;
  }
};

constexpr double k_margin = 0.001;  // [m]

struct World {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  TimedWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;

  World(const peers::FloeScene& s, int sweeps) {
    world.setGravity(btVector3(0, 0, -s.gravity));
    world.getSolverInfo().m_numIterations = sweeps;
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    world.getDispatchInfo().m_enableSatConvex = true;
  }
  ~World() {
    for (auto& body : bodies) world.removeRigidBody(body.get());
  }

  btRigidBody* add(std::unique_ptr<btCollisionShape> shape, double mass, const btVector3& inertia,
                   const btTransform& pose, double friction) {
    btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(), inertia);
    info.m_startWorldTransform = pose;
    info.m_friction = std::sqrt(friction);  // Bullet multiplies the two coefficients
    shapes.push_back(std::move(shape));
    bodies.push_back(std::make_unique<btRigidBody>(info));
    bodies.back()->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(bodies.back().get());
    return bodies.back().get();
  }
};

std::unique_ptr<btCollisionShape> prism(const std::vector<peers::Point>& outline, double bottom, double top) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const auto& p : outline)
    for (const double z : {bottom, top}) shape->addPoint(btVector3(p.x, p.y, z), false);
  shape->recalcLocalAabb();
  shape->setMargin(k_margin);
  shape->initializePolyhedralFeatures();
  return shape;
}

peers::BodyState state(const btRigidBody& body) {
  peers::BodyState q{};
  const btTransform& t = body.getWorldTransform();
  for (int i = 0; i < 3; ++i) {
    q.p[i] = t.getOrigin()[i];
    q.v[i] = body.getLinearVelocity()[i];
    q.w[i] = body.getAngularVelocity()[i];
    for (int j = 0; j < 3; ++j) q.R[i][j] = t.getBasis()[i][j];
  }
  return q;
}

peers::Touching touching(const btManifoldPoint& point, int body0, int body1, double erp, double h) {
  const auto vec = [](const btVector3& x) { return nilas::Vec3(x[0], x[1], x[2]); };
  peers::Touching t;
  t.a = body1;  // The normal points towards the first body.
  t.b = body0;
  t.p = 0.5 * (vec(point.getPositionWorldOnA()) + vec(point.getPositionWorldOnB()));
  t.n = vec(point.m_normalWorldOnB);
  t.impulse = point.m_appliedImpulse * t.n + point.m_appliedImpulseLateral1 * vec(point.m_lateralFrictionDir1) +
              point.m_appliedImpulseLateral2 * vec(point.m_lateralFrictionDir2);
  const double gap = point.getDistance();
  t.speed_asked = gap > 0 ? -gap / h : -erp * gap / h;  // Split impulse leaves depths below 4 cm alone.
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const peers::FloeScene s = peers::read(argv[1]);
  const int sweeps = std::atoi(argv[2]);
  World w(s, sweeps);
  std::vector<btRigidBody*> floes;
  for (const auto& f : s.floes) {
    const btTransform pose(btQuaternion(btVector3(0, 0, 1), f.yaw), btVector3(f.centre.x, f.centre.y, s.mid_plane()));
    floes.push_back(w.add(prism(f.outline, -s.thickness / 2, s.thickness / 2), f.mass,
                          btVector3(f.inertia[0], f.inertia[1], f.inertia[2]), pose, s.friction));
    floes.back()->setUserIndex(static_cast<int>(floes.size()) - 1);
  }
  const auto at = [&](double x) { return btTransform(btQuaternion::getIdentity(), btVector3(x, 0, 0)); };
  btRigidBody* hull =
      w.add(prism(s.hull_outline(), s.hull_bottom, s.hull_top), 0, btVector3(0, 0, 0), at(s.hull_x), s.friction);
  hull->setCollisionFlags(hull->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  hull->setUserIndex(peers::k_hull);
  const double walls[4][3] = {{1, 0, s.x0}, {-1, 0, -s.x1}, {0, 1, s.y0}, {0, -1, -s.y1}};
  for (const auto& wall : walls)
    w.add(std::make_unique<btStaticPlaneShape>(btVector3(wall[0], wall[1], 0), wall[2]), 0, btVector3(0, 0, 0),
          btTransform::getIdentity(), s.friction)
        ->setUserIndex(peers::k_wall);
  const auto states = [&] {
    std::vector<peers::BodyState> all;
    for (const btRigidBody* body : floes) all.push_back(state(*body));
    return all;
  };

  std::vector<peers::Parts> window;
  std::vector<double> natural_maps;
  double contacts = 0, penetration = 0;
  for (int n = 0; n < peers::k_last_measured; ++n) {
    w.world.detect_ms = w.world.solve_ms = 0;
    const std::vector<peers::BodyState> before = states();
    const double t0 = peers::now_ms();
    for (std::size_t i = 0; i < floes.size(); ++i) {
      const peers::Load load = peers::water_load(s, s.floes[i], state(*floes[i]));
      floes[i]->applyCentralForce(btVector3(load.f[0], load.f[1], load.f[2]));
      floes[i]->applyTorque(btVector3(load.t[0], load.t[1], load.t[2]));
    }
    const double t1 = peers::now_ms();
    // Bullet differentiates a kinematic body's pose to get its velocity.
    hull->setInterpolationWorldTransform(at(s.hull_x + s.hull_speed * n * s.step));
    hull->setWorldTransform(at(s.hull_x + s.hull_speed * (n + 1) * s.step));
    w.world.stepSimulation(s.step, 0);
    const double t2 = peers::now_ms();
    if (n < peers::k_first_measured) continue;
    window.push_back({w.world.detect_ms, w.world.solve_ms, t1 - t0, t2 - t0});
    std::vector<peers::Touching> touches;
    for (int k = 0; k < w.dispatcher.getNumManifolds(); ++k) {
      const auto* manifold = w.dispatcher.getManifoldByIndexInternal(k);
      for (int j = 0; j < manifold->getNumContacts(); ++j) {
        const double depth = -manifold->getContactPoint(j).getDistance();
        contacts += depth > 0 ? 1 : 0;
        penetration = std::max(penetration, depth);
        touches.push_back(touching(manifold->getContactPoint(j), manifold->getBody0()->getUserIndex(),
                                   manifold->getBody1()->getUserIndex(), w.world.getSolverInfo().m_erp2, s.step));
      }
    }
    natural_maps.push_back(peers::natural_map(s, before, states(), touches));
  }
  peers::print_row("bullet", s.floes.size(), sweeps, window, contacts / static_cast<double>(window.size()),
                   penetration / s.thickness, natural_maps);
}
