#include "contact/assemble.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "contact/detect/broad/contact_key.h"
#include "contact/law/contact_frame.h"
#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::contact {

namespace {

using TwistRows = Eigen::Matrix<double, 3, 6, Eigen::RowMajor>;

constexpr int k_free_size = 6;

class Assembly {
 public:
  Assembly(const bodies::Bodies& bodies, const bodies::Wrenches& free, const AssemblySettings& settings,
           const std::vector<ArticulatedBlock>& articulated)
      : bodies_(bodies), free_(free), settings_(settings), articulated_(articulated) {
    NILAS_DEMAND(settings.h > 0);
    NILAS_DEMAND(free.size() == bodies.id.size());
    out_.block_of_body.assign(bodies.id.size(), -1);
    out_.problem.h = settings.h;
    out_.problem.law = settings.law;
    out_.problem.facets = settings.facets;
  }

  AssembledContacts build(const std::vector<detect::ContactPoint>& points, const FrictionPairs& friction,
                          std::vector<Spring> springs) {
    NILAS_DEMAND(springs.empty() || springs.size() == points.size());
    out_.springs = std::move(springs);
    add_blocks(points);
    reserve_contacts(points.size());
    for (const auto& point : points) add_contact(point, friction);
    if (settings_.law != Law::frictionless && friction.any_moments())
      for (std::size_t c = 0; c < points.size(); ++c) add_moment(static_cast<int>(c), points[c], friction);
    return std::move(out_);
  }

 private:
  /// The articulated system that a body belongs to, and its entry there.
  std::pair<const ArticulatedBlock*, const ArticulatedBody*> articulated(int body) const {
    for (const auto& block : articulated_)
      for (const auto& one : block.bodies)
        if (one.body == body) return {&block, &one};
    return {nullptr, nullptr};
  }

  void add_blocks(const std::vector<detect::ContactPoint>& points);
  int place_block(int size);
  void fill_free_block(int body);
  void fill_articulated_block(const ArticulatedBlock& articulated, std::size_t block);
  void reserve_contacts(std::size_t count);
  const FrictionPair& friction_of(const detect::ContactPoint& point, const FrictionPairs& friction) const;
  void add_contact(const detect::ContactPoint& point, const FrictionPairs& friction);
  void add_moment(int c, const detect::ContactPoint& point, const FrictionPairs& friction);
  MatX moment_rows(int body, const Mat3& C, double sign, Vec3& w) const;
  Vec3 add_side(int body, const Mat3& C, const Vec3& p, double sign);
  bool are_joined(const detect::ContactPoint& point) const;
  TwistRows twist_rows(int body, const Mat3& C, const Vec3& p, double sign) const;
  Vec3 add_joined_sides(const detect::ContactPoint& point, const Mat3& C);
  Vec3 point_velocity(int body, const Vec3& p) const;
  std::optional<double> bounce(const detect::ContactPoint& point, double restitution) const;
  double speed_asked(const detect::ContactPoint& point) const;

  const bodies::Bodies& bodies_;
  const bodies::Wrenches& free_;
  const AssemblySettings& settings_;
  const std::vector<ArticulatedBlock>& articulated_;
  AssembledContacts out_;
};

int Assembly::place_block(int size) {
  ContactProblem& problem = out_.problem;
  problem.block_offset.push_back(problem.block_offset.back() + size);
  problem.mass_offset.push_back(problem.mass_offset.back() +
                                static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  return problem.num_blocks() - 1;
}

void Assembly::add_blocks(const std::vector<detect::ContactPoint>& points) {
  std::vector<char> touched(bodies_.id.size(), 0);
  for (const auto& point : points)
    for (const int body : {point.a, point.b}) {
      NILAS_DEMAND(body >= 0 && body < bodies_.size());
      touched[body] = 1;
    }
  std::vector<int> free_bodies;
  std::vector<const ArticulatedBlock*> moved;
  for (int body = 0; body < bodies_.size(); ++body) {
    const auto i = static_cast<std::size_t>(body);
    if (touched[i] == 0 || bodies_.motion[i] == bodies::Motion::fixed) continue;
    if (bodies_.is_free(body)) {
      free_bodies.push_back(body);
      continue;
    }
    const ArticulatedBlock* const block = articulated(body).first;
    NILAS_DEMAND(block != nullptr);
    if (block->f.size() > 0 && std::find(moved.begin(), moved.end(), block) == moved.end()) moved.push_back(block);
  }
  for (const int body : free_bodies) out_.block_of_body[body] = place_block(k_free_size);
  out_.first_articulated_block = out_.problem.num_blocks();
  for (const auto* block : moved) {
    const int place = place_block(static_cast<int>(block->f.size()));
    for (const auto& one : block->bodies)
      if (bodies_.motion[one.body] != bodies::Motion::fixed) out_.block_of_body[one.body] = place;
  }

  out_.problem.mass_data.assign(out_.problem.mass_offset.back(), 0.0);
  out_.problem.f.resize(out_.problem.num_velocities());
  for (const int body : free_bodies) fill_free_block(body);
  for (std::size_t k = 0; k < moved.size(); ++k)
    fill_articulated_block(*moved[k], static_cast<std::size_t>(out_.first_articulated_block) + k);
}

void Assembly::fill_free_block(int body) {
  const auto i = static_cast<std::size_t>(body);
  const auto block = static_cast<std::size_t>(out_.block_of_body[i]);
  const Mat3 inertia = bodies_.inertia_G(body);
  Eigen::Map<Mat6> mass(out_.problem.mass_data.data() + out_.problem.mass_offset[block]);
  mass.diagonal().head<3>().setConstant(bodies_.mass[i]);
  mass.bottomRightCorner<3, 3>() = inertia;
  auto f = out_.problem.f.segment<k_free_size>(out_.problem.block_offset[block]);
  f.head<3>() = bodies_.mass[i] * bodies_.v_GB[i] + settings_.h * free_[i].force;
  f.tail<3>() = inertia * bodies_.w_GB[i] + settings_.h * free_[i].torque;
  if (!bodies_.has_added_mass()) return;
  const Mat6 added = bodies_.added_mass_G(body);
  Vec6 twist;
  twist << bodies_.v_GB[i], bodies_.w_GB[i];
  mass += added;
  f += added * twist;
}

void Assembly::fill_articulated_block(const ArticulatedBlock& articulated, std::size_t block) {
  const auto n = articulated.f.size();
  NILAS_DEMAND(articulated.mass.rows() == n && articulated.mass.cols() == n);
  for (const auto& one : articulated.bodies)
    NILAS_DEMAND(one.jacobian.cols() == n && one.jacobian.rows() == k_free_size);
  Eigen::Map<MatX>(out_.problem.mass_data.data() + out_.problem.mass_offset[block], n, n) = articulated.mass;
  out_.problem.f.segment(out_.problem.block_offset[block], n) = articulated.f;
}

void Assembly::reserve_contacts(std::size_t count) {
  ContactProblem& problem = out_.problem;
  problem.w.resize(row_of(count));
  problem.pairs.reserve(count);
  problem.jacobian_offset.reserve(count + 1);
  problem.jacobian_data.reserve(2 * sizeof(TwistRows) / sizeof(double) * count);
  problem.mu.reserve(count);
  problem.mu_static.reserve(count);
  problem.key.reserve(count);
  problem.force_limit.reserve(count);
  problem.compliance.reserve(count);
  problem.tangential_compliance.reserve(count);
  out_.C.reserve(count);
  out_.speed_asked.reserve(count);
}

/// The rows of sign * u = C^T (v + w x r), where r leads from the centre of mass to p.
TwistRows Assembly::twist_rows(int body, const Mat3& C, const Vec3& p, double sign) const {
  TwistRows rows;
  const Vec3 r = p - bodies_.p_GB[body];
  for (int k = 0; k < 3; ++k) rows.row(k) << sign * C.col(k).transpose(), sign * r.cross(C.col(k)).transpose();
  return rows;
}

/// Appends the rows of one side of a contact at p. Returns what the body's prescribed motion adds to u.
Vec3 Assembly::add_side(int body, const Mat3& C, const Vec3& p, double sign) {
  if (bodies_.motion[body] == bodies::Motion::fixed) return Vec3::Zero();
  const TwistRows rows = twist_rows(body, C, p, sign);
  std::vector<double>& data = out_.problem.jacobian_data;
  if (bodies_.is_free(body)) {
    data.insert(data.end(), rows.data(), rows.data() + rows.size());
    return Vec3::Zero();
  }
  const auto [block, one] = articulated(body);
  if (block->f.size() > 0) {
    const ContactProblem::RowMajor reduced = rows * one->jacobian;
    data.insert(data.end(), reduced.data(), reduced.data() + reduced.size());
  }
  return rows * one->prescribed;
}

/// Whether both bodies have the same block.
bool Assembly::are_joined(const detect::ContactPoint& point) const {
  const int a = out_.block_of_body[point.a];
  return a >= 0 && a == out_.block_of_body[point.b];
}

/// Appends the rows of a contact between two bodies of one system. Returns what their prescribed motion adds to u.
Vec3 Assembly::add_joined_sides(const detect::ContactPoint& point, const Mat3& C) {
  const ArticulatedBody &a = *articulated(point.a).second, &b = *articulated(point.b).second;
  const TwistRows on_a = twist_rows(point.a, C, point.p, -1), on_b = twist_rows(point.b, C, point.p, 1);
  const ContactProblem::RowMajor reduced = on_a * a.jacobian + on_b * b.jacobian;
  std::vector<double>& data = out_.problem.jacobian_data;
  data.insert(data.end(), reduced.data(), reduced.data() + reduced.size());
  return on_a * a.prescribed + on_b * b.prescribed;
}

Vec3 Assembly::point_velocity(int body, const Vec3& p) const {
  const auto i = static_cast<std::size_t>(body);
  if (bodies_.motion[i] == bodies::Motion::fixed) return Vec3::Zero();
  return bodies_.v_GB[i] + bodies_.w_GB[i].cross(p - bodies_.p_GB[i]);
}

std::optional<double> Assembly::bounce(const detect::ContactPoint& point, double restitution) const {
  if (!(restitution > 0) || point.crushes()) return std::nullopt;
  const double before = point.n.dot(point_velocity(point.b, point.p) - point_velocity(point.a, point.p));
  const bool closes = point.gap <= 0 || before * settings_.h < -point.gap;
  if (!closes || before >= -settings_.restitution_threshold) return std::nullopt;
  return restitution * before;
}

double Assembly::speed_asked(const detect::ContactPoint& point) const {
  const VelocityStabilisation& stabilisation = settings_.stabilisation;
  const double excess = -point.gap - stabilisation.slop;
  return excess > 0 ? std::min(stabilisation.erp * excess / settings_.h, stabilisation.max_speed) : 0;
}

const FrictionPair& Assembly::friction_of(const detect::ContactPoint& point, const FrictionPairs& friction) const {
  return friction.of(bodies_.material[point.a], bodies_.material[point.b]);
}

void Assembly::add_contact(const detect::ContactPoint& point, const FrictionPairs& friction) {
  const auto a = static_cast<std::size_t>(point.a), b = static_cast<std::size_t>(point.b);
  ContactProblem& problem = out_.problem;
  const Mat3 C = contact_frame(point.n, bodies_.R_GB[a], settings_.axes);
  const FrictionPair& pair = friction_of(point, friction);

  const bool joined = are_joined(point);
  Vec3 w = joined ? add_joined_sides(point, C) : add_side(point.a, C, point.p, -1);
  if (!joined) w += add_side(point.b, C, point.p, 1);
  double asked = 0;
  SpringRow row;
  const std::size_t c = problem.pairs.size();
  if (out_.is_elastic(c))
    w += (row = spring_row(out_.springs[c], point.gap, C, settings_.h)).bias;
  else if (const auto bounced = bounce(point, pair.restitution))
    w[0] += *bounced;
  else if (point.gap > 0)
    w[0] += point.gap / settings_.h;
  else
    w[0] -= asked = speed_asked(point);
  out_.speed_asked.push_back(asked);
  problem.w.segment<3>(row_of(problem.pairs.size())) = w;
  problem.pairs.push_back({joined ? -1 : out_.block_of_body[a], out_.block_of_body[b]});
  problem.jacobian_offset.push_back(problem.jacobian_data.size());
  problem.force_limit.push_back(point.force_limit * settings_.h);
  problem.compliance.push_back(point.compliance + row.compliance);
  problem.tangential_compliance.push_back(row.tangential_compliance);
  problem.mu.push_back(pair.mu_kinetic);
  problem.mu_static.push_back(pair.mu_static);
  problem.key.push_back(point.key);
  out_.C.push_back(C);
}

/// The rows of u = C^T w for one side, with n columns. Adds the contribution of its prescribed motion to `w`.
MatX Assembly::moment_rows(int body, const Mat3& C, double sign, Vec3& w) const {
  const auto i = static_cast<std::size_t>(body);
  if (bodies_.motion[i] == bodies::Motion::fixed) return MatX(3, 0);
  TwistRows rows = TwistRows::Zero();
  rows.rightCols<3>() = sign * C.transpose();
  if (bodies_.is_free(body)) return rows;
  const ArticulatedBody& one = *articulated(body).second;
  w += rows * one.prescribed;
  return rows * one.jacobian;
}

void Assembly::add_moment(int c, const detect::ContactPoint& point, const FrictionPairs& friction) {
  const FrictionPair& pair = friction_of(point, friction);
  if (pair.rolling == 0 && pair.spinning == 0) return;
  const Mat3 C = out_.C[c] * Vec3(pair.spinning, pair.rolling, pair.rolling).asDiagonal();
  Vec3 w = Vec3::Zero();
  MatX rows_a = moment_rows(point.a, C, -1, w), rows_b = moment_rows(point.b, C, 1, w);
  if (are_joined(point)) {
    rows_b += rows_a;
    rows_a = MatX(3, 0);
  }
  constexpr std::uint64_t k_moment = 0x6d6f6d656e74;  // keeps the key of a moment distinct from the keys of features
  out_.problem.add_moment(c, rows_a, rows_b, pair.rolling, detect::mix(point.key, k_moment));
  out_.problem.w.tail<3>() = w;
  out_.C.push_back(C);
}

}  // namespace

AssembledContacts assemble(const bodies::Bodies& bodies, const bodies::Wrenches& free,
                           const std::vector<detect::ContactPoint>& points, const FrictionPairs& friction,
                           const AssemblySettings& settings, const std::vector<ArticulatedBlock>& articulated,
                           std::vector<Spring> springs) {
  return Assembly(bodies, free, settings, articulated).build(points, friction, std::move(springs));
}

}  // namespace nilas::contact
