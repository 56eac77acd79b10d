#pragma once
/// Anderson acceleration of a fixed point x = g(x).
///
/// With f_k = g(x_k) - x_k and differences over the last m steps, x+ = g_k - DG c with c the least-squares solution of
/// min |f_k - DF c|. Source: Walker, Ni 2011 (type II).
#include <vector>

#include "core/base/math.h"

namespace nilas::solvers {

class Anderson {
 public:
  explicit Anderson(int depth) : depth_(static_cast<std::size_t>(depth)) {}
  /// The next x after g(x) was computed at x.
  VecX next(const VecX& x, const VecX& g);
  /// Forgets all earlier steps.
  void restart();

 private:
  std::size_t depth_;
  VecX last_f_, last_g_;
  std::vector<VecX> f_steps_, g_steps_;
};

}  // namespace nilas::solvers
