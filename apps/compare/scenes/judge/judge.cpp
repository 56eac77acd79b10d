#include "apps/compare/scenes/judge/judge.h"

#include "apps/compare/scenes/judge/floors.h"
#include "apps/compare/scenes/judge/judges.h"
#include "apps/compare/scenes/judge/load_errors.h"
#include "apps/compare/scenes/judge/loads.h"
#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/judge/motions.h"
#include "apps/compare/scenes/judge/pairing.h"
#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/judge/shared_realisations.h"

namespace nilas::compare {

Findings judge_runs(const Plan& plan, const std::map<std::string, RunResult>& results,
                    const std::filesystem::path& folder, Judged judged) {
  Findings f;
  f.rows = run_table(plan, results);
  f.judges = judges_of(plan, f.rows, judged);
  f.rows = with_judges(f.rows, f.judges);
  f.headline = headline_of(f.rows);
  f.shared = shared_of(plan, f.rows);

  // loads and motions of every run, and how far they are from the run that judges its realisation
  f.windows = windows_of(plan, f.rows, f.headline);
  f.rows = with_loads(plan, f.windows, folder, f.rows);
  f.rows = with_load_differences(plan, f.headline, f.rows);
  f.reference = reference_loads(f.rows, f.headline, f.shared);
  f.same_ice = same_ice(f.rows, f.shared, folder);
  f.horizon = horizon_of(plan, f.rows, folder);
  f.rows = with_motion_errors(plan, f.horizon, folder, f.rows);

  // settings: errors and costs, and which errors are more than chance
  f.measure = measure_of(f.rows, f.headline, f.reference, folder);
  f.merits = merits_of(plan, f.rows, f.judges, f.shared, f.headline, f.measure);
  f.chance = chance_of(plan, f.rows, f.judges, f.shared, f.headline, f.measure, f.merits);
  f.common_floor = common_floor(f.merits, f.judges, f.measure, f.chance, f.horizon);
  f.merits = with_floors(f.merits, f.judges, f.measure, f.chance, f.common_floor);
  f.check = step_check(f.rows, f.judges, f.measure, f.chance, f.merits);
  f.time_spread = time_spread(plan, f.rows);
  f.merits = with_time_spread(f.merits, f.time_spread);
  f.merits = with_faulty_parts(plan, f.measure, with_dominance(f.merits));
  if (f.measure.is_load()) f.merits = with_paired_differences(plan, f);
  if (f.measure.is_load() && judged != Judged::by_first_setting) {
    const LoadErrors errors = load_errors(plan, f);
    for (std::size_t k = 0; k < f.rows.size(); ++k) f.rows[k].load_error = errors.of_rows[k];
    f.coverage = errors.coverage;
    f.coverage_alone = errors.coverage_alone;
  }
  // where the ice did not touch the vessel, nothing is known of how a setting changes its loads
  if (judged != Judged::by_first_setting && (f.headline.empty() || f.measure.is_load()))
    f.choice = choose(f.merits, f.measure, f.common_floor, f.time_spread);
  f.orders = orders_of(plan, f);
  return f;
}

}  // namespace nilas::compare
