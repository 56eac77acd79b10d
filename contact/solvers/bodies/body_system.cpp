#include "contact/solvers/bodies/body_system.h"

#include "contact/problem/row_of.h"

namespace nilas::solvers {

namespace {

std::vector<double> inverse_masses_of_bodies(const contact::PreparedProblem& island) {
  std::vector<double> d = island.inverse_mass_scales();
  for (std::size_t c = 0; c < d.size(); ++c)
    d[c] += (island.problem().compliance[c] + 2 * island.problem().tangential_compliance[c]) / 3;
  return d;
}

/// J z_free + w
VecX free_contact_velocities(const BodyIsland& bodies) {
  ContactVectors u(static_cast<std::size_t>(bodies.num_contacts()));
  bodies.relative_velocities(bodies.free_motion(), u);
  return by_contact(u) + by_contact(bodies.prescribed());
}

}  // namespace

BodySystem::BodySystem(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan)
    : NewtonSystem(island.problem(), inverse_masses_of_bodies(island), island.inverse_mass_scales(),
                   free_contact_velocities(bodies), false, bodies.threads()),
      island_(island),
      bodies_(bodies),
      lu_(bodies, plan),
      g_(slopes().size()),
      by_motion_(slopes().size()) {}

/// z += sum J'^T r'
void BodySystem::moved(const VecX& r, NodeVector& z) const {
  ContactVectors scaled(static_cast<std::size_t>(num_contacts()));
  for_contacts([&](int c) { scaled.set(c, scale(c) * r.segment<3>(contact::row_of(c))); });
  bodies_.add_impulses(scaled, z);
}

/// J' z
VecX BodySystem::seen(const NodeVector& z) const {
  ContactVectors u(static_cast<std::size_t>(num_contacts()));
  bodies_.relative_velocities(z, u);
  VecX out(contact::row_of(num_contacts()));
  for_contacts([&](int c) { out.segment<3>(contact::row_of(c)) = scale(c) * u.at(c); });
  return out;
}

/// C of a contact, scaled.
Vec3 BodySystem::compliance(int c) const {
  const contact::ContactProblem& problem = island_.problem();
  const double tangential = problem.tangential_compliance[c];
  return scale(c) * scale(c) * Vec3(problem.compliance[c], tangential, tangential);
}

VecX BodySystem::product(const VecX& r) const {
  NodeVector z(static_cast<std::size_t>(bodies_.num_nodes()));
  moved(r, z);
  VecX out = seen(z);
  for_contacts([&](int c) {
    out.segment<3>(contact::row_of(c)) += compliance(c).cwiseProduct(r.segment<3>(contact::row_of(c)));
  });
  return out;
}

bool BodySystem::step(double weight, const VecX& r, VecX& dr) {
  const auto& laws = slopes();
  VecX push(r.size());  // impulses that the step has without moving anything
  for_contacts([&](int c) {
    const Eigen::Index row = contact::row_of(c);
    if (laws[c].open) {
      push.segment<3>(row) = -r.segment<3>(row);
      g_[c] = by_motion_[c] = Mat3::Zero();
      return;
    }
    Mat3 k = weight * laws[c].by_velocity + laws[c].by_impulse;
    k += laws[c].by_velocity * compliance(c).asDiagonal();
    const Mat3 inverse = k.inverse();
    by_motion_[c] = inverse * laws[c].by_velocity;
    push.segment<3>(row) = -inverse * laws[c].value;
    g_[c] = scale(c) * scale(c) * by_motion_[c];
  });
  if (!push.allFinite() || !lu_.factor(g_)) return false;
  NodeVector z(static_cast<std::size_t>(bodies_.num_nodes()));
  moved(push, z);
  lu_.solve(z);
  const VecX motion = seen(z);
  dr = push;
  for_contacts([&](int c) {
    if (!laws[c].open) dr.segment<3>(contact::row_of(c)) -= by_motion_[c] * motion.segment<3>(contact::row_of(c));
  });
  return dr.allFinite();
}

}  // namespace nilas::solvers
