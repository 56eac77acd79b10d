#include "fracture/bend/wedge.h"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas::fracture {

namespace wedge_test {

/// Cubic Hermite finite elements for the same wedge, graded towards the tip, on 0 < x < 16.
class WedgeElements {
 public:
  WedgeElements(TipLoad load, double a, int elements) {
    for (int k = 0; k <= elements; ++k) x_.push_back(16 * std::pow(double(k) / elements, 2));
    *std::min_element(x_.begin() + 1, x_.end(), [&](double p, double q) { return std::abs(p - a) < std::abs(q - a); }) =
        a;
    std::vector<Eigen::Triplet<double>> entries;
    VecX f = VecX::Zero(2 * elements + 2);
    for (int e = 0; e < elements; ++e) add_element(load, a, e, entries, f);
    Eigen::SparseMatrix<double> K(f.size(), f.size());
    K.setFromTriplets(entries.begin(), entries.end());
    w_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(f);
  }
  double tip() const { return w_(0); }
  /// Largest curvature at the elements' middles, where it is of a higher order.
  double curvature() const {
    double most = 0;
    for (std::size_t e = 0; e + 1 < x_.size(); ++e)
      most = std::max(most, (w_(Eigen::Index(2 * e + 3)) - w_(Eigen::Index(2 * e + 1))) / (x_[e + 1] - x_[e]));
    return most;
  }

 private:
  void add_element(TipLoad load, double a, int e, std::vector<Eigen::Triplet<double>>& entries, VecX& f) const {
    using Rule = boost::math::quadrature::gauss<double, 6>;
    const double from = x_[std::size_t(e)], h = x_[std::size_t(e) + 1] - from;
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i)
      for (const double side : {-1.0, 1.0}) {
        const double s = 0.5 * (1 + side * Rule::abscissa()[i]), x = from + s * h,
                     weight = 0.5 * h * Rule::weights()[i];
        const Eigen::Vector4d N(1 - 3 * s * s + 2 * s * s * s, h * s * (1 - s) * (1 - s), s * s * (3 - 2 * s),
                                h * s * s * (s - 1));
        const Eigen::Vector4d B = Eigen::Vector4d(12 * s - 6, h * (6 * s - 4), 6 - 12 * s, h * (6 * s - 2)) / (h * h);
        const double q = x > a ? 0 : load == TipLoad::pressure ? 2 * x / (a * a) : 1 / a;
        for (int j = 0; j < 4; ++j) {
          f(2 * e + j) += weight * q * N(j);
          for (int k = 0; k < 4; ++k)
            entries.emplace_back(2 * e + j, 2 * e + k, weight * x * (B(j) * B(k) + N(j) * N(k)));
        }
      }
  }
  std::vector<double> x_;
  VecX w_;
};

/// Mellin's transform of the wedge under a point load at its tip is 4^s G(s/4) G((s+1)/4) G((s+2)/4) / G((3-s)/4) but
/// for a factor that the balance of forces gives; its pole at 0 is w(0) = (G(1/4) / G(3/4))^2 / 4.
TEST(Wedge, PointLoadAtTheTip) {
  const double exact = 0.25 * std::pow(std::tgamma(0.25) / std::tgamma(0.75), 2);
  for (const TipLoad load : {TipLoad::pressure, TipLoad::line}) {
    EXPECT_NEAR(solve_wedge(load, 0).tip_deflection, exact, 1e-9);
    EXPECT_NEAR(solve_wedge(load, 1e-4).tip_deflection, exact, 2e-4);
    EXPECT_EQ(solve_wedge(load, 0).curvature, 1);
    // (a/l)^(2/3) is the next order.
    EXPECT_NEAR(solve_wedge(load, 1e-6).curvature, 1, 1.1e-4);
  }
}

/// Finite elements converge to the series: the tip's deflection, an energy, with the fourth power of their size (until
/// rounding stops it near 1e-6), the curvature, read at their middles, with the second.
TEST(Wedge, FiniteElementsConvergeToTheSeries) {
  for (const TipLoad load : {TipLoad::pressure, TipLoad::line})
    for (const double a : {0.05, 0.3, 1.0}) {
      const WedgeResponse exact = solve_wedge(load, a);
      const WedgeElements coarse(load, a, 25), middle(load, a, 100), fine(load, a, 400);
      EXPECT_NEAR(middle.tip() / exact.tip_deflection, 1, 1e-6) << a;
      EXPECT_GT(std::abs(coarse.tip() - exact.tip_deflection), 20 * std::abs(middle.tip() - exact.tip_deflection)) << a;
      EXPECT_NEAR(fine.curvature() / exact.curvature, 1, 2e-4) << a;
      EXPECT_GT(std::abs(middle.curvature() - exact.curvature), 4 * std::abs(fine.curvature() - exact.curvature)) << a;
    }
}

struct Row {
  double a, pressure_factor, line_factor, pressure_x, line_x, tip;
};
constexpr std::array<Row, 8> k_rows{{{0.02, 1.0903, 1.0758, 0.283, 0.255, 2.142},
                                     {0.05, 1.1641, 1.1351, 0.395, 0.355, 2.106},
                                     {0.1, 1.2699, 1.2183, 0.514, 0.460, 2.046},
                                     {0.2, 1.4690, 1.3699, 0.681, 0.604, 1.931},
                                     {0.3, 1.6727, 1.5190, 0.814, 0.717, 1.821},
                                     {0.5, 2.1274, 1.8347, 1.040, 0.903, 1.616},
                                     {0.7, 2.6755, 2.1912, 1.245, 1.066, 1.429},
                                     {1.0, 3.7436, 2.8364, 1.547, 1.297, 1.182}}};

/// An earlier table of 6000 finite elements, which has the tip deflection of a point load 1.0 % too low (2.166 against
/// the exact 2.1884) and all its rows 0.5 to 1.2 % off in the same sense.
TEST(Wedge, AgreesWithAnEarlierTable) {
  const WedgeTable pressure(TipLoad::pressure), line(TipLoad::line);
  for (const Row& row : k_rows) {
    EXPECT_NEAR(pressure.load_factor(row.a) / row.pressure_factor, 1, 0.0125) << row.a;
    EXPECT_NEAR(line.load_factor(row.a) / row.line_factor, 1, 0.0125) << row.a;
    EXPECT_NEAR(pressure.breaking_length(row.a) / row.pressure_x, 1, 0.0085) << row.a;
    EXPECT_NEAR(line.breaking_length(row.a) / row.line_x, 1, 0.0085) << row.a;
    EXPECT_NEAR(pressure.tip_deflection(row.a) / row.tip, 1, 0.011) << row.a;
  }
}

/// Nevel's formula as Kerr quotes it lies within 1.2 % of the exact factor from a/l 0.02 to 0.7 (4.1 % at 1).
TEST(Wedge, NevelsFormula) {
  const WedgeTable table(TipLoad::pressure);
  for (double a = 0.02; a <= 0.7; a += 0.02)
    EXPECT_NEAR((1.05 + 2 * a + 0.5 * a * a * a) / table.load_factor(a), 1, 0.012) << a;
  EXPECT_NEAR((1.05 + 2 + 0.5) / table.load_factor(1), 1, 0.042);
}

/// Fit 0.987 (a/l)^(1/3) + 0.56 (a/l), stated to 2.5 % of the earlier table, whose lengths are up to 0.8 % too large.
TEST(Wedge, FitOfTheBreakingLength) {
  const WedgeTable table(TipLoad::pressure);
  for (double a = 0.02; a <= 1; a += 0.02)
    EXPECT_NEAR((0.987 * std::cbrt(a) + 0.56 * a) / table.breaking_length(a), 1, 0.033) << a;
}

TEST(Wedge, TableKeepsItsAccuracyBetweenNodes) {
  for (const TipLoad load : {TipLoad::pressure, TipLoad::line}) {
    const WedgeTable table(load);
    for (double a = 1e-4; a < 2; a *= 1.13) {
      const WedgeResponse exact = solve_wedge(load, a);
      ASSERT_NEAR(table.load_factor(a) * exact.curvature, 1, 1e-6) << a;
      ASSERT_NEAR(table.breaking_length(a), exact.x_max, 1e-6) << a;
      ASSERT_NEAR(table.tip_deflection(a) / exact.tip_deflection, 1, 1e-6) << a;
    }
  }
}

TEST(Wedge, LongerLoadsCountAsTheLongest) {
  const WedgeTable table(TipLoad::line);
  EXPECT_NEAR(table.load_factor(5), table.load_factor(k_longest_tip_load), 1e-12);
  EXPECT_THROW(table.load_factor(-0.1), ContractError);
  EXPECT_THROW(solve_wedge(TipLoad::line, 2.1), ContractError);
}

/// sigma_f 0.5 MPa, h 1 m, a/l 0.1: b0 sigma_f h^2 / 6 times the factor 1.25547.
TEST(Wedge, FailureLoads) {
  const WedgeTable table(TipLoad::pressure);
  for (const double angle : {30 * k_deg, 60 * k_deg, 90 * k_deg}) {
    const double load = wedge_failure_load(table, 0.1, angle, 1, 5e5);
    EXPECT_NEAR(load, 2 * std::tan(angle / 2) * 5e5 / 6 * 1.255470, 1e-5 * load);
    EXPECT_NEAR(wedge_failure_load(table, 0.1, angle, 1, 1e6) / load, 2, 1e-12);
    EXPECT_NEAR(wedge_failure_load(table, 0.1, angle, 2, 5e5) / load, 4, 1e-12);
    EXPECT_NEAR(wedges_failure_load(table, 0.1, angle, 5, 1, 5e5) / load, 5, 1e-12);
  }
}

/// Many narrow wedges round a point have n b0 = 2 pi: pi/3 = 1.047 sigma_f h^2 for a = 0 (Nevel's formula gives 1.1).
TEST(Wedge, ManyWedgesMakeASheet) {
  const WedgeTable table(TipLoad::pressure);
  EXPECT_NEAR(wedges_failure_load(table, 0, 2 * k_pi / 1000, 1000, 1, 1), k_pi / 3, 1e-5);
}

TEST(Wedge, RadiusShrinksWithSpeed) {
  const WedgeTable table(TipLoad::pressure);
  const double still = bending_radius(table, 0.1, 14.268);
  EXPECT_NEAR(still, 0.511486 * 14.268, 1e-5 * still);
  EXPECT_EQ(bending_radius(table, 0.1, 14.268, 3), still);
  EXPECT_NEAR(bending_radius(table, 0.1, 14.268, 2, {-0.14}) / still, 0.72, 1e-12);
  EXPECT_NEAR(bending_radius(table, 0.1, 14.268, 20, {-0.14}) / still, 0.25, 1e-12);
}

}  // namespace wedge_test
}  // namespace nilas::fracture
