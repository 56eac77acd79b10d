#include "core/sim/reference/reference_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/assemble.h"
#include "contact/law/contact_frame.h"
#include "contact/measure/measure.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::sim {

namespace {

/// Rate at which gap and speed of closed contacts are drawn back, against drift by rounding [1/s].
constexpr double k_drift_rate = 10;
/// Reverse slip above this speed ends a state that began at rest; below it is rounding [m/s].
constexpr double k_slip_slack = 1e-11;

/// Twist rates (v', w') under loads alone of the bodies that move; zero for the others.
std::vector<Vec6> free_accelerations(const bodies::Bodies& bodies, const bodies::Wrenches& loads,
                                     const ReferenceVessel* vessel) {
  std::vector<Vec6> rates(loads.size(), Vec6::Zero());
  for (int k = 0; k < bodies.size(); ++k) {
    if (!bodies.is_free(k)) continue;
    const auto b = static_cast<std::size_t>(k);
    const Vec3& w = bodies.w_GB[b];
    rates[b].head<3>() = loads[b].force / bodies.mass[b];
    rates[b].tail<3>() = bodies.inertia_inverse_G(k) * (loads[b].torque - w.cross(bodies.inertia_G(k) * w));
  }
  if (vessel == nullptr) return rates;
  const VecX accelerations = vessel->accelerations(loads);
  for (int k = vessel->hull(); vessel->holds(k); ++k)
    if (bodies.moves(k)) rates[k] = vessel->twist_rate(k, accelerations);
  return rates;
}

/// One row of relative acceleration, or one direction of force, at a contact: its components for both bodies.
struct Direction {
  std::size_t a = 0, b = 0;
  Vec6 on_a, on_b;
  VecX on_vessel;  ///< component in the vessel's speeds; empty where neither body belongs to it
};

Direction direction(const bodies::Bodies& bodies, const detect::ContactPoint& c, const Vec3& d,
                    const ReferenceVessel* vessel) {
  Direction out;
  out.a = static_cast<std::size_t>(c.a);
  out.b = static_cast<std::size_t>(c.b);
  out.on_a << -d, -(c.p - bodies.p_GB[out.a]).cross(d);
  out.on_b << d, (c.p - bodies.p_GB[out.b]).cross(d);
  if (vessel == nullptr || !(vessel->holds(c.a) || vessel->holds(c.b))) return out;
  out.on_vessel = VecX::Zero(vessel->speeds().size());
  if (vessel->holds(c.a)) out.on_vessel += vessel->generalised(c.a, out.on_a);
  if (vessel->holds(c.b)) out.on_vessel += vessel->generalised(c.b, out.on_b);
  return out;
}

Vec6 response(const bodies::Bodies& bodies, std::size_t b, const Vec6& load) {
  const int k = static_cast<int>(b);
  Vec6 out = Vec6::Zero();
  if (!bodies.is_free(k)) return out;
  out << load.head<3>() / bodies.mass[b], bodies.inertia_inverse_G(k) * load.tail<3>();
  return out;
}

/// Delassus matrix: accelerations along `rows` per unit force along `columns`.
MatX delassus(const bodies::Bodies& bodies, const std::vector<Direction>& rows, const std::vector<Direction>& columns,
              const ReferenceVessel* vessel) {
  const auto size = static_cast<Eigen::Index>(rows.size());
  MatX W = MatX::Zero(size, size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Direction& column = columns[j];
    const Vec6 at_a = response(bodies, column.a, column.on_a), at_b = response(bodies, column.b, column.on_b);
    const VecX of_vessel = column.on_vessel.size() > 0 ? vessel->response(column.on_vessel) : VecX();
    for (Eigen::Index i = 0; i < size; ++i) {
      const Direction& row = rows[i];
      if (row.a == column.a) W(i, j) += row.on_a.dot(at_a);
      if (row.a == column.b) W(i, j) += row.on_a.dot(at_b);
      if (row.b == column.a) W(i, j) += row.on_b.dot(at_a);
      if (row.b == column.b) W(i, j) += row.on_b.dot(at_b);
      if (row.on_vessel.size() > 0 && of_vessel.size() > 0) W(i, j) += row.on_vessel.dot(of_vessel);
    }
  }
  return W;
}

/// The solution of smallest norm: there may be more contact forces than degrees of freedom.
VecX smallest_solution(const MatX& W, const VecX& needed) {
  Eigen::CompleteOrthogonalDecomposition<MatX> decomposition(W.rows(), W.cols());
  constexpr double k_rank = 1e-10;
  decomposition.setThreshold(k_rank);
  decomposition.compute(W);
  return decomposition.solve(needed);
}

/// A contact that carries `force` by the law. It slips if it slips already or friction is at its limit.
SustainedContact bearing(const detect::ContactPoint& point, const Vec3& force, const Mat3& frame, const Vec3& slip,
                         const contact::FrictionPair& pair) {
  SustainedContact contact;
  contact.key = point.key;
  contact.point = point;
  contact.a = point.a;
  contact.b = point.b;
  contact.mu_static = pair.mu_static;
  contact.mu_kinetic = pair.mu_kinetic;
  contact.force = force;
  constexpr double k_limit = 1 - 1e-8;
  const double tangential = force.tail<2>().norm();
  if (!slip.isZero(0))
    contact.slip_axis = slip;
  else if (tangential < k_limit * pair.mu_static * force[0])
    contact.grip = Grip::sticks;
  else
    contact.slip_axis = tangential > 0 ? Vec3(frame.rightCols<2>() * force.tail<2>() / -tangential) : frame.col(1);
  return contact;
}

/// Direction of the slip. It is slip_axis where there is no slip yet, and stays smooth beyond a stop.
Vec3 slip_direction(const SustainedContact& contact, const ContactKinematics& at) {
  const Vec3 n = at.frame.col(0);
  const Vec3 slip = at.velocity - n.dot(at.velocity) * n;
  constexpr double k_least_slip = 1e-12;  // [m/s] below it a direction is rounding
  const double speed = slip.norm();
  if (speed < k_least_slip) return contact.slip_axis;
  return (slip.dot(contact.slip_axis) < 0 ? -1 : 1) / speed * slip;
}

}  // namespace

void note_changes(double t, const std::vector<SustainedContact>& before, const std::vector<SustainedContact>& after,
                  std::vector<ContactEvent>& events) {
  const auto in = [](const std::vector<SustainedContact>& list, std::uint64_t key) {
    return std::find_if(list.begin(), list.end(), [&](const SustainedContact& c) { return c.key == key; });
  };
  for (const auto& contact : after) {
    const auto old = in(before, contact.key);
    if (old == before.end())
      events.push_back({t, ContactEventKind::rest, contact.a, contact.b, 0});
    else if (old->grip != contact.grip)
      events.push_back({t, contact.grip == Grip::sticks ? ContactEventKind::stick : ContactEventKind::slip, contact.a,
                        contact.b, 0});
  }
  for (const auto& contact : before)
    if (in(after, contact.key) == after.end())
      events.push_back({t, ContactEventKind::release, contact.a, contact.b, 0});
}

SustainedContacts::SustainedContacts(const contact::FrictionPairs& friction,
                                     std::unique_ptr<solvers::ContactSolver> solver, bool frictionless,
                                     double rest_speed, ReferenceVessel* vessel, detect::PairFilter joined)
    : friction_(friction),
      solver_(std::move(solver)),
      frictionless_(frictionless),
      rest_speed_(rest_speed),
      vessel_(vessel),
      joined_(std::move(joined)) {}

std::vector<ContactKinematics> SustainedContacts::kinematics(bodies::Bodies& bodies,
                                                             const std::vector<detect::ContactPoint>& began) {
  std::vector<std::uint64_t> keys;
  for (const auto& point : began) keys.push_back(point.key);
  auto out = follow_contacts(bodies, keys, [this](const bodies::Bodies& moved) { return detect(moved); });
  for (std::size_t i = 0; i < out.size(); ++i) {
    ContactKinematics& at = out[i];
    if (!at.found) continue;
    at.bias += 2 * k_drift_rate * (at.frame.transpose() * at.velocity);
    // An overlap from the start stays: to draw it out would be work without an account.
    const double kept = began[i].gap < -k_reference_touch ? began[i].gap : 0;
    at.bias[0] += k_drift_rate * k_drift_rate * (at.point.gap - kept);
  }
  return out;
}

/// The contact problem of the accelerations: M a = f + H r, u = H^T a + b. A contact that slips already gets its
/// direction from a component of u far above any acceleration.
AccelerationProblem SustainedContacts::pose(bodies::Bodies& bodies, const bodies::Wrenches& loads,
                                            const std::vector<detect::ContactPoint>& points) {
  contact::AssemblySettings settings;
  settings.h = 1;  // the problem's impulses over one second are forces, its speeds accelerations
  settings.law = frictionless_ ? Law::frictionless : Law::coulomb;
  settings.restitution_threshold = std::numeric_limits<double>::infinity();
  std::vector<contact::ArticulatedBlock> vessel;
  if (vessel_ != nullptr) vessel.push_back(vessel_->block(vessel_->accelerations(loads)));
  AccelerationProblem out{contact::assemble(bodies, loads, points, friction_, settings, vessel), {}, 0};
  contact::ContactProblem& problem = out.contacts.problem;
  const auto rates = free_accelerations(bodies, loads, vessel_);
  for (std::size_t b = 0; b < rates.size(); ++b) {
    const int block = out.contacts.block_of_body[b];
    if (block >= 0 && bodies.is_free(static_cast<int>(b)))
      problem.f.segment<6>(problem.block_offset[block]) = problem.mass(block) * rates[b];
  }
  const auto at = kinematics(bodies, points);
  for (std::size_t i = 0; i < at.size(); ++i) problem.w.segment<3>(contact::row_of(i)) = at[i].bias;
  if (vessel_ != nullptr)
    for (std::size_t i = 0; i < at.size(); ++i)
      problem.w.segment<3>(contact::row_of(i)) += vessel_bias(bodies, points[i], out.contacts.C[i]);
  const VecX free = contact::velocities(problem, VecX::Zero(problem.w.size()));
  out.scale = contact::contact_velocities(problem, free).lpNorm<Eigen::Infinity>();
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Vec3 n = at[i].frame.col(0);
    out.slip.emplace_back(at[i].velocity - n.dot(at[i].velocity) * n);
    const double speed = out.slip[i].norm();
    if (speed <= rest_speed_) {
      out.slip[i].setZero();
      problem.mu[i] = problem.mu_static[i];
      continue;
    }
    out.slip[i] /= speed;
    constexpr double k_far_above = 1e6;
    problem.w.segment<3>(contact::row_of(i)) += k_far_above * out.scale * (out.contacts.C[i].transpose() * out.slip[i]);
  }
  return out;
}

/// Relative acceleration, in the axes of C, that the rotation of the vessel's joints causes at constant joint speeds.
Vec3 SustainedContacts::vessel_bias(const bodies::Bodies& bodies, const detect::ContactPoint& c, const Mat3& C) const {
  Vec3 sum = Vec3::Zero();
  for (const auto& [body, sign] : {std::pair(c.a, -1.0), std::pair(c.b, 1.0)}) {
    if (!vessel_->holds(body) || !bodies.moves(body)) continue;
    const Vec6 bias = vessel_->bias(body);
    sum += sign * (bias.head<3>() + bias.tail<3>().cross(c.p - bodies.p_GB[body]));
  }
  return C.transpose() * sum;
}

void SustainedContacts::decide(bodies::Bodies& bodies, const bodies::Wrenches& loads,
                               const std::vector<detect::ContactPoint>& points, double t) {
  list_.clear();
  trusted_ = false;
  if (points.empty()) return;
  if (static_cast<int>(points.size()) > k_most_reference_contacts)
    throw SimulationError(fmt::format(
        "at {:g} s {} contacts are closed at once; integrator 'reference' takes {}: use moreau or semi-implicit-euler",
        t, points.size(), k_most_reference_contacts));
  const AccelerationProblem posed = pose(bodies, loads, points);
  constexpr double k_least_acceleration = 1e-10;  // [m/s^2] below it nothing is pressed together
  if (!(posed.scale > k_least_acceleration)) return;
  const contact::ContactProblem& problem = posed.contacts.problem;
  const contact::ContactSolution solution = solver_->solve(problem, {});
  const double residual = contact::measure(problem, solution.r, solution.v).law_map_m_s;
  constexpr double k_accepted = 1e-6;  // share of the largest acceleration
  if (!(residual <= k_accepted * posed.scale))
    throw SimulationError(fmt::format(
        "at {:g} s the forces of the closed contacts were not found ({}, residual {:.3g} m/s^2): the law may have no "
        "answer without an impulse (Painleve), or the solver is not apt",
        t, contact::to_string(solution.status), residual));
  const auto W = contact::delassus_diagonal(problem);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 r = solution.r.segment<3>(contact::row_of(i));
    constexpr double k_least_share = 1e-9;  // share of the largest acceleration
    if (r[0] * W[i](0, 0) > k_least_share * posed.scale + k_least_acceleration)
      list_.push_back(bearing(points[i], r, posed.contacts.C[i], posed.slip[i], friction_of(bodies, points[i])));
  }
}

contact::FrictionPair SustainedContacts::friction_of(const bodies::Bodies& bodies,
                                                     const detect::ContactPoint& point) const {
  if (frictionless_) return {};
  return friction_.of(bodies.material[point.a], bodies.material[point.b]);
}

SustainedForces SustainedContacts::forces(bodies::Bodies& bodies, const bodies::Wrenches& loads) {
  SustainedForces out;
  if (list_.empty()) return out;
  std::vector<detect::ContactPoint> began;
  for (const auto& contact : list_) began.push_back(contact.point);
  out.at = kinematics(bodies, began);
  out.force.assign(list_.size(), Vec3::Zero());
  std::vector<Direction> rows, columns;
  std::vector<std::pair<std::size_t, Eigen::Index>> place;  // contact and component of each unknown
  std::vector<double> bias, start;
  std::vector<Vec3> friction(list_.size(), Vec3::Zero());  // per newton of normal force
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const ContactKinematics& at = out.at[i];
    if (!at.found) continue;
    const bool sticks = list_[i].grip == Grip::sticks;
    if (!sticks) friction[i] = -list_[i].mu_kinetic * slip_direction(list_[i], at);
    for (Eigen::Index k = 0; k < (sticks ? 3 : 1); ++k) {
      rows.push_back(direction(bodies, at.point, at.frame.col(k), vessel_));
      columns.push_back(k == 0 ? direction(bodies, at.point, at.frame.col(0) + friction[i], vessel_) : rows.back());
      place.emplace_back(i, k);
      bias.push_back(at.bias[k]);
      start.push_back(list_[i].force[k]);
    }
  }
  const auto size = static_cast<Eigen::Index>(rows.size());
  if (size == 0) return out;
  const auto rates = free_accelerations(bodies, loads, vessel_);
  VecX needed(size), r(size);
  for (Eigen::Index j = 0; j < size; ++j) {
    const Direction& row = rows[j];
    needed[j] = -(row.on_a.dot(rates[row.a]) + row.on_b.dot(rates[row.b]) + bias[j]);
    r[j] = start[j];
  }
  // Of all possible distributions, take the one nearest to that of the law.
  const MatX W = delassus(bodies, rows, columns, vessel_);
  r += smallest_solution(W, needed - W * r);
  for (Eigen::Index j = 0; j < size; ++j) {
    const auto& [i, k] = place[j];
    if (k == 0)
      out.force[i] = out.at[i].frame.transpose() * (r[j] * (out.at[i].frame.col(0) + friction[i]));
    else
      out.force[i][k] = r[j];
    if (k == 0) out.friction_power -= r[j] * friction[i].dot(out.at[i].velocity);
  }
  return out;
}

ContactImpulses SustainedContacts::stop_creep(bodies::Bodies& bodies) const {
  ContactImpulses out;
  std::vector<Direction> rows;
  std::vector<double> speeds;
  std::vector<Vec3> axes;
  for (const auto& contact : list_) {
    const Mat3 frame = contact::contact_frame(contact.point.n, bodies.R_GB[contact.a], 0);
    for (Eigen::Index k = 0; k < (contact.grip == Grip::sticks ? 3 : 1); ++k) {
      rows.push_back(direction(bodies, contact.point, frame.col(k), vessel_));
      speeds.push_back(-frame.col(k).dot(velocity_between(bodies, contact.point)));
      axes.emplace_back(frame.col(k));
      out.points.push_back(contact.point);
    }
  }
  if (rows.empty()) return out;
  const VecX needed = Eigen::Map<const VecX>(speeds.data(), static_cast<Eigen::Index>(speeds.size()));
  const VecX r = smallest_solution(delassus(bodies, rows, rows, vessel_), needed);
  VecX of_vessel = vessel_ != nullptr ? VecX::Zero(vessel_->speeds().size()) : VecX();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double impulse = r[static_cast<Eigen::Index>(i)];
    out.impulses.emplace_back(impulse * axes[i]);
    const auto change = [&](std::size_t b, const Vec6& load) {
      const Vec6 twist = response(bodies, b, impulse * load);
      bodies.v_GB[b] += twist.head<3>();
      bodies.w_GB[b] += twist.tail<3>();
    };
    change(rows[i].a, rows[i].on_a);
    change(rows[i].b, rows[i].on_b);
    if (rows[i].on_vessel.size() > 0) of_vessel += impulse * vessel_->response(rows[i].on_vessel);
  }
  if (vessel_ != nullptr && !of_vessel.isZero(0)) vessel_->add_to_speeds(of_vessel, bodies);
  return out;
}

/// Normal speed above which a contact is another one than that which was closed [m/s]. Its point has then jumped, as
/// that of a rim does where the cap comes to lie flat.
double SustainedContacts::most_normal_speed(const ContactKinematics& at) const {
  return 2 * rest_speed_ + k_drift_rate * std::abs(at.point.gap);
}

void SustainedContacts::watch(const SustainedForces& forces, Eigen::Ref<VecX> out) const {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const auto row = 2 * static_cast<Eigen::Index>(i);
    const SustainedContact& contact = list_[i];
    const ContactKinematics& at = forces.at[i];
    const Vec3& force = forces.force[i];
    out[row] = -1;
    out[row + 1] = 1;
    if (!at.found) continue;
    out[row] = std::min(trusted_ ? 1 : force[0], most_normal_speed(at) - std::abs(at.point.n.dot(at.velocity)));
    if (contact.grip == Grip::sticks)
      out[row + 1] = trusted_ ? 1 : contact.mu_static * force[0] - force.tail<2>().norm();
    else if (contact.mu_static > 0)
      out[row + 1] = at.velocity.dot(contact.slip_axis) + k_slip_slack;
  }
}

void SustainedContacts::add(const SustainedForces& forces, const bodies::Bodies& bodies,
                            bodies::Wrenches& loads) const {
  for (std::size_t i = 0; i < list_.size(); ++i) {
    const detect::ContactPoint& c = forces.at[i].point;
    if (!forces.at[i].found) continue;
    const Vec3 force = forces.at[i].frame * forces.force[i];
    const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
    loads[a] += Wrench{-force, -(c.p - bodies.p_GB[a]).cross(force)};
    loads[b] += Wrench{force, (c.p - bodies.p_GB[b]).cross(force)};
  }
}

}  // namespace nilas::sim
