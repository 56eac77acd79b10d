#include "apps/compare/scenes/run/pace.h"

#include <algorithm>

namespace nilas::compare {

std::string Pace::family(const PlannedRun& run) {
  return judges(run) ? name_of(run.kind) : "setting " + std::to_string(run.setting);
}

void Pace::took(const PlannedRun& run, double wall_s) {
  for (Sum* sum : {&families_[family(run)], &kinds_[judges(run)]}) {
    sum->took += wall_s;
    sum->estimate += run.estimate_s;
    ++sum->runs;
  }
}

void Pace::took(const Plan& plan, const std::map<std::string, RunResult>& results) {
  for (const auto& run : plan.runs)
    if (const auto known = results.find(run.id); known != results.end() && known->second.done())
      took(run, known->second.wall_s);
}

double Pace::factor() const {
  Sum all;
  for (const auto& [judging, sum] : kinds_) {
    all.took += sum.took;
    all.estimate += sum.estimate;
  }
  return all.estimate > 0 ? all.took / all.estimate : first_;
}

double Pace::expected_s(const PlannedRun& run) const {
  if (const auto known = families_.find(family(run)); known != families_.end())
    return known->second.took / known->second.runs;
  const auto kind = kinds_.find(judges(run));
  const bool told = kind != kinds_.end() && kind->second.estimate > 0;
  return run.estimate_s * (told ? kind->second.took / kind->second.estimate : factor());
}

double Pace::left_s(const Plan& plan, const std::map<std::string, RunResult>& results, int jobs) const {
  double sum = 0, longest = 0;
  for (const auto& run : plan.runs) {
    const auto known = results.find(run.id);
    if (known != results.end() && (known->second.done() || known->second.failed())) continue;
    const double expected = expected_s(run);
    sum += expected;
    longest = std::max(longest, expected);
  }
  return std::max(sum / std::max(1, jobs), longest);
}

double Pace::realisation_s(const Plan& plan, int jobs) const {
  double sum = 0;
  for (const auto& run : plan.runs)
    if (run.realisation == 0 && run.kind != RunKind::check) sum += expected_s(run);
  return sum / std::max(1, jobs);
}

}  // namespace nilas::compare
