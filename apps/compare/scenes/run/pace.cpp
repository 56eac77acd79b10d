#include "apps/compare/scenes/run/pace.h"

#include <algorithm>

namespace nilas::compare {

std::string Pace::family(const PlannedRun& run) {
  return judges(run) ? name_of(run.kind) : "setting " + std::to_string(run.setting);
}

double Pace::part(const PlannedRun& run, double share) const {
  if (!(run.estimate_s > 0)) return share;
  const double setup = std::min(setup_s_, run.estimate_s);
  return (setup + share * (run.estimate_s - setup)) / run.estimate_s;
}

void Pace::took(const PlannedRun& run, double wall_s, double share) {
  for (Sum* sum : {&families_[family(run)], &kinds_[judges(run)]}) {
    sum->took += wall_s / part(run, share);
    sum->estimate += run.estimate_s;
    ++sum->runs;
  }
}

void Pace::took(const Plan& plan, const std::map<std::string, RunResult>& results) {
  const double length = plan.end - plan.start;
  for (const auto& run : plan.runs)
    if (const auto known = results.find(run.id); known != results.end() && known->second.done()) {
      const double reached = known->second.summary.time_end_s - plan.start;
      took(run, known->second.wall_s, reached > length ? reached / length : 1);
    }
}

double Pace::factor() const {
  Sum all;
  for (const auto& [judging, sum] : kinds_) {
    all.took += sum.took;
    all.estimate += sum.estimate;
  }
  return all.estimate > 0 ? all.took / all.estimate : first_;
}

double Pace::whole_s(const PlannedRun& run) const {
  if (const auto known = families_.find(family(run)); known != families_.end())
    return known->second.took / known->second.runs;
  const auto kind = kinds_.find(judges(run));
  const bool told = kind != kinds_.end() && kind->second.estimate > 0;
  return run.estimate_s * (told ? kind->second.took / kind->second.estimate : factor());
}

double Pace::expected_s(const PlannedRun& run, double share) const { return whole_s(run) * part(run, share); }

double Pace::expected_setup_s(const PlannedRun& run) const { return whole_s(run) * part(run, 0); }

double Pace::left_s(const Plan& plan, const std::map<std::string, RunResult>& results, int jobs, double share) const {
  double sum = 0, longest = 0;
  for (const auto& run : plan.runs) {
    const auto known = results.find(run.id);
    if (known != results.end() && (known->second.done() || known->second.failed())) continue;
    const double expected = expected_s(run, share);
    sum += expected;
    longest = std::max(longest, expected);
  }
  return std::max(sum / std::max(1, jobs), longest);
}

double Pace::realisation_s(const Plan& plan, int jobs, double share) const {
  double sum = 0;
  for (const auto& run : plan.runs)
    if (run.realisation == 0 && run.kind != RunKind::check) sum += expected_s(run, share);
  return sum / std::max(1, jobs);
}

}  // namespace nilas::compare
