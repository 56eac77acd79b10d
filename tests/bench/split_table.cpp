/// Makes fracture/split/splitting_table.h: H(A/L, W/L) of a rectangular floe with an edge crack that two opposed forces
/// at its mouth open. It is built with the preset bench; `bench_split_table > table` takes ten minutes.
/// `bench_split_table check` prints values between the table's points instead, and for the square floe their change
/// with order and grading of the elements.
///
/// The model is plane stress for half of the floe, since the crack line is an axis of symmetry. Elements are rectangles
/// of order p on grid lines that close in geometrically on the crack tip and on the load. J is the domain integral over
/// a ring of elements away from both: K = sqrt(E J).
#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

namespace {

using Mat = Eigen::MatrixXd;
using Vec = Eigen::VectorXd;

struct Mesh {
  int order = 5;
  /// Size ratio of neighbouring elements; smallest element over the smallest length.
  double ratio = 0.3, finest = 1e-5;
};

/// Points of the Gauss rule with 8 points on [-1, 1] and its weights.
std::vector<std::pair<double, double>> gauss_points() {
  using Rule = boost::math::quadrature::gauss<double, 8>;
  std::vector<std::pair<double, double>> points;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k)
    for (const double side : {-1.0, 1.0}) points.push_back({side * Rule::abscissa()[k], Rule::weights()[k]});
  return points;
}

/// Values and slopes of the Lagrange polynomials on Chebyshev points of the given order at t.
struct Lagrange {
  Vec value, slope;
};
double node(int order, int k) { return -std::cos(k * 3.14159265358979323846 / order); }
Lagrange lagrange(int order, double t) {
  Lagrange out{Vec::Ones(order + 1), Vec::Zero(order + 1)};
  for (int k = 0; k <= order; ++k) {
    for (int j = 0; j <= order; ++j)
      if (j != k) out.value(k) *= (t - node(order, j)) / (node(order, k) - node(order, j));
    for (int i = 0; i <= order; ++i) {
      if (i == k) continue;
      double term = 1 / (node(order, k) - node(order, i));
      for (int j = 0; j <= order; ++j)
        if (j != k && j != i) term *= (t - node(order, j)) / (node(order, k) - node(order, j));
      out.slope(k) += term;
    }
  }
  return out;
}

/// Lines from `near` (the fine end) to `far`, without `near`.
std::vector<double> graded(double near, double far, double finest, double ratio) {
  std::vector<double> lines;
  for (double d = 1; d * std::abs(far - near) > finest; d *= ratio) lines.push_back(near + d * (far - near));
  return lines;
}

std::vector<double> sorted(std::vector<double> a) {
  std::sort(a.begin(), a.end());
  a.erase(std::unique(a.begin(), a.end()), a.end());
  return a;
}

class Floe {
 public:
  /// A floe of unit length along the crack, width W, crack A; E = 1, unit force and thickness.
  Floe(double A, double W, const Mesh& mesh) : A_(A), W_(W), p_(mesh.order) {
    const double smallest = std::min({A, 1 - A, W / 2}), finest = mesh.finest * smallest;
    x_ = {0, A};
    for (const auto& lines :
         {graded(0, A / 2, finest, mesh.ratio), graded(A, A / 2, finest, mesh.ratio), graded(A, 1, finest, mesh.ratio)})
      x_.insert(x_.end(), lines.begin(), lines.end());
    y_ = graded(0, W / 2, finest, mesh.ratio);
    y_.push_back(0);
    x_ = sorted(x_);
    y_ = sorted(y_);
    integrate_square();
    solve();
  }
  double H() const { return std::sqrt(energy_release()); }

 private:
  static constexpr double nu_ = 0.3;
  int columns() const { return static_cast<int>(x_.size()) - 1; }
  int rows() const { return static_cast<int>(y_.size()) - 1; }
  int dof(int i, int j, int k) const { return 2 * (i * (rows() * p_ + 1) + j) + k; }

  Eigen::Matrix3d stiffness() const {
    Eigen::Matrix3d C;
    C << 1, nu_, 0, nu_, 1, 0, 0, 0, (1 - nu_) / 2;
    return C / (1 - nu_ * nu_);
  }
  /// Slopes (2 x nodes) of the shape functions on the square [-1, 1]^2.
  Mat slopes(const Lagrange& s, const Lagrange& t) const {
    Mat g(2, (p_ + 1) * (p_ + 1));
    for (int i = 0; i <= p_; ++i)
      for (int j = 0; j <= p_; ++j) g.col(i * (p_ + 1) + j) << s.slope(i) * t.value(j), s.value(i) * t.slope(j);
    return g;
  }
  /// Slopes on element (c, r) per slope on the square.
  Eigen::Vector2d stretch(int c, int r) const {
    return {2 / (x_[std::size_t(c) + 1] - x_[std::size_t(c)]), 2 / (y_[std::size_t(r) + 1] - y_[std::size_t(r)])};
  }
  std::vector<int> element_dofs(int c, int r) const {
    std::vector<int> ids;
    for (int i = 0; i <= p_; ++i)
      for (int j = 0; j <= p_; ++j)
        for (int k = 0; k < 2; ++k) ids.push_back(dof(c * p_ + i, r * p_ + j, k));
    return ids;
  }

  /// Integrates on the square. The stiffness of a rectangle is square_[0] hy / hx + square_[1] + square_[2] hx / hy.
  void integrate_square() {
    const int n = (p_ + 1) * (p_ + 1);
    for (Mat& K : square_) K = Mat::Zero(2 * n, 2 * n);
    for (const auto& [s, ws] : gauss_points())
      for (const auto& [t, wt] : gauss_points()) {
        const Mat g = slopes(lagrange(p_, s), lagrange(p_, t));
        Mat X = Mat::Zero(3, 2 * n), Y = Mat::Zero(3, 2 * n);
        for (int k = 0; k < n; ++k) {
          X(0, 2 * k) = X(2, 2 * k + 1) = g(0, k);
          Y(1, 2 * k + 1) = Y(2, 2 * k) = g(1, k);
        }
        square_[0] += ws * wt * X.transpose() * stiffness() * X;
        square_[1] += ws * wt * (X.transpose() * stiffness() * Y + Y.transpose() * stiffness() * X);
        square_[2] += ws * wt * Y.transpose() * stiffness() * Y;
      }
  }

  void solve() {
    const int size = 2 * (columns() * p_ + 1) * (rows() * p_ + 1);
    std::vector<Eigen::Triplet<double>> entries;
    const int tip = static_cast<int>(std::find(x_.begin(), x_.end(), A_) - x_.begin()) * p_;
    std::vector<bool> held(std::size_t(size), false);
    for (int i = tip; i <= columns() * p_; ++i) held[std::size_t(dof(i, 0, 1))] = true;
    held[std::size_t(dof(columns() * p_, 0, 0))] = true;
    for (int c = 0; c < columns(); ++c)
      for (int r = 0; r < rows(); ++r) {
        const double ratio = stretch(c, r)(0) / stretch(c, r)(1);
        const Mat K = square_[0] * ratio + square_[1] + square_[2] / ratio;
        const auto ids = element_dofs(c, r);
        for (std::size_t a = 0; a < ids.size(); ++a)
          for (std::size_t b = 0; b < ids.size(); ++b)
            if (!held[std::size_t(ids[a])] && !held[std::size_t(ids[b])])
              entries.emplace_back(ids[a], ids[b], K(Eigen::Index(a), Eigen::Index(b)));
      }
    for (int k = 0; k < size; ++k)
      if (held[std::size_t(k)]) entries.emplace_back(k, k, 1.0);
    Eigen::SparseMatrix<double> K(size, size);
    K.setFromTriplets(entries.begin(), entries.end());
    Vec f = Vec::Zero(size);
    f(dof(0, 0, 1)) = 1;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    u_ = factor.solve(f);
    u_ += factor.solve(f - K * u_);
  }

  bool inside(int i, int j) const {
    const double reach = 0.3 * std::min({A_, 1 - A_, W_ / 2});
    return std::abs(x_[std::size_t(i)] - A_) <= reach && y_[std::size_t(j)] <= reach;
  }
  /// Eshelby's tensor times the slope of q, integrated over the elements where q falls from 1 to 0; doubled for the
  /// other half.
  double energy_release() const {
    double J = 0;
    for (int c = 0; c < columns(); ++c)
      for (int r = 0; r < rows(); ++r) {
        const double q[2][2] = {{double(inside(c, r)), double(inside(c, r + 1))},
                                {double(inside(c + 1, r)), double(inside(c + 1, r + 1))}};
        const double sum = q[0][0] + q[0][1] + q[1][0] + q[1][1];
        if (sum > 0 && sum < 4) J += ring_term(c, r, q);
      }
    return 2 * J;
  }
  double ring_term(int c, int r, const double (&q)[2][2]) const {
    const auto ids = element_dofs(c, r);
    Mat local(2, (p_ + 1) * (p_ + 1));
    for (std::size_t k = 0; k < ids.size(); ++k) local(Eigen::Index(k % 2), Eigen::Index(k / 2)) = u_(ids[k]);
    const Eigen::Vector2d scale = stretch(c, r);
    double sum = 0;
    for (const auto& [s, ws] : gauss_points())
      for (const auto& [t, wt] : gauss_points()) {
        const Eigen::Matrix2d du = local * slopes(lagrange(p_, s), lagrange(p_, t)).transpose() * scale.asDiagonal();
        const Eigen::Vector3d strain(du(0, 0), du(1, 1), du(0, 1) + du(1, 0)), stress = stiffness() * strain;
        Eigen::Matrix2d sigma;
        sigma << stress(0), stress(2), stress(2), stress(1);
        const Eigen::Vector2d fall(((q[1][0] - q[0][0]) * (1 - t) + (q[1][1] - q[0][1]) * (1 + t)) / 4,
                                   ((q[0][1] - q[0][0]) * (1 - s) + (q[1][1] - q[1][0]) * (1 + s)) / 4);
        const Eigen::Vector2d flux = sigma * du.col(0) - 0.5 * stress.dot(strain) * Eigen::Vector2d::UnitX();
        sum += ws * wt / scale.prod() * flux.dot(scale.cwiseProduct(fall));
      }
    return sum;
  }

  double A_, W_;
  int p_;
  std::vector<double> x_, y_;
  Mat square_[3];
  Vec u_;
};

/// Numbers of table points; fracture/split/splitting_table.h says the same.
constexpr int k_cracks = 32, k_widths = 20;
constexpr double k_longest = 0.9, k_widest = 8;

void print_table() {
  for (int j = 0; j <= k_widths; ++j) {
    const double w = std::pow(k_widest, node(k_widths, j));
    std::printf("    {");
    for (int i = 1; i <= k_cracks; ++i) {
      const double a = 0.5 * k_longest * (1 + node(k_cracks, i));
      std::printf("%.6g%s", Floe(a, w, {}).H() * std::sqrt(a) * std::pow(1 - a, 1.5), i < k_cracks ? ", " : "},\n");
      std::fflush(stdout);
    }
  }
}

/// Prints A/L, W/L, H, and H of finer elements.
void print_checks() {
  for (const double w : {0.13, 0.2, 0.35, 0.5, 0.75, 1.0, 1.5, 2.0, 4.0, 7.0})
    for (const double a :
         {0.002, 0.03, 0.05, 0.07, 0.09, 0.11, 0.13, 0.145, 0.18, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85}) {
      std::printf("{%g, %g, %.6g, %.6g},\n", a, w, Floe(a, w, {}).H(), w == 1 ? Floe(a, w, {6, 0.4, 1e-6}).H() : 0.0);
      std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char**) {
  if (argc > 1)
    print_checks();
  else
    print_table();
}
