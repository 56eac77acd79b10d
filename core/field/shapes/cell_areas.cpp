#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "core/field/shapes/power_diagram.h"
#include "core/geometry/mass_properties.h"

namespace nilas::field {

namespace {

constexpr int k_newton_steps = 30;
constexpr int k_step_halvings = 12;
constexpr double k_smallest_area = 0.2;  ///< share of the smallest relative area that a Newton step must leave

using Sparse = Eigen::SparseMatrix<double>;

class AreaFit {
 public:
  AreaFit(PowerSites& sites, const std::vector<double>& shares, const FieldBounds& bounds)
      : sites_(sites), shares_(shares), bounds_(bounds) {
    for (const double share : shares) sum_of_shares_ += share;
    look();
  }

  /// Newton iteration for the weights, until relative errors of the areas are at most `tolerance` or no step reduces
  /// them.
  void run(double tolerance) {
    for (int k = 0; k < k_newton_steps && worst() > tolerance; ++k)
      if (!step()) break;
  }

  /// Moves every site to its cell's centroid.
  void move_sites() {
    for (std::size_t i = 0; i < cells_.size(); ++i)
      if (cells_[i].area > 0) sites_.points[i] = geometry::polygon_moments(cells_[i].outline).centroid;
    look();
  }

  std::vector<PowerCell> cells() && { return std::move(cells_); }

 private:
  /// Computes the present cells and the errors of their areas. If a site has no cell, all weights become zero (a
  /// Voronoi diagram).
  void look() {
    cells_ = power_cells(sites_, bounds_);
    if (smallest_part() <= 0) {
      std::fill(sites_.weights.begin(), sites_.weights.end(), 0.0);
      cells_ = power_cells(sites_, bounds_);
    }
    lacks_ = lacks_of(cells_);
  }

  double wanted(std::size_t i, double all) const { return shares_[i] / sum_of_shares_ * all; }

  Eigen::VectorXd lacks_of(const std::vector<PowerCell>& cells) const {
    double all = 0;
    for (const PowerCell& cell : cells) all += cell.area;
    Eigen::VectorXd lacks(static_cast<Eigen::Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) lacks[static_cast<Eigen::Index>(i)] = wanted(i, all) - cells[i].area;
    return lacks;
  }

  double worst() const {
    double worst = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const double lack = std::abs(lacks_[static_cast<Eigen::Index>(i)]);
      worst = std::max(worst, cells_[i].area > 0 ? lack / cells_[i].area : 1.0);
    }
    return worst;
  }

  /// Smallest ratio of a cell's area to its required one; at most 1.
  double smallest_part() const {
    double all = 0, smallest = 1;
    for (const PowerCell& cell : cells_) all += cell.area;
    for (std::size_t i = 0; i < cells_.size(); ++i) smallest = std::min(smallest, cells_[i].area / wanted(i, all));
    return smallest;
  }

  /// Derivatives dA_i/dw_j = -(length of the common edge) / (2 distance of the sites); the diagonal makes the rows sum
  /// to zero. The diagonal is slightly larger, since equal changes of all weights change nothing.
  Sparse slopes() const {
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> diagonal(cells_.size(), 0.0);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const PowerCell& cell = cells_[i];
      for (std::size_t k = 0; k < cell.outline.size(); ++k) {
        if (cell.beyond[k] <= static_cast<int>(i)) continue;
        const auto j = static_cast<std::size_t>(cell.beyond[k]);
        const double length = (cell.outline[(k + 1) % cell.outline.size()] - cell.outline[k]).norm();
        const double slope = 0.5 * length / (sites_.points[j] - sites_.points[i]).norm();
        entries.emplace_back(static_cast<int>(i), static_cast<int>(j), -slope);
        entries.emplace_back(static_cast<int>(j), static_cast<int>(i), -slope);
        diagonal[i] += slope;
        diagonal[j] += slope;
      }
    }
    constexpr double k_pinning = 1e-9;
    for (std::size_t i = 0; i < cells_.size(); ++i)
      entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i] + k_pinning);
    const auto n = static_cast<Eigen::Index>(cells_.size());
    Sparse matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  bool step() {
    const Eigen::SimplicialLDLT<Sparse> factors(slopes());
    if (factors.info() != Eigen::Success) return false;
    const Eigen::VectorXd change = factors.solve(lacks_);
    if (!change.allFinite()) return false;
    const double least = k_smallest_area * smallest_part();
    const PowerSites before = sites_;
    const double norm = lacks_.norm();
    double length = 1;
    for (int k = 0; k < k_step_halvings; ++k, length *= 0.5) {
      for (std::size_t i = 0; i < cells_.size(); ++i)
        sites_.weights[i] = before.weights[i] + length * change[static_cast<Eigen::Index>(i)];
      std::vector<PowerCell> cells = power_cells(sites_, bounds_);
      Eigen::VectorXd lacks = lacks_of(cells);
      std::swap(cells, cells_);
      if (smallest_part() >= least && lacks.norm() <= (1 - 0.5 * length) * norm) {
        lacks_ = std::move(lacks);
        return true;
      }
      std::swap(cells, cells_);
    }
    sites_ = before;
    return false;
  }

  PowerSites& sites_;
  const std::vector<double>& shares_;
  const FieldBounds& bounds_;
  double sum_of_shares_ = 0;
  std::vector<PowerCell> cells_;
  Eigen::VectorXd lacks_;  ///< required minus present area of each cell [m^2]
};

}  // namespace

std::vector<PowerCell> cells_with_areas(PowerSites& sites, const std::vector<double>& shares, const FieldBounds& bounds,
                                        int rounds, double tolerance) {
  AreaFit fit(sites, shares, bounds);
  constexpr double k_coarse = 0.05;  // tolerance while the sites still move
  for (int k = 0; k < rounds; ++k) {
    fit.run(k_coarse);
    fit.move_sites();
  }
  fit.run(tolerance);
  return std::move(fit).cells();
}

}  // namespace nilas::field
