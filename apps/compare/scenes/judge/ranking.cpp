#include "apps/compare/scenes/judge/ranking.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <map>
#include <set>

#include "core/base/statistics.h"

namespace nilas::compare {

namespace {

double shown_error(const Merit& m) { return m.significant ? m.error : m.floor; }

/// Whether a setting is ranked. One with fewer realisations than the others is not.
bool complete(const Merit& m) { return m.done > 0 && m.failed == 0 && !m.partial && !std::isnan(m.error); }

/// Whether errors rise or fall with the step throughout; else they have no order.
bool one_way(const std::vector<double>& steps, const std::vector<double>& errors) {
  std::map<double, double> by_step;
  for (std::size_t k = 0; k < steps.size(); ++k) by_step[steps[k]] = errors[k];
  int rises = 0, falls = 0;
  for (auto finer = by_step.begin(), coarser = std::next(finer); coarser != by_step.end(); ++finer, ++coarser)
    ++(coarser->second > finer->second ? rises : falls);
  return rises == 0 || falls == 0;
}

/// The order p of errors C (h^p - r^p) against a reference with the step r [s]: that for which log C scatters least. 0
/// if the errors do not fall with the step.
double order_of(const std::vector<double>& steps, const std::vector<double>& errors, double reference_step) {
  const auto scatter = [&](double p) {
    std::vector<double> logs;
    for (std::size_t k = 0; k < steps.size(); ++k)
      logs.push_back(std::log(errors[k] / (std::pow(steps[k], p) - std::pow(reference_step, p))));
    return variance_of(logs);
  };
  constexpr double k_least = 0.05, k_most = 10, k_none = 0.1;
  constexpr int k_bits = 40;
  const double order = boost::math::tools::brent_find_minima(scatter, k_least, k_most, k_bits).first;
  return order > k_none ? order : 0;
}

}  // namespace

std::vector<Merit> with_dominance(std::vector<Merit> merits) {
  for (auto& m : merits)
    m.dominated = !complete(m) || std::any_of(merits.begin(), merits.end(), [&](const Merit& other) {
      const bool no_worse = other.significant ? m.significant && other.error <= m.error : other.floor <= shown_error(m);
      const bool better = other.time < m.time || (m.significant && (!other.significant || other.error < m.error));
      return &other != &m && complete(other) && other.time <= m.time && no_worse && better;
    });
  return merits;
}

std::vector<Merit> with_faulty_parts(const Plan& plan, const Measure& measure, std::vector<Merit> merits) {
  // A part that is as far off as the first setting shows no fault of its change.
  const double own = merits.empty() || std::isnan(merits.front().error) ? 0 : merits.front().error;
  const auto at_fault = [&](const Merit& m) {
    return complete(m) && m.significant && m.error > own + k_target * measure.scale;
  };
  for (auto& whole : merits)
    for (const auto& part : merits)
      if (at_fault(part) && is_part(plan.settings[part.setting], plan.settings[whole.setting], plan.settings.front())) {
        whole.faulty_part = part.setting;
        break;
      }
  return merits;
}

double significant_speed_ratio(double time_spread) {
  constexpr double k_sure = 3, k_spread_if_unknown = 0.1;
  return std::exp(k_sure * std::sqrt(2.0) * (std::isnan(time_spread) ? k_spread_if_unknown : time_spread));
}

Choice choose(const std::vector<Merit>& merits, const Measure& measure, double common_floor, double time_spread) {
  Choice choice;
  constexpr double k_deeper = 2, k_immaterial_m = 1e-6;
  const double good_enough = std::max(k_target * measure.scale, common_floor);
  if (!std::isfinite(good_enough)) return choice;
  const double deepest = std::max(k_deeper * merits.front().penetration_max_m, k_immaterial_m);
  std::vector<const Merit*> enough, deeper, lucky;
  for (const auto& m : merits) {
    if (!complete(m) || shown_error(m) > good_enough) continue;
    const bool deep = m.penetration_max_m > deepest;
    (deep ? deeper : m.faulty_part ? lucky : enough).push_back(&m);
  }
  const auto by_time = [](const Merit* a, const Merit* b) { return a->time < b->time; };
  if (enough.empty()) {
    if (!lucky.empty()) choice.by_luck = (*std::min_element(lucky.begin(), lucky.end(), by_time))->setting;
    return choice;
  }
  const Merit& fastest = **std::min_element(enough.begin(), enough.end(), by_time);
  const double sure = significant_speed_ratio(time_spread);
  std::erase_if(enough, [&](const Merit* m) { return m->time > fastest.time * sure; });
  const auto by_error = [](const Merit* a, const Merit* b) { return shown_error(*a) < shown_error(*b); };
  choice.chosen =
      enough.front()->setting == 0 ? 0 : (*std::min_element(enough.begin(), enough.end(), by_error))->setting;
  if (fastest.time < merits[*choice.chosen].time) choice.faster = fastest.setting;
  const auto fastest_of = [&](std::vector<const Merit*> others) -> std::optional<std::size_t> {
    std::erase_if(others, [&](const Merit* m) { return m->time * sure > fastest.time; });
    if (others.empty()) return {};
    return (*std::min_element(others.begin(), others.end(), by_time))->setting;
  };
  choice.deeper = fastest_of(deeper);
  choice.by_luck = fastest_of(lucky);
  return choice;
}

std::vector<Order> orders_of(const Plan& plan, const Findings& found) {
  std::vector<Order> orders;
  std::set<std::size_t> taken;
  for (std::size_t s = 0; s < plan.settings.size(); ++s) {
    if (taken.count(s) > 0) continue;
    std::vector<double> steps, errors;
    const CompareSetting& reference = plan.reference;
    const bool alike = plan.settings[s].integrator == reference.integrator && reference.integrator != "reference" &&
                       found.judges.stand_in.empty() && reference.step < plan.settings[s].step;
    for (std::size_t other = s; other < plan.settings.size(); ++other) {
      CompareSetting same = plan.settings[other];
      same.step = plan.settings[s].step;
      if (!(same == plan.settings[s])) continue;
      taken.insert(other);
      const Merit& m = found.merits[other];
      // an error below the change of the reference itself is no error of another integrator
      if (!m.significant || m.failed > 0 || m.partial || (!alike && m.error < found.check.moves.value_or(0))) continue;
      if (alike && plan.settings[other].step <= reference.step) continue;
      steps.push_back(plan.settings[other].step);
      errors.push_back(m.error);
    }
    if (steps.size() < k_least_order_steps || !one_way(steps, errors)) continue;
    orders.push_back({label_without_step(plan.settings[s], plan.settings.front()),
                      order_of(steps, errors, alike ? reference.step : 0), static_cast<int>(steps.size())});
  }
  return orders;
}

bool anything_compared(const std::vector<Merit>& merits) {
  return std::any_of(merits.begin(), merits.end(),
                     [](const Merit& m) { return m.done > 0 && !m.judges && std::isfinite(m.error); });
}

}  // namespace nilas::compare
