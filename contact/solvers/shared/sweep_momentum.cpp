#include "contact/solvers/shared/sweep_momentum.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nilas::solvers {

namespace {

constexpr double k_most_momentum = 0.9;  ///< beta at most [-]
constexpr double k_most_growth = 4;      ///< of the square of a sweep's length [-]

}  // namespace

SweepMomentum::SweepMomentum(const RowIsland& whole, std::vector<int> contacts)
    : rows_(whole.rows), contacts_(std::move(contacts)) {
  std::size_t count = 0;
  for (const int block : whole.island.blocks) {
    const int size = whole.problem.block_size(block);
    blocks_.emplace_back(rows_.first_velocity[block], size);
    count += static_cast<std::size_t>(size);
  }
  for (Place* place : {&now_, &before_}) {
    place->impulses.resize(3 * contacts_.size());
    place->velocities.resize(count);
  }
}

void SweepMomentum::read(Place& place) const {
  double* impulse = place.impulses.data();
  for (const int k : contacts_) impulse = std::copy_n(rows_.contacts[k].r, 3, impulse);
  double* velocity = place.velocities.data();
  for (const auto& [first, size] : blocks_) velocity = std::copy_n(rows_.velocities.data() + first, size, velocity);
}

double SweepMomentum::next_beta() {
  double along = 0, length = 0;
  for (std::size_t k = 0; k < begun_.size(); ++k) {
    const double swept = now_.velocities[k] - begun_[k];
    along += swept * (now_.velocities[k] - before_.velocities[k]);
    length += swept * swept;
  }
  if (!(along >= 0) || !(length <= k_most_growth * shortest_)) {
    theta_ = 1;
    shortest_ = length;
    return 0;
  }
  shortest_ = std::min(shortest_, length);
  const double next = 0.5 * (1 + std::sqrt(1 + 4 * theta_ * theta_)), beta = (theta_ - 1) / next;
  theta_ = next;
  return std::min(beta, k_most_momentum);
}

double SweepMomentum::push() {
  read(now_);
  const double beta = has_swept_ ? next_beta() : 0;
  has_swept_ = true;
  begun_ = now_.velocities;
  if (beta > 0) {
    const double *impulse = now_.impulses.data(), *old_impulse = before_.impulses.data();
    for (const int k : contacts_)
      for (double& r : rows_.contacts[k].r) r += beta * (*impulse++ - *old_impulse++);
    double* begun = begun_.data();
    const double* old_velocity = before_.velocities.data();
    for (const auto& [first, size] : blocks_)
      for (int i = 0; i < size; ++i, ++begun) rows_.velocities[first + i] = *begun += beta * (*begun - *old_velocity++);
  }
  std::swap(now_, before_);
  return beta;
}

}  // namespace nilas::solvers
