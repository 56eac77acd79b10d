#include "apps/compare/problems/problem_profiles.h"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"

namespace nilas::compare {

SolveTimes time_ratios(const SolveTimes& times) {
  SolveTimes ratios = times;
  for (auto& row : ratios) {
    const double best = row.empty() ? k_unsolved : *std::min_element(row.begin(), row.end());
    for (double& t : row) {
      if (!std::isfinite(t)) continue;
      t = t == best ? 1 : t / best;
    }
  }
  return ratios;
}

std::vector<Profile> profiles(const SolveTimes& values) {
  std::vector<Profile> all(values.empty() ? 0 : values.front().size());
  for (std::size_t s = 0; s < all.size(); ++s) {
    std::vector<double> own;
    for (const auto& row : values)
      if (std::isfinite(row[s])) own.push_back(row[s]);
    std::sort(own.begin(), own.end());
    for (std::size_t k = 0; k < own.size(); ++k) {
      const double share = static_cast<double>(k + 1) / static_cast<double>(values.size());
      if (k > 0 && own[k] == own[k - 1])
        all[s].back().share = share;
      else
        all[s].push_back({own[k], share});
    }
  }
  return all;
}

std::vector<SolverScore> scores(const SolveTimes& times) {
  std::vector<SolverScore> all(times.empty() ? 0 : times.front().size());
  std::vector<double> logs(all.size());
  for (const auto& row : time_ratios(times))
    for (std::size_t s = 0; s < all.size(); ++s) {
      ++all[s].problems;
      if (!std::isfinite(row[s])) continue;
      ++all[s].solved;
      if (row[s] == 1) ++all[s].fastest;
      logs[s] += std::log(row[s]);
    }
  for (std::size_t s = 0; s < all.size(); ++s)
    if (all[s].solved > 0) all[s].mean_ratio = std::exp(logs[s] / static_cast<double>(all[s].solved));
  return all;
}

double median(const std::vector<double>& values) { return values.empty() ? k_unsolved : median_of(values); }

}  // namespace nilas::compare
