#include "contact/solvers/newton/newton_finish.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "contact/law/cone.h"
#include "contact/problem/row_of.h"

namespace nilas::solvers {

namespace {

/// Damping is relative to W' of unit diagonal; its square must stay above rounding.
constexpr double k_first_damping = 1e-5;
constexpr double k_least_damping = 1e-7;
constexpr double k_largest_damping = 1;
constexpr double k_change = 10;
/// A step of length t counts when it lowers |F| by this share of t; shorter ones than k_shortest are given up, and
/// those below k_long ask for more damping.
constexpr double k_descent = 1e-2;
constexpr double k_shortest = 1.0 / 128;
constexpr double k_long = 0.1;
/// Fewer rows than this are factored as a dense matrix.
constexpr int k_dense_rows = 400;

/// F and its derivatives with respect to r and u.
struct Piece {
  Vec3 f;
  Mat3 by_r, by_u;
};

Piece alart_curnier(const Vec3& r, const Vec3& u, double mu, double cap) {
  const Vec3 y = r - u;
  const bool open = y[0] <= 0, capped = y[0] >= cap;
  const double normal = std::clamp(y[0], 0.0, cap);
  const double radius = mu * normal, t = contact::tangential_norm(y);
  Mat3 by_y = Mat3::Zero();
  Vec3 target(normal, y[1], y[2]);
  if (!open && !capped) by_y(0, 0) = 1;
  if (t <= radius && radius > 0) {
    by_y(1, 1) = by_y(2, 2) = 1;
  } else {
    const Vec2 c = t > 0 ? Vec2(y.tail<2>() / t) : Vec2(Vec2::Zero());
    target.tail<2>() = radius * c;
    if (radius > 0) {
      by_y.bottomRightCorner<2, 2>() = radius / t * (Eigen::Matrix2d::Identity() - c * c.transpose());
      if (!capped) by_y.block<2, 1>(1, 0) = mu * c;
    }
  }
  return {r - target, Mat3::Identity() - by_y, by_y};
}

Piece convex(const Vec3& r, const Vec3& u, double mu, double cap) {
  const Vec3 y = r - u;
  const Vec3 target = contact::project_cone(y, mu, cap);
  const double t = contact::tangential_norm(y);
  Mat3 by_y = Mat3::Zero();
  if (target == y) {
    by_y.setIdentity();
  } else if (target[0] >= cap && cap > 0) {
    const Vec2 c = t > 0 ? Vec2(y.tail<2>() / t) : Vec2(Vec2::Zero());
    if (t <= mu * cap)
      by_y.bottomRightCorner<2, 2>().setIdentity();
    else
      by_y.bottomRightCorner<2, 2>() = mu * cap / t * (Eigen::Matrix2d::Identity() - c * c.transpose());
  } else if (target[0] > 0 && t > 0) {
    const Vec2 c = y.tail<2>() / t;
    const Vec3 edge = Vec3(1, mu * c[0], mu * c[1]) / std::sqrt(1 + mu * mu);
    by_y = edge * edge.transpose();
    by_y.bottomRightCorner<2, 2>() += mu * target[0] / t * (Eigen::Matrix2d::Identity() - c * c.transpose());
  }
  return {r - target, Mat3::Identity() - by_y, by_y};
}

struct Size {
  double worst_m_s = 0;  ///< largest map
  double norm = 0;       ///< |F| [sqrt(J)], what a step must lower
};

class Finish {
 public:
  explicit Finish(const MassScaled& problem) : problem_(problem), pieces_(problem.num_contacts()) {}

  /// Fills the pieces.
  Size evaluate(const VecX& r) {
    const VecX u = problem_.w * r + problem_.q;
    Size size;
    for (int a = 0; a < problem_.num_contacts(); ++a) {
      const Vec3 r_a = r.segment<3>(contact::row_of(a)), u_a = u.segment<3>(contact::row_of(a));
      pieces_[a] = problem_.law == Law::ccp ? convex(r_a, u_a, problem_.mu[a], problem_.cap[a])
                                            : alart_curnier(r_a, u_a, problem_.mu[a], problem_.cap[a]);
      const double square = pieces_[a].f.squaredNorm();
      const double map = std::sqrt(square) / problem_.scale[a];
      if (!(map <= size.worst_m_s)) size.worst_m_s = map;
      size.norm += square;
    }
    size.norm = std::sqrt(size.norm);
    return size;
  }

  /// The damped step for the pieces last evaluated; empty when the matrix is singular.
  VecX step(double damping) const {
    const int nc = problem_.num_contacts();
    VecX dr(3 * nc);
    std::vector<int> place(nc, -1);
    int active = 0;
    for (int a = 0; a < nc; ++a) {
      dr.segment<3>(contact::row_of(a)) = -pieces_[a].f;
      if (!pieces_[a].by_u.isZero(0)) place[a] = active++;
    }
    // F' of an open contact is the unit matrix: its dr is known, and what it does to u goes to the right side
    VecX open = dr;
    for (int a = 0; a < nc; ++a)
      if (place[a] >= 0) open.segment<3>(contact::row_of(a)).setZero();
    const VecX moved = problem_.w * open;
    VecX rhs(3 * active);
    for (int a = 0; a < nc; ++a)
      if (place[a] >= 0)
        rhs.segment<3>(contact::row_of(place[a])) =
            -pieces_[a].f - pieces_[a].by_u * moved.segment<3>(contact::row_of(a));
    const VecX solved = solve(place, active, damping, rhs);
    if (solved.size() != rhs.size() || !solved.allFinite()) return {};
    for (int a = 0; a < nc; ++a)
      if (place[a] >= 0) dr.segment<3>(contact::row_of(a)) = solved.segment<3>(contact::row_of(place[a]));
    return dr;
  }

 private:
  /// J = F' between the contacts that are not open.
  std::vector<Eigen::Triplet<double>> jacobian(const std::vector<int>& place) const {
    const Eigen::SparseMatrix<double>& w = problem_.w;
    const int* const outer = w.outerIndexPtr();
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index column = 0; column < w.cols(); column += 3) {
      const int b = static_cast<int>(column / 3);
      if (place[b] < 0) continue;
      for (int k = 0; k < outer[column + 1] - outer[column]; k += 3) {
        const int a = w.innerIndexPtr()[outer[column] + k] / 3;
        if (place[a] < 0) continue;
        Mat3 block;
        for (int j = 0; j < 3; ++j) block.col(j) = Eigen::Map<const Vec3>(w.valuePtr() + outer[column + j] + k);
        block = (pieces_[a].by_u * block).eval();
        if (a == b) block += pieces_[a].by_r;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            if (block(i, j) != 0) entries.emplace_back(3 * place[a] + i, 3 * place[b] + j, block(i, j));
      }
    }
    return entries;
  }

  VecX solve(const std::vector<int>& place, int active, double damping, const VecX& rhs) const {
    const auto entries = jacobian(place);
    const double added = damping * damping;
    if (3 * active <= k_dense_rows) {
      MatX matrix = MatX::Zero(3 * active, 3 * active);
      for (const auto& entry : entries) matrix(entry.row(), entry.col()) = entry.value();
      MatX normal = matrix.transpose() * matrix;
      normal.diagonal().array() += added;
      const Eigen::LLT<MatX> factor(normal);
      return factor.info() == Eigen::Success ? VecX(factor.solve(matrix.transpose() * rhs)) : VecX();
    }
    Eigen::SparseMatrix<double> matrix(3 * active, 3 * active);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseMatrix<double> transposed = matrix.transpose();
    Eigen::SparseMatrix<double> normal = transposed * matrix;
    for (int k = 0; k < 3 * active; ++k) normal.coeffRef(k, k) += added;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(normal);
    return factor.info() == Eigen::Success ? VecX(factor.solve(transposed * rhs)) : VecX();
  }

  const MassScaled& problem_;
  std::vector<Piece> pieces_;
};

}  // namespace

FinishOutcome newton_finish(const MassScaled& problem, const VecX& scaled, double tolerance, const Budget& budget) {
  Finish finish(problem);
  FinishOutcome out{scaled, 0};
  Size size = finish.evaluate(out.r);
  double damping = k_first_damping;
  while (size.worst_m_s > tolerance && damping <= k_largest_damping && budget.allows(out.iterations)) {
    ++out.iterations;
    const VecX dr = finish.step(damping);
    if (dr.size() == 0) {
      damping *= k_change;
      continue;
    }
    double t = 1;
    Size next = finish.evaluate(out.r + t * dr);
    while (t >= k_shortest && !(next.norm < (1 - k_descent * t) * size.norm)) {
      t *= 0.5;
      next = finish.evaluate(out.r + t * dr);
    }
    if (t >= k_shortest) {
      out.r += t * dr;
      size = next;
      damping = t >= k_long ? std::max(damping / k_change, k_least_damping) : damping * k_change;
    } else {
      finish.evaluate(out.r);
      damping *= k_change;
    }
  }
  return out;
}

}  // namespace nilas::solvers
