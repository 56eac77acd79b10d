#include "apps/compare/scenes/judge/shared_realisations.h"

#include <algorithm>

namespace nilas::compare {

namespace {

bool any(const std::vector<bool>& flags) { return std::find(flags.begin(), flags.end(), true) != flags.end(); }

std::vector<bool> both(const std::vector<bool>& a, const std::vector<bool>& b) {
  std::vector<bool> in_both(a.size(), false);
  for (std::size_t r = 0; r < a.size(); ++r) in_both[r] = a[r] && b[r];
  return in_both;
}

/// The realisations in both lists; `some` if there are none.
std::vector<bool> narrowed(const std::vector<bool>& some, const std::vector<bool>& wanted) {
  const std::vector<bool> left = both(some, wanted);
  return any(left) ? left : some;
}

}  // namespace

std::vector<int> shared_realisations(const std::vector<DoneRuns>& settings, const std::vector<bool>& judged) {
  if (settings.empty()) return {};
  std::vector<bool> open = narrowed(std::vector<bool>(judged.size(), true), judged);
  open = narrowed(open, settings.front().done);
  std::size_t ran = 0;
  std::vector<std::size_t> of_realisation(open.size(), 0);
  for (const auto& setting : settings) {
    if (setting.failed || !any(both(setting.done, open))) continue;
    ++ran;
    for (std::size_t r = 0; r < open.size(); ++r) of_realisation[r] += open[r] && setting.done[r] ? 1 : 0;
  }
  const std::size_t most = *std::max_element(of_realisation.begin(), of_realisation.end());
  if (most == 0) return {};
  std::vector<int> shared;
  constexpr std::size_t k_quarters = 3, k_of = 4;
  for (std::size_t r = 0; r < open.size(); ++r)
    if (of_realisation[r] * k_of >= ran * k_quarters) shared.push_back(static_cast<int>(r));
  if (shared.empty())
    shared.push_back(
        static_cast<int>(std::max_element(of_realisation.begin(), of_realisation.end()) - of_realisation.begin()));
  return shared;
}

std::vector<int> shared_of(const Plan& plan, const RunTable& rows) {
  std::vector<DoneRuns> settings(plan.settings.size());
  const auto count = static_cast<std::size_t>(plan.realisations);
  std::vector<bool> judged(count, false);
  for (auto& setting : settings) setting.done.resize(count, false);
  for (const auto& row : rows) {
    const auto r = static_cast<std::size_t>(row.run.realisation);
    if (row.judges) judged[r] = true;
    if (row.run.kind != RunKind::grid) continue;
    DoneRuns& runs = settings[row.run.setting];
    if (row.result.done()) runs.done[r] = true;
    runs.failed = runs.failed || row.result.failed();
  }
  return shared_realisations(settings, judged);
}

}  // namespace nilas::compare
