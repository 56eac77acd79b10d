#include "core/sim/step/move.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/position_correction.h"
#include "contact/problem/row_of.h"
#include "core/sim/step/advance.h"
#include "core/sim/step/fast_bodies.h"

namespace nilas::sim {

namespace {

void add_couples(const contact::AssembledContacts& contacts, const contact::ContactSolution& solution,
                 contact::StepMotion& motion) {
  motion.couples.assign(motion.points.size(), Vec3::Zero());
  for (std::size_t c = motion.points.size(); c < contacts.C.size(); ++c)
    motion.couples[contacts.problem.moments[c].contact] = contacts.C[c] * solution.r.segment<3>(contact::row_of(c));
}

/// The largest tangential impulse of a contact; of a polygon that of the inscribed circle.
double friction_bound(const contact::ContactProblem& problem, std::size_t c, const Vec3& r) {
  const double bound = problem.mu[c] * r[0];
  return problem.law == Law::pyramid_k ? bound * std::cos(k_pi / problem.facets) : bound;
}

/// The springs after the solution, whose u holds their biases.
void add_springs(const SolvedContacts& solved, contact::StepMotion& motion) {
  const contact::AssembledContacts& contacts = solved.contacts;
  motion.springs.resize(contacts.springs.size());
  for (std::size_t i = 0; i < contacts.springs.size(); ++i) {
    if (!contacts.is_elastic(i)) continue;
    const contact::Spring& spring = contacts.springs[i];
    const double gap = motion.points[i].gap;
    const Vec3 r = solved.solution.r.segment<3>(contact::row_of(i));
    const Vec3 u = solved.solution.u.segment<3>(contact::row_of(i)) -
                   contact::spring_row(spring, gap, contacts.C[i], motion.h).bias;
    motion.springs[i] = contact::spring_step(spring, gap, contacts.C[i], motion.h, r, u,
                                             friction_bound(contacts.problem, i, r), solved.d[i]);
  }
}

contact::StepMotion velocity_step(const World& world, const Loads& loads, const Substep& substep,
                                  SolvedContacts& solved, const VesselStart& vessel) {
  const bodies::Bodies& bodies = world.parts.bodies;
  const contact::AssembledContacts& contacts = solved.contacts;
  contact::StepMotion motion;
  motion.h = substep.h;
  motion.p = bodies.p_GB;
  motion.R = bodies.R_GB;
  motion.before = {bodies.v_GB, bodies.w_GB};
  if (is_booked_whole(world.parts)) {
    const auto hull = static_cast<std::size_t>(world.parts.vessel_index);
    motion.before.v[hull] = vessel.v;
    motion.before.w[hull] = vessel.w;
  }
  motion.points = std::move(solved.found.points);
  motion.impulses.reserve(motion.points.size());
  motion.normal_impulses.reserve(motion.points.size());
  for (std::size_t i = 0; i < motion.points.size(); ++i) {
    const Vec3 r = solved.solution.r.segment<3>(contact::row_of(i));
    motion.impulses.emplace_back(contacts.C[i] * r);
    motion.normal_impulses.emplace_back(contacts.C[i].col(0) * r[0]);
  }
  motion.speed_asked = contacts.speed_asked;
  add_springs(solved, motion);
  if (contacts.problem.has_moments()) add_couples(contacts, solved.solution, motion);
  motion.after = new_velocities(world, contacts, solved.solution, loads, substep.h);
  return motion;
}

/// The contact points at the substep's end. Those of round parts are where the surfaces touch then, because the point
/// that touched before has turned away. Those of fast pairs are where they were found, because the bodies' rotation
/// would carry them elsewhere.
std::vector<detect::ContactPoint> points_at_the_end(World& world, const Substep& substep, const FoundContacts& found,
                                                    const contact::StepMotion& motion) {
  const bodies::Bodies& bodies = world.parts.bodies;
  std::vector<detect::ContactPoint> points = contact::carried_points(motion, bodies);
  world.detector.measure_round(bodies, points);
  const detect::FastMotion after{motion.after.v, motion.after.w, substep.h};
  if (world.model.detection != Detection::continuous) return points;
  if (found.met_on_path.empty() && !detect::any_fast(bodies, after, world.width, k_fast_share)) return points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const detect::ContactPoint& start = motion.points[i];
    const bool met =
        std::find(found.met_on_path.begin(), found.met_on_path.end(), start.key) != found.met_on_path.end();
    if (!met && !detect::is_fast(bodies, after, world.width, k_fast_share, start.a, start.b)) continue;
    points[i] = start;
    points[i].gap = std::min(start.gap, 0.0);
  }
  return points;
}

/// Sets the gap of points to zero that their own motion closes: lifted out as well, a deep point would gain height in
/// every bounce.
void leave_to_their_motion(const contact::StepMotion& motion, std::vector<detect::ContactPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double speed = points[i].n.dot(contact::relative_velocity(motion, motion.after, i));
    if (points[i].gap < 0 && speed * motion.h >= -points[i].gap) points[i].gap = 0;
  }
}

}  // namespace

contact::StepMotion move(World& world, Loads& loads, const Substep& substep, SolvedContacts& solved,
                         const VesselStart& vessel) {
  contact::StepMotion motion = velocity_step(world, loads, substep, solved, vessel);
  if (world.elastic) world.elastic->keep(world.parts.bodies, motion.points, solved.contacts.springs, motion.springs);
  advance(world.parts.bodies, motion.after, world.model.theta * substep.h, world.gyroscopic, world.threads);
  finish_vessel_step(world, loads, motion);
  return motion;
}

CorrectedPositions correct_positions(World& world, const Substep& substep, const SolvedContacts& solved,
                                     const contact::StepMotion& motion) {
  const ContactModel& model = world.model;
  if (model.position_step == PositionStep::none) return {};
  contact::Velocities pseudo{std::vector<Vec3>(world.size(), Vec3::Zero()),
                             std::vector<Vec3>(world.size(), Vec3::Zero())};
  std::vector<detect::ContactPoint> points = model.position_step == PositionStep::projection
                                                 ? points_at_the_end(world, substep, solved.found, motion)
                                                 : motion.points;
  if (model.hit_when_met) leave_to_their_motion(motion, points);
  const contact::PositionCorrection done =
      contact::correction_velocities(solved.contacts, points, model.correction_over(substep.h), pseudo.v, pseudo.w);
  displace(world.parts.bodies, pseudo, substep.h);
  return {std::move(pseudo), done.converged};
}

}  // namespace nilas::sim
