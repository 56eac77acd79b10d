#include "contact/solvers/newton/newton_system.h"

#include <cmath>
#include <numeric>
#include <utility>

#include "contact/law/law_map.h"
#include "contact/problem/row_of.h"
#include "core/base/order_free_sum.h"

namespace nilas::solvers {

NewtonSystem::NewtonSystem(const contact::ContactCoefficients& law, const std::vector<double>& d,
                           std::vector<double> judged, const VecX& q, bool order_free, int threads)
    : law_(law), order_free_(order_free), threads_(threads), judged_(std::move(judged)), q_(q), slopes_(d.size()) {
  for (std::size_t a = 0; a < d.size(); ++a) {
    scale_.push_back(1 / std::sqrt(d[a]));
    cap_.push_back(law.force_limit[a] / scale_.back());
    q_.segment<3>(contact::row_of(static_cast<Eigen::Index>(a))) *= scale_.back();
  }
}

VecX NewtonSystem::scaled(const VecX& r) const {
  VecX out = r;
  for (int a = 0; a < num_contacts(); ++a) out.segment<3>(contact::row_of(a)) /= scale_[a];
  return out;
}

VecX NewtonSystem::impulses(const VecX& scaled_r) const {
  VecX out = scaled_r;
  for (int a = 0; a < num_contacts(); ++a) out.segment<3>(contact::row_of(a)) *= scale_[a];
  return out;
}

LawSlopes NewtonSystem::slopes_at(int a, const VecX& r, const VecX& u) const {
  return law_slopes(law_.law, law_.facets, law_.mu[a], cap_[a], r.segment<3>(contact::row_of(a)),
                    u.segment<3>(contact::row_of(a)));
}

/// Returns the length of the vector whose squared components are given.
double NewtonSystem::length(const std::vector<double>& squares) const {
  if (!order_free_) return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
  OrderFreeSum sum;
  for (const double square : squares) sum.add(square);
  return std::sqrt(sum.value());
}

double NewtonSystem::linearise(const VecX& r, const VecX& u) {
  std::vector<double> squares(slopes_.size());
  for_contacts([&](int a) {
    slopes_[a] = slopes_at(a, r, u);
    squares[a] = slopes_[a].value.squaredNorm();
  });
  return length(squares);
}

double NewtonSystem::map_size(const VecX& r, const VecX& u) const {
  std::vector<double> squares(slopes_.size());
  for_contacts([&](int a) { squares[a] = slopes_at(a, r, u).value.squaredNorm(); });
  return length(squares);
}

double NewtonSystem::law_map(const VecX& r) const {
  const VecX u = velocities(r);
  std::vector<double> maps(slopes_.size());
  for_contacts([&](int a) {
    const contact::ContactScale scale{law_.mu[a], law_.force_limit[a], judged_[a]};
    const Vec3 impulse = scale_[a] * r.segment<3>(contact::row_of(a)),
               velocity = u.segment<3>(contact::row_of(a)) / scale_[a];
    maps[a] = contact::law_map(law_.law, law_.facets, scale, impulse, velocity);
  });
  double worst = 0;
  for (const double map : maps)
    if (!(map <= worst) && !std::isnan(worst)) worst = map;  // a NaN stays
  return worst;
}

}  // namespace nilas::solvers
