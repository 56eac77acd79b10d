#include "apps/compare/scenes/report/plan_text.h"

#include <fmt/format.h>

#include "core/output/text/console.h"

namespace nilas::compare {

std::vector<std::string> plan_lines(const SceneStudy& study, double left_s) {
  const Plan& plan = study.plan;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{} runs: {} settings x {} realisation{}, {:g} s simulated; about {} with {} job{}",
                              plan.runs.size(), plan.settings.size(), plan.realisations,
                              plan.realisations == 1 ? "" : "s", plan.end - plan.start,
                              output::duration_text(plan.estimate_s), study.jobs, study.jobs == 1 ? "" : "s"));
  if (plan.estimate_s > left_s)
    lines.push_back(
        fmt::format("The estimate exceeds the {} that are left of the budget of {:g} s. Less time is then simulated, "
                    "and a run that is expected to take more than is left does not begin.",
                    output::duration_text(left_s), study.budget_s));
  lines.push_back((study.ablation ? "without simplifications: " : "own setting: ") + full_label(plan.settings.front()));
  std::string others;
  for (std::size_t k = 1; k < plan.settings.size(); ++k)
    others += (others.empty() ? "" : "; ") + label_of(plan.settings[k], plan.settings.front());
  lines.push_back("other settings: " + others);
  if (plan.realisations > 0 && !study.ablation && study.reference == "auto")
    lines.push_back("reference: " + full_label(plan.reference));
  for (const auto& list : by_reason(plan.omissions)) lines.push_back("left out for " + list);
  for (const auto& refused : study.refused)
    lines.push_back(fmt::format("cannot run: {}: {}", refused.what, refused.why));
  return lines;
}

std::string shorter_line(const Plan& plan, double before, double factor) {
  return fmt::format(
      "Runs take {:.2g} times as long as measured. To keep the budget, all are compared over {:g} s of simulated time "
      "instead of {:g} s.",
      factor, plan.end - plan.start, before - plan.start);
}

}  // namespace nilas::compare
