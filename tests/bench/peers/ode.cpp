/// The packed scene on ODE: QuickStep in double precision, first friction direction along the slip.
/// usage: peer_ode SCENE SWEEPS
#include <ode/ode.h>

#include <cstdint>
#include <memory>

#include "tests/bench/peers/yardstick.h"

namespace {

struct Touch {
  dContact contact;
  dBodyID a, b;
};

struct World {
  dWorldID world = dWorldCreate();
  dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
  dJointGroupID joints = dJointGroupCreate(0);
  std::vector<std::unique_ptr<std::vector<dReal>>> numbers;
  std::vector<std::unique_ptr<std::vector<unsigned>>> indices;
  std::vector<Touch> touches;
  double friction = 0;
};

/// Makes a prism. ODE keeps pointers into the arrays, so the world owns them.
dGeomID prism(World& w, const std::vector<peers::Point>& outline, double bottom, double top) {
  auto planes = std::make_unique<std::vector<dReal>>();
  auto points = std::make_unique<std::vector<dReal>>();
  auto polygons = std::make_unique<std::vector<unsigned>>();
  const auto n = static_cast<unsigned>(outline.size());
  for (const double z : {bottom, top})
    for (const auto& p : outline) points->insert(points->end(), {p.x, p.y, z});
  for (unsigned i = 0; i < n; ++i) {
    const unsigned j = (i + 1) % n;
    const double ex = outline[j].x - outline[i].x, ey = outline[j].y - outline[i].y, l = std::hypot(ex, ey);
    planes->insert(planes->end(), {ey / l, -ex / l, 0, (ey * outline[i].x - ex * outline[i].y) / l});
    polygons->insert(polygons->end(), {4u, i, j, n + j, n + i});
  }
  planes->insert(planes->end(), {0, 0, -1, -bottom, 0, 0, 1, top});
  polygons->push_back(n);
  for (unsigned i = 0; i < n; ++i) polygons->push_back(n - 1 - i);
  polygons->push_back(n);
  for (unsigned i = 0; i < n; ++i) polygons->push_back(n + i);
  const dGeomID geom = dCreateConvex(w.space, planes->data(), n + 2, points->data(), 2 * n, polygons->data());
  w.numbers.push_back(std::move(planes));
  w.numbers.push_back(std::move(points));
  w.indices.push_back(std::move(polygons));
  return geom;
}

void collide(void* data, dGeomID g1, dGeomID g2) {
  auto* w = static_cast<World*>(data);
  const dBodyID a = dGeomGetBody(g1), b = dGeomGetBody(g2);
  if (!a && !b) return;
  constexpr int k_most = 8;
  constexpr double k_slow = 1e-6;  // No slip direction is defined below this speed [m/s].
  dContactGeom found[k_most];
  const int n = dCollide(g1, g2, k_most, found, sizeof(dContactGeom));
  for (int i = 0; i < n; ++i) {
    Touch touch{};
    touch.a = a;
    touch.b = b;
    touch.contact.geom = found[i];
    touch.contact.surface.mode = dContactApprox1;
    touch.contact.surface.mu = w->friction;
    dVector3 va{}, vb{};
    const dReal* p = found[i].pos;
    if (a) dBodyGetPointVel(a, p[0], p[1], p[2], va);
    if (b) dBodyGetPointVel(b, p[0], p[1], p[2], vb);
    double slip[3], along = 0, norm = 0;
    for (int k = 0; k < 3; ++k) along += (va[k] - vb[k]) * found[i].normal[k];
    for (int k = 0; k < 3; ++k) {
      slip[k] = va[k] - vb[k] - along * found[i].normal[k];
      norm += slip[k] * slip[k];
    }
    norm = std::sqrt(norm);
    if (norm > k_slow) {
      touch.contact.surface.mode |= dContactFDir1;
      for (int k = 0; k < 3; ++k) touch.contact.fdir1[k] = slip[k] / norm;
    }
    w->touches.push_back(touch);
  }
}

dBodyID add_floe(World& w, const peers::FloeScene& s, const peers::Floe& f) {
  const dBodyID body = dBodyCreate(w.world);
  dMass mass;
  dMassSetParameters(&mass, f.mass, 0, 0, 0, f.inertia[0], f.inertia[1], f.inertia[2], 0, 0, 0);
  dBodySetMass(body, &mass);
  dBodySetPosition(body, f.centre.x, f.centre.y, s.mid_plane());
  dMatrix3 R;
  dRFromAxisAndAngle(R, 0, 0, 1, f.yaw);
  dBodySetRotation(body, R);
  dGeomSetBody(prism(w, f.outline, -s.thickness / 2, s.thickness / 2), body);
  return body;
}

peers::BodyState state(dBodyID body) {
  peers::BodyState q{};
  const dReal *p = dBodyGetPosition(body), *v = dBodyGetLinearVel(body), *a = dBodyGetAngularVel(body),
              *R = dBodyGetRotation(body);
  for (int i = 0; i < 3; ++i) {
    q.p[i] = p[i];
    q.v[i] = v[i];
    q.w[i] = a[i];
    for (int j = 0; j < 3; ++j) q.R[i][j] = R[4 * i + j];
  }
  return q;
}

/// Share of the depth that ODE removes in a step by velocities.
constexpr double k_erp = 0.2;

/// Index of the floe that a body is, or that of the hull or a wall.
int index_of(dBodyID body) {
  if (!body) return peers::k_wall;
  if (dBodyIsKinematic(body)) return peers::k_hull;
  return static_cast<int>(reinterpret_cast<std::intptr_t>(dBodyGetData(body)));
}

peers::Touching touching(const Touch& touch, const dJointFeedback& feedback, double h) {
  const dContactGeom& geom = touch.contact.geom;
  peers::Touching t;
  t.p = peers::vec(geom.pos);
  t.n = peers::vec(geom.normal);
  t.impulse = h * peers::vec(feedback.f1);
  t.speed_asked = k_erp * geom.depth / h;
  // The normal points into the first geometry. A joint whose first body is the world has the other one in second place.
  t.b = index_of(touch.a);
  t.a = index_of(touch.b);
  if (touch.a) return t;
  std::swap(t.a, t.b);
  t.n = -t.n;
  return t;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const peers::FloeScene s = peers::read(argv[1]);
  const int sweeps = std::atoi(argv[2]);
  dInitODE2(0);
  World w;
  w.friction = s.friction;
  dWorldSetGravity(w.world, 0, 0, -s.gravity);
  dWorldSetQuickStepNumIterations(w.world, sweeps);
  std::vector<dBodyID> floes;
  for (const auto& f : s.floes) {
    floes.push_back(add_floe(w, s, f));
    dBodySetData(floes.back(), reinterpret_cast<void*>(static_cast<std::intptr_t>(floes.size() - 1)));
  }
  dWorldSetERP(w.world, k_erp);
  const auto states = [&] {
    std::vector<peers::BodyState> all;
    for (const dBodyID body : floes) all.push_back(state(body));
    return all;
  };
  const dBodyID hull = dBodyCreate(w.world);
  dBodySetKinematic(hull);
  dGeomSetBody(prism(w, s.hull_outline(), s.hull_bottom, s.hull_top), hull);
  dCreatePlane(w.space, 1, 0, 0, s.x0);
  dCreatePlane(w.space, -1, 0, 0, -s.x1);
  dCreatePlane(w.space, 0, 1, 0, s.y0);
  dCreatePlane(w.space, 0, -1, 0, -s.y1);

  std::vector<peers::Parts> window;
  std::vector<double> natural_maps;
  std::vector<dJointFeedback> feedback;
  double contacts = 0, penetration = 0;
  for (int n = 0; n < peers::k_last_measured; ++n) {
    const double t0 = peers::now_ms();
    for (std::size_t i = 0; i < floes.size(); ++i) {
      const peers::Load load = peers::water_load(s, s.floes[i], state(floes[i]));
      dBodyAddForce(floes[i], load.f[0], load.f[1], load.f[2]);
      dBodyAddTorque(floes[i], load.t[0], load.t[1], load.t[2]);
    }
    dBodySetPosition(hull, s.hull_x + s.hull_speed * n * s.step, 0, 0);
    dBodySetLinearVel(hull, s.hull_speed, 0, 0);
    const double t1 = peers::now_ms();
    w.touches.clear();
    dSpaceCollide(w.space, &w, &collide);
    const double t2 = peers::now_ms();
    const bool measured = n >= peers::k_first_measured;
    const std::vector<peers::BodyState> before = measured ? states() : std::vector<peers::BodyState>();
    feedback.assign(w.touches.size(), dJointFeedback{});
    const double t3 = peers::now_ms();
    for (std::size_t k = 0; k < w.touches.size(); ++k) {
      const dJointID joint = dJointCreateContact(w.world, w.joints, &w.touches[k].contact);
      dJointAttach(joint, w.touches[k].a, w.touches[k].b);
      if (measured) dJointSetFeedback(joint, &feedback[k]);
    }
    dWorldQuickStep(w.world, s.step);
    dJointGroupEmpty(w.joints);
    const double t4 = peers::now_ms();
    if (!measured) continue;
    window.push_back({t2 - t1, t4 - t3, t1 - t0, t4 - t3 + t2 - t0});
    std::vector<peers::Touching> touches;
    for (std::size_t k = 0; k < w.touches.size(); ++k) touches.push_back(touching(w.touches[k], feedback[k], s.step));
    natural_maps.push_back(peers::natural_map(s, before, states(), touches));
    for (const auto& touch : w.touches) {
      contacts += 1;
      penetration = std::max(penetration, static_cast<double>(touch.contact.geom.depth));
    }
  }
  peers::print_row("ode", s.floes.size(), sweeps, window, contacts / static_cast<double>(window.size()),
                   penetration / s.thickness, natural_maps);
  dCloseODE();
}
