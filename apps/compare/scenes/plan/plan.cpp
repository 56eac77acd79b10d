#include "apps/compare/scenes/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nilas::compare {

const CompareSetting& Plan::setting_of(const PlannedRun& run) const {
  if (run.kind == RunKind::reference) return reference;
  return run.kind == RunKind::check ? check : settings[run.setting];
}

double Plan::coarsest_end(double t) const {
  const double step = coarsest_step(settings);
  return start + std::floor((t - start) / step + k_step_rounding) * step;
}

double rounded_budget(double seconds) {
  const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(seconds)) - 1));
  return std::ceil(seconds / unit) * unit;
}

std::vector<Omission> absent_simplifications(const scene::Scene& scene) {
  std::vector<Omission> absent;
  for (const Simplification which : all_simplifications())
    if (const std::string why = no_effect(which, scene); !why.empty()) absent.push_back({name_of(which), why});
  return absent;
}

std::vector<std::string> by_reason(const std::vector<Omission>& omissions) {
  std::vector<std::string> reasons, lists;
  for (const auto& omission : omissions) {
    const auto known = std::find(reasons.begin(), reasons.end(), omission.why);
    if (known == reasons.end()) {
      reasons.push_back(omission.why);
      lists.push_back(omission.why + ": " + omission.what);
    } else {
      lists[known - reasons.begin()] += "; " + omission.what;
    }
  }
  return lists;
}

const char* name_of(RunKind kind) {
  switch (kind) {
    case RunKind::grid:
      return "grid";
    case RunKind::twin:
      return "twin";
    case RunKind::reference:
      return "reference";
    case RunKind::check:
      return "check";
  }
  return "";
}

void extend_realisations(Plan& plan, int realisations) {
  const std::vector<PlannedRun> known = plan.runs;
  for (int r = plan.realisations; r < realisations; ++r)
    for (const auto& run : known) {
      if (run.realisation != 0 || run.kind == RunKind::check) continue;
      PlannedRun more = run;
      more.realisation = r;
      const std::string first = "-r0";
      more.id.replace(more.id.find(first), first.size(), fmt::format("-r{}", r));
      plan.runs.push_back(more);
    }
  plan.realisations = std::max(plan.realisations, realisations);
}

scene::Overrides realisation_overrides(std::uint64_t seed, const PlannedRun& run, bool vary_seed) {
  const auto number = static_cast<std::uint64_t>(run.realisation);
  constexpr std::uint64_t k_twins = 1000;  // above any number of realisations
  const std::uint64_t twin = run.kind == RunKind::twin ? k_twins + number : number;
  return {{"seed/@value", std::to_string(vary_seed ? seed + number : seed)}, {"seed/@twin", std::to_string(twin)}};
}

}  // namespace nilas::compare
