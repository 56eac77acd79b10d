#include "apps/compare/scenes/judge/judges.h"

#include <algorithm>
#include <tuple>

namespace nilas::compare {

namespace {

bool judges_others(const RunRow& row, const Judges& judges) {
  if (!row.result.done()) return false;
  return judges.setting ? row.is_grid(*judges.setting) : row.run.kind == judges.kind;
}

bool any_of_kind_done(const RunTable& rows, RunKind kind) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const RunRow& row) { return row.run.kind == kind && row.result.done(); });
}

/// The most accurate setting that has a run which is done; nothing if there is none.
std::optional<std::size_t> most_accurate(const Plan& plan, const RunTable& rows) {
  const auto coarseness = [&](std::size_t setting) {
    const CompareSetting& s = plan.settings[setting];
    return std::tuple(s.law != "coulomb", s.step, s.tolerance == 0, s.tolerance);
  };
  std::optional<std::size_t> finest;
  for (const auto& row : rows)
    if (row.run.kind == RunKind::grid && row.result.done() &&
        (!finest || coarseness(row.run.setting) < coarseness(*finest)))
      finest = row.run.setting;
  return finest;
}

/// Replaces a reference that has no run by the runs that come nearest to it.
void replace_reference(const Plan& plan, const RunTable& rows, Judges& judges) {
  if (any_of_kind_done(rows, RunKind::check)) {
    judges.kind = RunKind::check;
    judges.stand_in = "the reference at twice its step";
  } else if (const auto finest = most_accurate(plan, rows)) {
    judges.setting = finest;
    judges.stand_in = '"' + label_of(plan.settings[*finest], plan.settings.front()) + '"';
  }
}

}  // namespace

Judges judges_of(const Plan& plan, const RunTable& rows, Judged judged) {
  Judges judges;
  judges.one_run = judged == Judged::by_one_run;
  if (judged == Judged::by_first_setting) {
    judges.setting = 0;
  } else {
    for (const auto& row : rows)
      if (row.run.kind == RunKind::reference && !row.result.done() && judges.trouble.empty())
        judges.trouble = row.result.status + (row.result.cause.empty() ? "" : ": " + row.result.cause);
    if (!any_of_kind_done(rows, RunKind::reference)) replace_reference(plan, rows, judges);
  }
  judges.realisations = static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [&](const RunRow& row) { return judges_others(row, judges); }));
  return judges;
}

RunTable with_judges(RunTable rows, const Judges& judges) {
  for (auto& row : rows) row.judges = judges_others(row, judges);
  return rows;
}

}  // namespace nilas::compare
