#include "contact/problem/operators.h"

#include <algorithm>

#include "contact/problem/row_of.h"
#include "core/base/error.h"

namespace nilas::contact {

using RowMajor = ContactProblem::RowMajor;

namespace {

/// One side of a contact: its rows (3 x n) and where its block's velocities begin.
struct Side {
  const double* rows = nullptr;
  Eigen::Index n = 0;
  int first = 0;
  int block = -1;
};

[[gnu::always_inline]] inline Side side_of(const ContactProblem& problem, int block, const double* rows) {
  if (block < 0) return {};
  return {rows, problem.block_size(block), problem.block_offset[block], block};
}

[[gnu::always_inline]] inline Side side_a(const ContactProblem& problem, int c) {
  return side_of(problem, problem.pairs[c].a, problem.jacobian_data.data() + problem.jacobian_offset[c]);
}

/// `a`: the other side, whose rows come first.
[[gnu::always_inline]] inline Side side_b(const ContactProblem& problem, int c, const Side& a) {
  return side_of(problem, problem.pairs[c].b,
                 problem.jacobian_data.data() + problem.jacobian_offset[c] + static_cast<std::size_t>(3 * a.n));
}

constexpr Eigen::Index k_body = 6;  ///< velocities of a rigid body

/// The product of a row and six velocities, with the sum in the order of the general product.
[[gnu::always_inline]] inline double row_times(const double* row, const double* x) {
  return (row[0] * x[0] + (row[2] * x[2] + row[4] * x[4])) + (row[1] * x[1] + (row[3] * x[3] + row[5] * x[5]));
}

/// J x, with the usual size six unrolled.
[[gnu::always_inline]] inline Vec3 times(const Side& side, const double* x) {
  if (side.n == k_body)
    return {row_times(side.rows, x), row_times(side.rows + k_body, x), row_times(side.rows + 2 * k_body, x)};
  return Eigen::Map<const RowMajor>(side.rows, 3, side.n).lazyProduct(Eigen::Map<const VecX>(x, side.n));
}

[[gnu::always_inline]] inline void add_transposed(const Side& side, const Vec3& r, double* y) {
  if (side.n == k_body) {
    const double *const normal = side.rows, *const first = normal + k_body, *const second = first + k_body;
    for (Eigen::Index k = 0; k < k_body; ++k) y[k] += (normal[k] * r[0] + first[k] * r[1]) + second[k] * r[2];
    return;
  }
  Eigen::Map<VecX>(y, side.n) += Eigen::Map<const RowMajor>(side.rows, 3, side.n).transpose().lazyProduct(r);
}

void respond(const MassInverse& masses, const Side& side, double* response) {
  for (int i = 0; i < 3; ++i) masses.apply(side.block, side.rows + i * side.n, response + i * side.n);
}

/// w += J Y for the rows of one side and the response (n x 3) of the same block.
void add_product(const Side& side, const double* response, Mat3& w) {
  for (int j = 0; j < 3; ++j) w.col(j) += times(side, response + j * side.n);
}

}  // namespace

Vec3 contact_velocity(const ContactProblem& problem, int c, const double* v) {
  Vec3 u = problem.w.segment<3>(row_of(c));
  const Side a = side_a(problem, c), b = side_b(problem, c, a);
  if (a.n > 0) u += times(a, v + a.first);
  if (b.n > 0) u += times(b, v + b.first);
  return u;
}

void add_impulse(const ContactProblem& problem, int c, const Vec3& r, double* momentum) {
  const Side a = side_a(problem, c), b = side_b(problem, c, a);
  if (a.n > 0) add_transposed(a, r, momentum + a.first);
  if (b.n > 0) add_transposed(b, r, momentum + b.first);
}

Mat3 delassus_block(const ContactProblem& problem, const MassInverse& masses, int c, double* response) {
  const Side a = side_a(problem, c), b = side_b(problem, c, a);
  double* const response_b = response + 3 * a.n;
  Mat3 w = Mat3::Zero();
  if (a.n > 0) {
    respond(masses, a, response);
    add_product(a, response, w);
  }
  if (b.n > 0) {
    respond(masses, b, response_b);
    add_product(b, response_b, w);
  }
  if (a.n > 0 && a.block == b.block) {  // both sides belong to one tree: each moves the other
    add_product(a, response_b, w);
    add_product(b, response, w);
  }
  return w;
}

double inverse_mass_scale(const ContactProblem& problem, const MassInverse& masses, int c, double* response) {
  const auto& pair = problem.pairs[c];
  if (pair.a == pair.b) return inverse_mass_scale(delassus_block(problem, masses, c, response));
  double trace = 0;
  const Side a = side_a(problem, c);
  for (const Side& side : {a, side_b(problem, c, a)})
    for (int i = 0; i < 3 && side.n > 0; ++i) trace += masses.square(side.block, side.rows + i * side.n);
  return trace / 3;
}

VecX velocities(const ContactProblem& problem, const MassInverse& masses, const VecX& r) {
  NILAS_DEMAND(r.size() == 3 * problem.num_contacts());
  VecX v = problem.f;
  for (int c = 0; c < problem.num_contacts(); ++c) add_impulse(problem, c, r.segment<3>(row_of(c)), v.data());
  for (int k = 0; k < problem.num_blocks(); ++k) {
    double* const block = v.data() + problem.block_offset[k];
    masses.apply(k, block, block);
  }
  return v;
}

std::size_t largest_response(const ContactProblem& problem) {
  int largest = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) largest = std::max(largest, problem.block_size(k));
  return 6 * static_cast<std::size_t>(largest);
}

}  // namespace nilas::contact
