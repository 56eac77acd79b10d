#include "fracture/ice_damage.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

/// The largest damage. Some strength must remain, since loads are divided by it.
constexpr double k_most_damage = 0.999;

IceDamage::IceDamage(const DamageRule& rule) : rule_(rule) {
  NILAS_DEMAND(rule.exponent > 0 && rule.endurance > 0 && rule.endurance <= 1);
}

double IceDamage::at(std::int64_t floe, const Vec2& place, double reach) const {
  const auto known = marks_.find(floe);
  double most = 0;
  if (known == marks_.end()) return most;
  for (const Mark& mark : known->second)
    if ((mark.place - place).norm() <= reach) most = std::max(most, mark.damage);
  return most;
}

void IceDamage::load(std::int64_t floe, const Vec2& place, double reach, double share) {
  if (share < rule_.endurance) return;
  std::vector<Mark>& marks = marks_[floe];
  const auto nearest = std::min_element(marks.begin(), marks.end(), [&](const Mark& a, const Mark& b) {
    return (a.place - place).squaredNorm() < (b.place - place).squaredNorm();
  });
  const bool is_known = nearest != marks.end() && (nearest->place - place).norm() <= reach;
  Mark& mark = is_known ? *nearest : marks.emplace_back(Mark{place});
  mark.peak = std::max(mark.peak, share);
  mark.is_loaded = true;
}

void IceDamage::end_step() {
  for (auto& [floe, marks] : marks_)
    for (Mark& mark : marks) {
      if (!mark.is_loaded && mark.peak > 0) {
        mark.damage = std::min(k_most_damage, mark.damage + std::pow(mark.peak, rule_.exponent));
        mark.peak = 0;
      }
      mark.is_loaded = false;
    }
}

void IceDamage::hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, double radius) {
  const auto known = marks_.find(floe);
  if (known == marks_.end()) return;
  std::vector<Mark> near;
  for (Mark mark : known->second) {
    mark.place -= place;
    if (mark.place.norm() <= radius) near.push_back(mark);
  }
  if (!near.empty()) marks_[piece] = std::move(near);
}

void IceDamage::save(StateWriter out) const {
  std::vector<std::int64_t> floes;
  std::vector<Vec2> places;
  std::vector<double> damage, peaks;
  for (const auto& [floe, marks] : marks_)
    for (const Mark& mark : marks) {
      floes.push_back(floe);
      places.push_back(mark.place);
      damage.push_back(mark.damage);
      peaks.push_back(mark.peak);
    }
  out.add("floe", floes);
  out.add("place", places);
  out.add("damage", damage);
  out.add("peak", peaks);
}

void IceDamage::restore(const StateReader& in) {
  std::vector<std::int64_t> floes;
  std::vector<Vec2> places;
  std::vector<double> damage, peaks;
  in.get("floe", floes);
  in.get("place", places, floes.size());
  in.get("damage", damage, floes.size());
  in.get("peak", peaks, floes.size());
  marks_.clear();
  for (std::size_t k = 0; k < floes.size(); ++k) marks_[floes[k]].push_back({places[k], damage[k], peaks[k], false});
}

}  // namespace nilas::fracture
