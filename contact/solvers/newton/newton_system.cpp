#include "contact/solvers/newton/newton_system.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/law/law_map.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/newton/rounded_solve.h"
#include "core/base/order_free_sum.h"

namespace nilas::solvers {

namespace {

/// A plan is made anew when fewer than this share of its contacts carry something.
constexpr double k_carrying_share = 0.7;

}  // namespace

NewtonSystem::NewtonSystem(const contact::LocalProblem& island, bool order_free)
    : island_(island), order_free_(order_free), block_(island.block), q_(island.q) {
  const int nc = island.num_contacts();
  for (int a = 0; a < nc; ++a) {
    const double d = (island.diagonal(a).trace() + island.compliance[a]) / 3;
    scale_.push_back(1 / std::sqrt(d));
    cap_.push_back(island.force_limit[a] / scale_.back());
    q_.segment<3>(contact::row_of(a)) *= scale_.back();
  }
  for (int a = 0; a < nc; ++a)
    for (int k = island.row_start[a]; k < island.row_start[a + 1]; ++k) {
      const int b = island.column[k];
      if (a == b) block_[k](0, 0) += island.compliance[a];
      block_[k] *= scale_[a] * scale_[b];
    }
  slopes_.resize(nc);
  place_.assign(nc, -1);
}

VecX NewtonSystem::scaled(const VecX& r) const {
  VecX out = r;
  for (int a = 0; a < island_.num_contacts(); ++a) out.segment<3>(contact::row_of(a)) /= scale_[a];
  return out;
}

VecX NewtonSystem::impulses(const VecX& scaled_r) const {
  VecX out = scaled_r;
  for (int a = 0; a < island_.num_contacts(); ++a) out.segment<3>(contact::row_of(a)) *= scale_[a];
  return out;
}

Vec3 NewtonSystem::row_product(int a, const VecX& r) const {
  Vec3 sum = Vec3::Zero();
  for (int k = island_.row_start[a]; k < island_.row_start[a + 1]; ++k)
    sum.noalias() += block_[k] * r.segment<3>(contact::row_of(island_.column[k]));
  return sum;
}

Vec3 NewtonSystem::order_free_row_product(int a, const VecX& r) const {
  OrderFreeVectorSum sum;
  for (int k = island_.row_start[a]; k < island_.row_start[a + 1]; ++k)
    sum.add(block_[k] * r.segment<3>(contact::row_of(island_.column[k])));
  return sum.value();
}

VecX NewtonSystem::product(const VecX& r) const {
  VecX out(r.size());
  for (int a = 0; a < island_.num_contacts(); ++a)
    out.segment<3>(contact::row_of(a)) = order_free_ ? order_free_row_product(a, r) : row_product(a, r);
  return out;
}

LawSlopes NewtonSystem::slopes(int a, const VecX& r, const VecX& u) const {
  return law_slopes(island_.law, island_.facets, island_.mu[a], cap_[a], r.segment<3>(contact::row_of(a)),
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
  std::vector<double> squares;
  for (int a = 0; a < island_.num_contacts(); ++a) {
    slopes_[a] = slopes(a, r, u);
    squares.push_back(slopes_[a].value.squaredNorm());
  }
  return length(squares);
}

double NewtonSystem::map_size(const VecX& r, const VecX& u) const {
  std::vector<double> squares;
  for (int a = 0; a < island_.num_contacts(); ++a) squares.push_back(slopes(a, r, u).value.squaredNorm());
  return length(squares);
}

double NewtonSystem::law_map(const VecX& r) const {
  const VecX u = velocities(r);
  double worst = 0;
  for (int a = 0; a < island_.num_contacts(); ++a) {
    const Vec3 impulse = scale_[a] * r.segment<3>(contact::row_of(a)),
               velocity = u.segment<3>(contact::row_of(a)) / scale_[a];
    const double map =
        nilas::contact::law_map(island_.law, island_.facets, contact::contact_scale(island_, a), impulse, velocity);
    if (!(map <= worst)) worst = map;  // a NaN stays
  }
  return worst;
}

void NewtonSystem::choose_contacts() {
  std::size_t carrying = 0;
  bool covered = true;
  for (std::size_t a = 0; a < slopes_.size(); ++a) {
    if (slopes_[a].open) continue;
    ++carrying;
    covered = covered && place_[a] >= 0;
  }
  if (covered && static_cast<double>(carrying) >= k_carrying_share * static_cast<double>(planned_.size())) return;
  planned_.clear();
  for (std::size_t a = 0; a < slopes_.size(); ++a) {
    place_[a] = slopes_[a].open ? -1 : static_cast<int>(planned_.size());
    if (!slopes_[a].open) planned_.push_back(static_cast<int>(a));
  }
  plan();
}

void NewtonSystem::plan() {
  row_start_.assign(1, 0);
  column_.clear();
  from_.clear();
  for (const int a : planned_) {
    for (int k = island_.row_start[a]; k < island_.row_start[a + 1]; ++k) {
      const int place = place_[island_.column[k]];
      if (place < 0) continue;
      column_.push_back(place);
      from_.push_back(k);
    }
    row_start_.push_back(static_cast<int>(column_.size()));
  }
  matrix_.resize(column_.size());
  factors_.analyse(row_start_, column_);
}

void NewtonSystem::fill(double weight) {
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const LawSlopes& law = slopes_[planned_[i]];
    for (int k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      const bool diagonal = column_[k] == static_cast<int>(i);
      matrix_[k].noalias() = law.by_velocity * block_[from_[k]];
      if (diagonal) matrix_[k] += weight * law.by_velocity + law.by_impulse;
    }
  }
}

bool NewtonSystem::step(double weight, const VecX& r, VecX& dr) {
  choose_contacts();
  dr = VecX::Zero(r.size());
  for (std::size_t a = 0; a < slopes_.size(); ++a)
    if (slopes_[a].open) dr.segment<3>(contact::row_of(a)) = -r.segment<3>(contact::row_of(a));
  VecX x(contact::row_of(planned_.size()));
  const bool opens = !dr.isZero(0);
  const VecX opening = opens ? product(dr) : dr;
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const LawSlopes& law = slopes_[planned_[i]];
    // an open contact kept in the matrix says dr = -r there as well, so its opening must not count twice
    x.segment<3>(contact::row_of(i)) = -law.value - law.by_velocity * opening.segment<3>(contact::row_of(planned_[i]));
  }
  for (std::size_t i = 0; i < planned_.size(); ++i)
    if (slopes_[planned_[i]].open) x.segment<3>(contact::row_of(i)).setZero();
  fill(weight);
  if (!planned_.empty() && !factors_.factorise(matrix_)) return false;
  if (!planned_.empty() && order_free_ && !solve_rounded({row_start_, column_, matrix_}, factors_, x)) return false;
  if (!planned_.empty() && !order_free_) factors_.solve(x);
  for (std::size_t i = 0; i < planned_.size(); ++i)
    dr.segment<3>(contact::row_of(planned_[i])) += x.segment<3>(contact::row_of(i));
  return dr.allFinite();
}

}  // namespace nilas::solvers
