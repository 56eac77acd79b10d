/// The tables of a comparison.
#include "apps/compare/scenes/report/tables.h"

#include <array>

#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/workshop/csv_table.h"
#include "apps/compare/workshop/special_numbers.h"

namespace nilas::compare {

namespace {

struct NamedStatistic {
  const char* name;
  double output::LoadStatistics::*member;
};
constexpr std::array<NamedStatistic, 4> k_statistics{{{"mean", &output::LoadStatistics::mean},
                                                      {"std", &output::LoadStatistics::std},
                                                      {"max", &output::LoadStatistics::max},
                                                      {"p99", &output::LoadStatistics::p99}}};

/// The column of a statistic: contact_fx_N with mean gives contact_fx_mean_N.
std::string statistic_column(const std::string& channel, const std::string& statistic) {
  const auto unit = channel.rfind('_');
  return channel.substr(0, unit) + "_" + statistic + channel.substr(unit);
}

/// The load channels of the first run that has any.
std::vector<std::string> channels_of(const RunTable& rows) {
  std::vector<std::string> channels;
  for (const auto& row : rows) {
    for (const auto& [name, statistics] : row.result.summary.loads) channels.push_back(name);
    if (!channels.empty()) break;
  }
  return channels;
}

/// Adds the columns of a setting. `setting` returns the setting of a row, which is empty if it has none.
template <class Row, class Setting>
void add_setting_columns(std::vector<CsvColumn<Row>>& columns, const Setting& setting) {
  columns.push_back({"solver", [=](const Row& r, CsvCell cell) { cell = setting(r).solver; }});
  columns.push_back({"law", [=](const Row& r, CsvCell cell) { cell = setting(r).law; }});
  columns.push_back({"step_s", [=](const Row& r, CsvCell cell) { cell = setting(r).step; }});
  columns.push_back({"tolerance_m_s", [=](const Row& r, CsvCell cell) { cell = setting(r).tolerance; }});
  columns.push_back({"stabilisation", [=](const Row& r, CsvCell cell) { cell = setting(r).stabilisation; }});
  columns.push_back({"integrator", [=](const Row& r, CsvCell cell) { cell = setting(r).integrator; }});
  columns.push_back({"simplifications", [=](const Row& r, CsvCell cell) { cell = simplifications_text(setting(r)); }});
}

template <class Row, class Value>
void add(std::vector<CsvColumn<Row>>& columns, const std::string& name, const Value& value) {
  columns.push_back({name, [=](const Row& row, CsvCell cell) { cell = value(row); }});
}

using RunColumns = std::vector<CsvColumn<RunRow>>;

void add_identity_columns(const SceneStudy& study, RunColumns& columns) {
  add(columns, "id", [](const RunRow& r) { return r.run.id; });
  add(columns, "kind", [](const RunRow& r) { return name_of(r.run.kind); });
  add_setting_columns(columns, [&](const RunRow& r) {
    const bool given = r.run.kind == RunKind::reference && study.reference != "auto";
    return given ? CompareSetting{"", "", "", "", k_unknown, k_unknown} : study.plan.setting_of(r.run);
  });
  add(columns, "realisation", [](const RunRow& r) { return r.run.realisation; });
  const auto overrides = [&](const RunRow& r) {
    return realisation_overrides(study.seed, r.run, study.plan.vary_seed);
  };
  add(columns, "seed", [=](const RunRow& r) { return overrides(r)[0].second; });
  add(columns, "twin", [=](const RunRow& r) { return overrides(r)[1].second; });
  add(columns, "status", [](const RunRow& r) { return r.result.status; });
  add(columns, "cause", [](const RunRow& r) { return without_commas(r.result.cause); });
}

void add_time_columns(const Plan& plan, RunColumns& columns) {
  const auto if_begun = [](const RunRow& r, double time) { return r.result.wall_s > 0 ? time : k_unknown; };
  add(columns, "simulated_s", [&](const RunRow& r) { return r.result.summary.time_end_s - plan.start; });
  add(columns, "cpu_s", [=](const RunRow& r) { return if_begun(r, r.result.cpu_s); });
  add(columns, "wall_s", [=](const RunRow& r) { return if_begun(r, r.result.wall_s); });
  add(columns, "compute_s_per_s", [](const RunRow& r) { return r.result.compute_per_second(); });
  add(columns, "ms_per_step", [](const RunRow& r) { return r.result.ms_per_step(); });
  for (std::size_t p = 0; p < sim::k_num_phases; ++p)
    add(columns, std::string("ms_") + sim::to_string(static_cast<sim::Phase>(p)),
        [p](const RunRow& r) { return r.result.summary.phase_ms[p]; });
}

void add_error_columns(RunColumns& columns) {
  const auto of_motion = [](double MotionError::*member) {
    return [member](const RunRow& r) { return r.motion ? (*r.motion).*member : k_unknown; };
  };
  const auto along = [](Eigen::Index axis) {
    return [axis](const RunRow& r) { return r.motion ? r.motion->axes_m[axis] : k_unknown; };
  };
  const auto part = [](double LoadErrorParts::*member) {
    return [member](const RunRow& r) { return r.load_error ? (*r.load_error).*member : k_unknown; };
  };
  add(columns, "load_difference_N", [](const RunRow& r) { return r.load_difference.value_or(k_unknown); });
  add(columns, "own_difference_N", [](const RunRow& r) { return r.own_difference.value_or(k_unknown); });
  add(columns, "motion_rms_m", of_motion(&MotionError::rms_m));
  add(columns, "motion_largest_m", of_motion(&MotionError::largest_m));
  add(columns, "motion_x_m", along(0));
  add(columns, "motion_y_m", along(1));
  add(columns, "motion_z_m", along(2));
  add(columns, "turn_rad", of_motion(&MotionError::turn_rad));
  add(columns, "penetration_max_m", [](const RunRow& r) { return r.result.summary.penetration_max_m; });
  add(columns, "penetration_mean_m", [](const RunRow& r) { return r.result.penetration_mean_m; });
  add(columns, "imbalance_relative", [](const RunRow& r) { return r.result.summary.imbalance_relative; });
  add(columns, "momentum_imbalance_relative",
      [](const RunRow& r) { return r.result.summary.momentum_imbalance_relative; });
  add(columns, "stabilisation_J", [](const RunRow& r) { return r.result.stabilisation_J; });
  add(columns, "load_error_estimate_N",
      [](const RunRow& r) { return r.load_error ? r.load_error->total() : k_unknown; });
  add(columns, "load_error_solver_N", part(&LoadErrorParts::solver));
  add(columns, "load_error_law_N", part(&LoadErrorParts::law));
  add(columns, "load_error_chaos_N", part(&LoadErrorParts::chaos));
  add(columns, "load_error_step_N", part(&LoadErrorParts::step));
  add(columns, "load_error_alone_N", part(&LoadErrorParts::alone));
}

void add_summary_columns(const std::vector<std::string>& channels, RunColumns& columns) {
  add(columns, "unconverged_steps", [](const RunRow& r) { return r.result.summary.unconverged_steps; });
  add(columns, "steps", [](const RunRow& r) { return r.result.summary.steps; });
  add(columns, "step_load_error_median_1", [](const RunRow& r) { return r.result.summary.step_load_median; });
  add(columns, "step_load_error_p95_1", [](const RunRow& r) { return r.result.summary.step_load_p95; });
  add(columns, "floes_end", [](const RunRow& r) { return r.result.summary.floes_end; });
  for (const auto& residual : contact::residual_columns())
    add(columns, residual.name,
        [member = residual.member](const RunRow& r) { return r.result.summary.residuals.*member; });
  for (const auto& channel : channels)
    for (const auto& statistic : k_statistics)
      add(columns, statistic_column(channel, statistic.name),
          [=](const RunRow& r) { return load_statistics_of(r, channel).*statistic.member; });
}

/// The figures of a difference; NaN or empty without one.
double mean_difference(const PairedDifference& d) { return d.realisations.empty() ? k_unknown : d.mean; }
double half_width(const PairedDifference& d) { return d.realisations.empty() ? k_unknown : d.half_width; }
std::string certainty_of(const PairedDifference& d) { return d.realisations.empty() ? "" : name_of(d.certainty); }

using MeritColumns = std::vector<CsvColumn<Merit>>;

void add_judgement_columns(const SceneReport& report, MeritColumns& columns) {
  const Findings& found = report.found;
  const std::string& unit = found.measure.unit;
  add(columns, "number", [](const Merit& m) { return static_cast<int>(m.setting) + 1; });
  add(columns, "label", [&](const Merit& m) { return report.label(m.setting); });
  add_setting_columns(columns, [&](const Merit& m) { return report.study.plan.settings[m.setting]; });
  add(columns, "trouble", [](const Merit& m) { return without_commas(m.trouble); });
  add(columns, "runs", [](const Merit& m) { return m.planned; });
  add(columns, "done", [](const Merit& m) { return m.done; });
  add(columns, "compute_s_per_s", [](const Merit& m) { return m.time; });
  add(columns, "compute_spread_s_per_s", [](const Merit& m) { return m.time_spread; });
  add(columns, "ms_per_step", [](const Merit& m) { return m.ms_per_step; });
  add(columns, "error_" + unit, [](const Merit& m) { return m.error; });
  add(columns, "floor_" + unit, [](const Merit& m) { return m.floor; });
  add(columns, "told_from_chaos", [](const Merit& m) { return m.significant; });
  add(columns, "reference_moves_" + unit, [&](const Merit&) { return found.check.moves.value_or(k_unknown); });
  add(columns, "dominated", [](const Merit& m) { return m.dominated; });
  add(columns, "chosen", [&](const Merit& m) { return found.choice.chosen == m.setting; });
}

void add_load_columns(MeritColumns& columns) {
  add(columns, "load_N", [](const Merit& m) { return m.load.mean; });
  add(columns, "load_se_N", [](const Merit& m) { return m.load.standard_error; });
  add(columns, "load_difference_N", [](const Merit& m) { return m.load_difference.mean; });
  add(columns, "load_difference_se_N", [](const Merit& m) { return m.load_difference.standard_error; });
  add(columns, "load_difference_95_N", [](const Merit& m) { return half_width(m.from_reference); });
  add(columns, "load_difference_sure", [](const Merit& m) { return certainty_of(m.from_reference); });
  add(columns, "own_difference_N", [](const Merit& m) { return mean_difference(m.from_own); });
  add(columns, "own_difference_95_N", [](const Merit& m) { return half_width(m.from_own); });
  add(columns, "own_difference_sure", [](const Merit& m) { return certainty_of(m.from_own); });
  add(columns, "realisations", [](const Merit& m) { return list_text(m.realisations); });
  add(columns, "partial", [](const Merit& m) { return m.partial; });
  add(columns, "load_std_N", [](const Merit& m) { return m.load_std.mean; });
  add(columns, "load_max_N", [](const Merit& m) { return m.load_max.mean; });
  add(columns, "load_p99_N", [](const Merit& m) { return m.load_p99.mean; });
}

void add_accuracy_columns(MeritColumns& columns) {
  add(columns, "motion_rms_m", [](const Merit& m) { return m.motion.mean; });
  add(columns, "motion_rms_se_m", [](const Merit& m) { return m.motion.standard_error; });
  add(columns, "turn_rad", [](const Merit& m) { return m.turn.mean; });
  add(columns, "penetration_max_m", [](const Merit& m) { return m.penetration_max_m; });
  add(columns, "penetration_mean_m", [](const Merit& m) { return m.penetration_mean_m; });
  add(columns, "law_map_m_s", [](const Merit& m) { return m.law_map_m_s; });
  add(columns, "natural_map_m_s", [](const Merit& m) { return m.natural_map_m_s; });
  add(columns, "step_load_error_median_1", [](const Merit& m) { return m.step_load_median; });
  add(columns, "step_load_error_p95_1", [](const Merit& m) { return m.step_load_p95; });
  add(columns, "imbalance_relative", [](const Merit& m) { return m.energy_error; });
  add(columns, "momentum_imbalance_relative", [](const Merit& m) { return m.momentum_error; });
  add(columns, "unconverged_share", [](const Merit& m) { return m.unconverged_share; });
}

/// A row of loads.csv.
struct LoadRow {
  const Merit* setting;
  std::string channel;
  const char* statistic;
  Estimate value, difference;
};

LoadRow load_row(const RunTable& rows, const Merit& m, const std::string& channel, const NamedStatistic& statistic) {
  std::vector<double> values, differences;
  for (const int r : m.realisations) {
    values.push_back(load_statistics_of(*done_run(rows, RunKind::grid, m.setting, r), channel).*statistic.member);
    if (const RunRow* judge = judge_of(rows, r))
      differences.push_back(values.back() - load_statistics_of(*judge, channel).*statistic.member);
  }
  return {&m, channel, statistic.name, estimate_of(values), estimate_of(differences)};
}

}  // namespace

std::string runs_csv(const SceneReport& report) {
  RunColumns columns;
  add_identity_columns(report.study, columns);
  add_time_columns(report.study.plan, columns);
  add_error_columns(columns);
  add_summary_columns(channels_of(report.found.rows), columns);
  return csv_text(columns, report.found.rows);
}

std::string settings_csv(const SceneReport& report) {
  MeritColumns columns;
  add_judgement_columns(report, columns);
  add_load_columns(columns);
  add_accuracy_columns(columns);
  return csv_text(columns, report.found.merits);
}

std::string loads_csv(const SceneReport& report) {
  std::vector<LoadRow> rows;
  const auto channels = channels_of(report.found.rows);
  for (const auto& m : report.found.merits)
    for (const auto& channel : channels)
      for (const auto& statistic : k_statistics) rows.push_back(load_row(report.found.rows, m, channel, statistic));
  std::vector<CsvColumn<LoadRow>> columns;
  add(columns, "number", [](const LoadRow& r) { return static_cast<int>(r.setting->setting) + 1; });
  add(columns, "label", [&](const LoadRow& r) { return report.label(r.setting->setting); });
  add(columns, "channel", [](const LoadRow& r) { return r.channel; });
  add(columns, "statistic", [](const LoadRow& r) { return r.statistic; });
  add(columns, "unit", [](const LoadRow& r) { return r.channel.substr(r.channel.rfind('_') + 1); });
  add(columns, "realisations", [](const LoadRow& r) { return list_text(r.setting->realisations); });
  add(columns, "runs", [](const LoadRow& r) { return r.value.count; });
  add(columns, "value", [](const LoadRow& r) { return r.value.mean; });
  add(columns, "standard_error", [](const LoadRow& r) { return r.value.standard_error; });
  add(columns, "difference", [](const LoadRow& r) { return r.difference.mean; });
  add(columns, "difference_standard_error", [](const LoadRow& r) { return r.difference.standard_error; });
  return csv_text(columns, rows);
}

}  // namespace nilas::compare
