#include "contact/problem/mass_inverse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/problem/inverse_root.h"

namespace nilas::contact {

constexpr int k_rigid_size = 6;
/// Larger asymmetry of a block is not rounding, relative to its largest entry.
constexpr double k_rounding = 1e-14;

/// `largest`: entry of the block that m belongs to.
template <class Matrix>
static bool is_symmetric(const Matrix& m, double largest) {
  return (m - m.transpose()).cwiseAbs().maxCoeff() <= k_rounding * largest;
}

static bool is_rigid_body(const ContactProblem::ConstMatrix& mass) {
  if (mass.rows() != k_rigid_size) return false;
  const double m = mass(0, 0);
  for (int j = 0; j < k_rigid_size; ++j)
    for (int i = 0; i < k_rigid_size; ++i) {
      if (i >= 3 && j >= 3) continue;
      if (mass(i, j) != (i == j ? m : 0.0)) return false;
    }
  const Mat3 inertia = mass.bottomRightCorner<3, 3>();
  const double largest = std::max(std::abs(m), inertia.cwiseAbs().maxCoeff());
  return is_symmetric(inertia, largest);
}

/// Sylvester's criterion; false for NaN.
static bool is_positive_definite(const Mat3& a) {
  const double minor = a(0, 0) * a(1, 1) - a(1, 0) * a(0, 1);
  return a(0, 0) > 0 && minor > 0 && a.determinant() > 0;
}

MassInverse::MassInverse(const ContactProblem& problem) {
  slot_.reserve(static_cast<std::size_t>(problem.num_blocks()));
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto mass = problem.mass(k);
    if (is_rigid_body(mass))
      add_rigid_body(mass, k);
    else
      add_general(mass, k);
  }
}

void MassInverse::mark_bad(int block) {
  if (first_bad_block_ < 0) first_bad_block_ = block;
}

void MassInverse::add_rigid_body(const ContactProblem::ConstMatrix& mass, int block) {
  const Mat3 inertia = mass.bottomRightCorner<3, 3>(), root = inverse_root(inertia);
  const bool good = mass(0, 0) > 0 && std::isfinite(mass(0, 0)) && inertia.allFinite() &&
                    is_positive_definite(inertia) && root.allFinite();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  RigidBody body;
  body.inverse_mass = good ? 1.0 / mass(0, 0) : nan;
  body.inverse_inertia = good ? Mat3(inertia.inverse()) : Mat3(Mat3::Constant(nan));
  body.root_mass = std::sqrt(body.inverse_mass);
  body.root_inertia = good ? root : Mat3(Mat3::Constant(nan));
  slot_.push_back(static_cast<int>(rigid_bodies_.size()));
  rigid_bodies_.push_back(body);
  if (!good) mark_bad(block);
}

void MassInverse::add_general(const ContactProblem::ConstMatrix& mass, int block) {
  slot_.push_back(~static_cast<int>(general_.size()));
  general_.push_back({Eigen::LLT<MatX>(mass), {}});
  if (!mass.allFinite() || general_.back().cholesky.info() != Eigen::Success)
    mark_bad(block);
  else if (!is_symmetric(mass, mass.cwiseAbs().maxCoeff()))
    general_.back().lu.emplace(mass);
}

void MassInverse::apply(int k, const double* momentum, double* velocity) const {
  const int slot = slot_[k];
  if (slot >= 0) {
    const RigidBody& body = rigid_bodies_[slot];
    const Eigen::Map<const Vec3> p(momentum), l(momentum + 3);
    const Vec3 w = body.inverse_inertia * l;
    Eigen::Map<Vec3>{velocity} = body.inverse_mass * p;
    Eigen::Map<Vec3>{velocity + 3} = w;
    return;
  }
  const General& general = general_[~slot];
  const auto& factor = general.cholesky;
  Eigen::Map<VecX> x(velocity, factor.rows());
  if (factor.info() != Eigen::Success) {
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  x = Eigen::Map<const VecX>(momentum, factor.rows());
  if (general.lu)
    x = general.lu->solve(x).eval();
  else
    factor.solveInPlace(x);
}

bool MassInverse::has_root(int k) const {
  const int slot = slot_[k];
  return slot >= 0 || !general_[~slot].lu;
}

void MassInverse::apply_root(int k, const double* momentum, double* scaled) const {
  const int slot = slot_[k];
  if (slot >= 0) {
    const RigidBody& body = rigid_bodies_[slot];
    const double* const l = momentum + 3;
    const Mat3& root = body.root_inertia;
    for (int i = 0; i < 3; ++i) scaled[i] = body.root_mass * momentum[i];
    const double x = root(0, 0) * l[0], y = root(1, 0) * l[0] + root(1, 1) * l[1];
    const double z = root(2, 0) * l[0] + root(2, 1) * l[1] + root(2, 2) * l[2];
    scaled[3] = x;
    scaled[4] = y;
    scaled[5] = z;
    return;
  }
  const auto& factor = general_[~slot].cholesky;
  Eigen::Map<VecX> x(scaled, factor.rows());
  if (factor.info() != Eigen::Success) {
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  x = Eigen::Map<const VecX>(momentum, factor.rows());
  factor.matrixL().solveInPlace(x);
}

double MassInverse::square(int k, const double* x) const {
  const int slot = slot_[k];
  if (slot >= 0) {
    const RigidBody& body = rigid_bodies_[slot];
    const Eigen::Map<const Vec3> p(x), l(x + 3);
    return body.inverse_mass * p.squaredNorm() + l.dot(body.inverse_inertia * l);
  }
  const General& general = general_[~slot];
  const auto& factor = general.cholesky;
  if (factor.info() != Eigen::Success) return std::numeric_limits<double>::quiet_NaN();
  VecX y = Eigen::Map<const VecX>(x, factor.rows());
  if (general.lu) return y.dot(general.lu->solve(y));
  factor.matrixL().solveInPlace(y);
  return y.squaredNorm();
}

}  // namespace nilas::contact
