#include "contact/solvers/newton/delassus_system.h"

#include "contact/law/law_map.h"
#include "contact/measure/measure.h"
#include "contact/problem/row_of.h"
#include "contact/solvers/newton/rounded_solve.h"
#include "core/base/order_free_sum.h"

namespace nilas::solvers {

namespace {

/// A plan is made anew when fewer than this share of its contacts carry something.
constexpr double k_carrying_share = 0.7;

/// d_a by which the residual of the problem is judged.
std::vector<double> judged_masses_of_contacts(const contact::LocalProblem& island) {
  std::vector<double> d;
  for (int a = 0; a < island.num_contacts(); ++a) d.push_back(contact::contact_scale(island, a).d);
  return d;
}

std::vector<double> inverse_masses_of_contacts(const contact::LocalProblem& island) {
  std::vector<double> d;
  for (int a = 0; a < island.num_contacts(); ++a)
    d.push_back((island.diagonal(a).trace() + island.compliance[a] + 2 * island.tangential_compliance[a]) / 3);
  return d;
}

}  // namespace

DelassusSystem::DelassusSystem(const contact::LocalProblem& island, bool order_free)
    : NewtonSystem(island, inverse_masses_of_contacts(island), judged_masses_of_contacts(island), island.q, order_free),
      island_(island),
      block_(island.block) {
  const int nc = island.num_contacts();
  for (int a = 0; a < nc; ++a)
    for (int k = island.row_start[a]; k < island.row_start[a + 1]; ++k) {
      const int b = island.column[k];
      if (a == b) {
        block_[k](0, 0) += island.compliance[a];
        for (int i = 1; i < 3; ++i) block_[k](i, i) += island.tangential_compliance[a];
      }
      block_[k] *= scale(a) * scale(b);
    }
  place_.assign(nc, -1);
}

Vec3 DelassusSystem::row_product(int a, const VecX& r) const {
  Vec3 sum = Vec3::Zero();
  for (int k = island_.row_start[a]; k < island_.row_start[a + 1]; ++k)
    sum.noalias() += block_[k] * r.segment<3>(contact::row_of(island_.column[k]));
  return sum;
}

Vec3 DelassusSystem::order_free_row_product(int a, const VecX& r) const {
  OrderFreeVectorSum sum;
  for (int k = island_.row_start[a]; k < island_.row_start[a + 1]; ++k)
    sum.add(block_[k] * r.segment<3>(contact::row_of(island_.column[k])));
  return sum.value();
}

VecX DelassusSystem::product(const VecX& r) const {
  VecX out(r.size());
  for (int a = 0; a < island_.num_contacts(); ++a)
    out.segment<3>(contact::row_of(a)) = is_order_free() ? order_free_row_product(a, r) : row_product(a, r);
  return out;
}

double DelassusSystem::residual(const VecX& r) const {
  return is_order_free() ? law_map(r) : contact::measure(island_, impulses(r)).law_map_m_s;
}

void DelassusSystem::choose_contacts() {
  std::size_t carrying = 0;
  bool covered = true;
  for (std::size_t a = 0; a < slopes().size(); ++a) {
    if (slopes()[a].open) continue;
    ++carrying;
    covered = covered && place_[a] >= 0;
  }
  if (covered && static_cast<double>(carrying) >= k_carrying_share * static_cast<double>(planned_.size())) return;
  planned_.clear();
  for (std::size_t a = 0; a < slopes().size(); ++a) {
    place_[a] = slopes()[a].open ? -1 : static_cast<int>(planned_.size());
    if (!slopes()[a].open) planned_.push_back(static_cast<int>(a));
  }
  plan();
}

void DelassusSystem::plan() {
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

void DelassusSystem::fill(double weight) {
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const LawSlopes& law = slopes()[planned_[i]];
    for (int k = row_start_[i]; k < row_start_[i + 1]; ++k) {
      const bool diagonal = column_[k] == static_cast<int>(i);
      matrix_[k].noalias() = law.by_velocity * block_[from_[k]];
      if (diagonal) matrix_[k] += weight * law.by_velocity + law.by_impulse;
    }
  }
}

bool DelassusSystem::step(double weight, const VecX& r, VecX& dr) {
  choose_contacts();
  dr = VecX::Zero(r.size());
  for (std::size_t a = 0; a < slopes().size(); ++a)
    if (slopes()[a].open) dr.segment<3>(contact::row_of(a)) = -r.segment<3>(contact::row_of(a));
  VecX x(contact::row_of(planned_.size()));
  const bool opens = !dr.isZero(0);
  const VecX opening = opens ? product(dr) : dr;
  for (std::size_t i = 0; i < planned_.size(); ++i) {
    const LawSlopes& law = slopes()[planned_[i]];
    // an open contact kept in the matrix says dr = -r there as well, so its opening must not count twice
    x.segment<3>(contact::row_of(i)) = -law.value - law.by_velocity * opening.segment<3>(contact::row_of(planned_[i]));
  }
  for (std::size_t i = 0; i < planned_.size(); ++i)
    if (slopes()[planned_[i]].open) x.segment<3>(contact::row_of(i)).setZero();
  fill(weight);
  if (!planned_.empty() && !factors_.factorise(matrix_)) return false;
  if (!planned_.empty() && is_order_free() && !solve_rounded({row_start_, column_, matrix_}, factors_, x)) return false;
  if (!planned_.empty() && !is_order_free()) factors_.solve(x);
  for (std::size_t i = 0; i < planned_.size(); ++i)
    dr.segment<3>(contact::row_of(planned_[i])) += x.segment<3>(contact::row_of(i));
  return dr.allFinite();
}

}  // namespace nilas::solvers
