#include "contact/solvers/shared/anderson.h"

namespace nilas::solvers {

/// Differences that are parallel to this share are dropped: coefficients beyond its inverse are noise.
constexpr double k_parallel = 1e-10;

VecX Anderson::next(const VecX& x, const VecX& g) {
  const VecX f = g - x;
  if (last_f_.size() == f.size()) {
    f_steps_.push_back(f - last_f_);
    g_steps_.push_back(g - last_g_);
    if (f_steps_.size() > depth_) {
      f_steps_.erase(f_steps_.begin());
      g_steps_.erase(g_steps_.begin());
    }
  }
  last_f_ = f;
  last_g_ = g;
  if (f_steps_.empty()) return g;
  MatX differences(f.size(), static_cast<Eigen::Index>(f_steps_.size()));
  for (std::size_t k = 0; k < f_steps_.size(); ++k) differences.col(static_cast<Eigen::Index>(k)) = f_steps_[k];
  Eigen::ColPivHouseholderQR<MatX> factor;
  factor.setThreshold(k_parallel);
  factor.compute(differences);
  const VecX coefficients = factor.solve(f);
  VecX x_next = g;
  for (std::size_t k = 0; k < g_steps_.size(); ++k) x_next -= coefficients[static_cast<Eigen::Index>(k)] * g_steps_[k];
  return x_next;
}

void Anderson::restart() {
  last_f_.resize(0);
  last_g_.resize(0);
  f_steps_.clear();
  g_steps_.clear();
}

}  // namespace nilas::solvers
