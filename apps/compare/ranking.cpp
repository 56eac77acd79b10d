#include "apps/compare/ranking.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "apps/compare/statistics.h"

namespace nilas {

namespace {

double shown_error(const Merit& m) { return m.told ? m.error : m.floor; }

bool complete(const Merit& m) { return m.done > 0 && m.failed == 0 && !std::isnan(m.error); }

}  // namespace

void rank(Findings& found) {
  for (auto& m : found.merits)
    m.dominated = !complete(m) || std::any_of(found.merits.begin(), found.merits.end(), [&](const Merit& other) {
      const bool no_worse = other.told ? m.told && other.error <= m.error : other.floor <= shown_error(m);
      const bool better = other.time < m.time || (m.told && (!other.told || other.error < m.error));
      return &other != &m && complete(other) && other.time <= m.time && no_worse && better;
    });
}

void choose(Findings& found) {
  constexpr double k_deeper = 2;
  const double good_enough = std::max(k_target * found.scale, found.common_floor);
  if (!std::isfinite(good_enough)) return;
  std::vector<const Merit*> enough;
  for (const auto& m : found.merits) {
    const bool deep = m.penetration_max_m > k_deeper * found.merits.front().penetration_max_m + k_rounding_share;
    if (complete(m) && !deep && shown_error(m) <= good_enough) enough.push_back(&m);
  }
  if (enough.empty()) return;
  const auto by_time = [](const Merit* a, const Merit* b) { return a->time < b->time; };
  const double fastest = (*std::min_element(enough.begin(), enough.end(), by_time))->time;
  constexpr double k_sure = 2;  // standard deviations
  const double spread = std::isnan(found.time_spread) ? 0 : found.time_spread;
  std::erase_if(enough, [&](const Merit* m) { return m->time > fastest * (1 + k_sure * spread); });
  const auto by_error = [](const Merit* a, const Merit* b) { return shown_error(*a) < shown_error(*b); };
  found.chosen =
      enough.front()->setting == 0 ? 0 : (*std::min_element(enough.begin(), enough.end(), by_error))->setting;
}

void find_orders(const Plan& plan, Findings& found) {
  std::set<std::size_t> taken;
  for (std::size_t s = 0; s < plan.settings.size(); ++s) {
    if (taken.count(s) > 0) continue;
    std::vector<double> x, y;
    for (std::size_t other = s; other < plan.settings.size(); ++other) {
      CompareSetting same = plan.settings[other];
      same.step = plan.settings[s].step;
      if (!(same == plan.settings[s])) continue;
      taken.insert(other);
      const Merit& m = found.merits[other];
      if (!m.told || m.done < m.planned) continue;
      x.push_back(std::log(plan.settings[other].step));
      y.push_back(std::log(m.error));
    }
    constexpr std::size_t k_least = 3;
    if (x.size() < k_least) continue;
    const double mx = mean_of(x), my = mean_of(y);
    double xy = 0, xx = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      xy += (x[k] - mx) * (y[k] - my);
      xx += (x[k] - mx) * (x[k] - mx);
    }
    CompareSetting one = plan.settings[s];
    one.step = plan.settings.front().step;
    found.orders.push_back({label_of(one, plan.settings.front()), xy / xx, static_cast<int>(x.size())});
  }
}

}  // namespace nilas
