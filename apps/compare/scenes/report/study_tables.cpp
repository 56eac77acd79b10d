/// The tables and JSON of a comparison.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "apps/compare/scenes/report/paired_text.h"
#include "apps/compare/scenes/report/study_outputs.h"
#include "contact/measure/measure.h"
#include "core/output/file/csv_row.h"
#include "core/sim/account/step_record.h"

namespace nilas {

namespace {

using Json = nlohmann::ordered_json;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// contact_fx_N with mean gives contact_fx_mean_N.
std::string statistic_column(const std::string& channel, const std::string& statistic) {
  const auto unit = channel.rfind('_');
  return channel.substr(0, unit) + "_" + statistic + channel.substr(unit);
}

std::vector<std::string> channels_of(const Findings& found) {
  for (const auto& row : found.rows) {
    if (!row.result.summary.contains("loads") || row.result.summary.at("loads").empty()) continue;
    std::vector<std::string> channels;
    for (const auto& [name, value] : row.result.summary.at("loads").items()) channels.push_back(name);
    return channels;
  }
  return {};
}

constexpr std::array k_statistics{"mean", "std", "max", "p99"};

std::vector<std::string> run_columns(const std::vector<std::string>& channels) {
  std::vector<std::string> names{"id",
                                 "kind",
                                 "solver",
                                 "law",
                                 "step_s",
                                 "tolerance_m_s",
                                 "stabilisation",
                                 "integrator",
                                 "simplifications",
                                 "realisation",
                                 "seed",
                                 "twin",
                                 "status",
                                 "cause",
                                 "simulated_s",
                                 "cpu_s",
                                 "wall_s",
                                 "compute_s_per_s",
                                 "ms_per_step"};
  for (int p = 0; p < k_num_phases; ++p) names.push_back(std::string("ms_") + to_string(static_cast<Phase>(p)));
  for (const char* name : {"load_difference_N",
                           "own_difference_N",
                           "motion_rms_m",
                           "motion_largest_m",
                           "motion_x_m",
                           "motion_y_m",
                           "motion_z_m",
                           "turn_rad",
                           "penetration_max_m",
                           "penetration_mean_m",
                           "imbalance_relative",
                           "momentum_imbalance_relative",
                           "stabilisation_J",
                           "load_error_estimate_N",
                           "load_error_solver_N",
                           "load_error_law_N",
                           "load_error_chaos_N",
                           "load_error_step_N",
                           "load_error_alone_N",
                           "unconverged_steps",
                           "steps",
                           "floes_end"})
    names.emplace_back(name);
  for (const auto& residual : residual_columns()) names.emplace_back(residual.name);
  for (const auto& channel : channels)
    for (const char* statistic : k_statistics) names.push_back(statistic_column(channel, statistic));
  return names;
}

std::string simplifications_text(const CompareSetting& setting) {
  std::string text;
  for (const Simplification which : setting.simplifications)
    text += std::string(text.empty() ? "" : ";") + name_of(which);
  return text;
}

/// Numbers as short as they read back; what is not known stays empty.
class Cells {
 public:
  Cells& number(double value) {
    std::isfinite(value) ? row_.shortest(value) : row_.text("");
    return *this;
  }
  Cells& text(const std::string& word) {
    row_.text(word);
    return *this;
  }
  /// Without commas, for readers that know no quotes.
  Cells& words(std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), ',', ';');
    return text(sentence);
  }
  std::string line() { return std::string(row_.line()); }

 private:
  CsvRow row_;
};

void add_setting(const CompareSetting& setting, Cells& cells) {
  cells.text(setting.solver).text(setting.law).number(setting.step).number(setting.tolerance);
  cells.text(setting.stabilisation).text(setting.integrator).text(simplifications_text(setting));
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Estimate& e) {
  return {{"mean", number_or_null(e.mean)}, {"standard_error", number_or_null(e.standard_error)}, {"runs", e.count}};
}

/// Figures of a difference; empty of none.
double mean_of(const PairedDifference& d) { return d.realisations.empty() ? k_nan : d.mean; }
double half_width(const PairedDifference& d) { return d.realisations.empty() ? k_nan : d.half_width; }
std::string certainty_of(const PairedDifference& d) { return d.realisations.empty() ? "" : name_of(d.certainty); }

/// "0;1"
std::string list_text(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : ";") + std::to_string(n);
  return text;
}

Json numbers_or_null(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

Json json_of(const PairedDifference& d) {
  if (d.realisations.empty()) return nullptr;
  return {{"realisations", d.realisations},
          {"differences_N", numbers_or_null(d.values)},
          {"chance_limits_N", numbers_or_null(d.limits)},
          {"mean_N", number_or_null(d.mean)},
          {"half_width_95_N", number_or_null(d.half_width)},
          {"beyond_chance", d.beyond_chance},
          {"sure", name_of(d.certainty)}};
}

Json windows_json(const Findings& found) {
  Json windows = Json::array();
  for (const auto& span : found.windows)
    windows.push_back(span ? Json{{"from_s", span->from}, {"to_s", span->to}, {"reason", span->reason}}
                           : Json(nullptr));
  return windows;
}

Json json_of(const std::optional<Coverage>& c) {
  return c ? Json{{"runs", c->runs}, {"share", c->share}, {"median_width", number_or_null(c->width)}} : Json(nullptr);
}

}  // namespace

std::string StudyOutputs::runs_csv() const {
  const auto channels = channels_of(found_);
  std::string csv = csv_header(run_columns(channels));
  for (const auto& row : found_.rows) {
    const RunResult& result = row.result;
    const bool began = result.wall_s > 0;
    const bool given = row.run.kind == RunKind::reference && study_.reference != "auto";
    Cells cells;
    cells.text(row.run.id).text(name_of(row.run.kind));
    add_setting(given ? CompareSetting{"", "", "", "", k_nan, k_nan} : study_.plan.setting_of(row.run), cells);
    cells.number(row.run.realisation);
    const Overrides realisation = realisation_overrides(study_.seed, row.run, study_.plan.vary_seed);
    cells.text(realisation[0].second).text(realisation[1].second).text(result.status).words(result.cause);
    cells.number(result.number("/time_end_s") - study_.plan.start)
        .number(began ? result.cpu_s : k_nan)
        .number(began ? result.wall_s : k_nan);
    cells.number(result.compute_per_second()).number(result.ms_per_step());
    for (int p = 0; p < k_num_phases; ++p) cells.number(result.phase_ms(to_string(static_cast<Phase>(p))));
    cells.number(row.load_difference.value_or(k_nan)).number(row.own_difference.value_or(k_nan));
    const MotionError none{k_nan, k_nan, Vec3::Constant(k_nan), k_nan}, &motion = row.motion ? *row.motion : none;
    cells.number(motion.rms_m).number(motion.largest_m);
    for (const double axis : motion.axes_m) cells.number(axis);
    cells.number(motion.turn_rad)
        .number(result.number("/worst/penetration_max_m/value"))
        .number(result.penetration_mean_m);
    cells.number(result.number("/worst/imbalance_J/relative_to_energy_put_in"));
    cells.number(result.number("/worst/momentum_imbalance_relative/value")).number(result.stabilisation_J);
    const LoadErrorParts parts = row.load_error.value_or(LoadErrorParts{k_nan, k_nan, k_nan, k_nan, k_nan});
    cells.number(row.load_error ? parts.total() : k_nan).number(parts.solver).number(parts.law);
    cells.number(parts.chaos).number(parts.step).number(parts.alone);
    for (const char* path : {"/shortfalls/unconverged_steps", "/steps", "/ice/floes_end"})
      cells.number(result.number(path));
    for (const auto& residual : residual_columns())
      cells.number(result.number(std::string("/worst/") + residual.name + "/value"));
    for (const auto& channel : channels)
      for (const char* statistic : k_statistics) cells.number(load_statistic(row, channel, statistic));
    csv += cells.line();
  }
  return csv;
}

std::string StudyOutputs::settings_csv() const {
  std::string csv = csv_header({"number",
                                "label",
                                "solver",
                                "law",
                                "step_s",
                                "tolerance_m_s",
                                "stabilisation",
                                "integrator",
                                "simplifications",
                                "trouble",
                                "runs",
                                "done",
                                "compute_s_per_s",
                                "compute_spread_s_per_s",
                                "ms_per_step",
                                "error_" + found_.unit,
                                "floor_" + found_.unit,
                                "told_from_chaos",
                                "reference_moves_" + found_.unit,
                                "dominated",
                                "chosen",
                                "load_N",
                                "load_se_N",
                                "load_difference_N",
                                "load_difference_se_N",
                                "load_difference_95_N",
                                "load_difference_sure",
                                "own_difference_N",
                                "own_difference_95_N",
                                "own_difference_sure",
                                "realisations",
                                "partial",
                                "load_std_N",
                                "load_max_N",
                                "load_p99_N",
                                "motion_rms_m",
                                "motion_rms_se_m",
                                "turn_rad",
                                "penetration_max_m",
                                "penetration_mean_m",
                                "law_map_m_s",
                                "natural_map_m_s",
                                "imbalance_relative",
                                "momentum_imbalance_relative",
                                "unconverged_share"});
  for (const auto& m : found_.merits) {
    const CompareSetting& setting = study_.plan.settings[m.setting];
    Cells cells;
    cells.number(static_cast<double>(m.setting + 1)).text(label(m.setting));
    add_setting(setting, cells);
    cells.words(m.trouble).number(m.planned).number(m.done).number(m.time).number(m.time_spread).number(m.ms_per_step);
    cells.number(m.error).number(m.floor).number(m.told ? 1 : 0);
    cells.number(found_.reference_moves.value_or(k_nan)).number(m.dominated ? 1 : 0);
    cells.number(found_.chosen == m.setting ? 1 : 0);
    cells.number(m.load.mean).number(m.load.standard_error);
    cells.number(m.load_difference.mean).number(m.load_difference.standard_error);
    cells.number(half_width(m.from_reference)).text(certainty_of(m.from_reference));
    cells.number(mean_of(m.from_own)).number(half_width(m.from_own)).text(certainty_of(m.from_own));
    cells.text(list_text(m.realisations)).number(m.partial ? 1 : 0);
    cells.number(m.load_std.mean).number(m.load_max.mean).number(m.load_p99.mean);
    cells.number(m.motion.mean).number(m.motion.standard_error).number(m.turn.mean);
    cells.number(m.penetration_max_m).number(m.penetration_mean_m).number(m.law_map_m_s).number(m.natural_map_m_s);
    cells.number(m.energy_error).number(m.momentum_error).number(m.unconverged_share);
    csv += cells.line();
  }
  return csv;
}

std::string StudyOutputs::loads_csv() const {
  std::string csv = csv_header({"number", "label", "channel", "statistic", "unit", "realisations", "runs", "value",
                                "standard_error", "difference", "difference_standard_error"});
  const auto channels = channels_of(found_);
  for (const auto& m : found_.merits)
    for (const auto& channel : channels)
      for (const char* statistic : k_statistics) {
        std::vector<double> values, differences;
        for (const int r : m.realisations) {
          const RunRow* row = done_run(found_, RunKind::grid, m.setting, r);
          values.push_back(load_statistic(*row, channel, statistic));
          if (const RunRow* reference = reference_of(found_, r))
            differences.push_back(values.back() - load_statistic(*reference, channel, statistic));
        }
        const Estimate value = estimate_of(values), difference = estimate_of(differences);
        Cells cells;
        cells.number(static_cast<double>(m.setting + 1)).text(label(m.setting)).text(channel).text(statistic);
        cells.text(channel.substr(channel.rfind('_') + 1)).text(list_text(m.realisations)).number(value.count);
        cells.number(value.mean).number(value.standard_error);
        cells.number(difference.mean).number(difference.standard_error);
        csv += cells.line();
      }
  return csv;
}

Json StudyOutputs::json() const {
  Json settings = Json::array(), orders = Json::array(), left_out = Json::array(), refused = Json::array();
  Json absent = Json::array();
  for (const auto& m : found_.merits) {
    const CompareSetting& s = study_.plan.settings[m.setting];
    settings.push_back({{"label", label(m.setting)},
                        {"solver", s.solver},
                        {"law", s.law},
                        {"step_s", s.step},
                        {"tolerance_m_s", s.tolerance},
                        {"stabilisation", s.stabilisation},
                        {"integrator", s.integrator},
                        {"simplifications", simplifications_text(s)},
                        {"runs", m.planned},
                        {"done", m.done},
                        {"trouble", m.trouble},
                        {"compute_s_per_s", number_or_null(m.time)},
                        {"compute_spread_s_per_s", number_or_null(m.time_spread)},
                        {"error", number_or_null(m.error)},
                        {"floor", number_or_null(m.floor)},
                        {"told_from_chaos", m.told},
                        {"dominated", m.dominated},
                        {"load_N", json_of(m.load)},
                        {"load_difference_N", json_of(m.load_difference)},
                        {"realisations", m.realisations},
                        {"partial", m.partial},
                        {"from_reference", json_of(m.from_reference)},
                        {"from_own", json_of(m.from_own)},
                        {"motion_rms_m", json_of(m.motion)},
                        {"turn_rad", json_of(m.turn)},
                        {"penetration_max_m", number_or_null(m.penetration_max_m)},
                        {"imbalance_relative", number_or_null(m.energy_error)}});
  }
  for (const auto& order : found_.orders)
    orders.push_back({{"of", order.rest}, {"order", order.order}, {"steps", order.steps}});
  for (const auto& omission : study_.plan.omissions)
    left_out.push_back({{"what", omission.what}, {"why", omission.why}});
  for (const auto& one : study_.refused) refused.push_back({{"what", one.what}, {"why", one.why}});
  for (const auto& one : study_.absent) absent.push_back({{"what", one.what}, {"why", one.why}});
  if (study_.ablation)
    for (const Inexpressible& one : inexpressible_simplifications())
      absent.push_back({{"what", one.name}, {"why", one.reason}});
  return {{"scene", study_.scene.string()},
          {"complete", ended_by_.empty() && late_.empty()},
          {"measure", found_.measure},
          {"unit", found_.unit},
          {"channel", found_.headline},
          {"windows", windows_json(found_)},
          {"shared_realisations", found_.shared},
          {"same_ice", found_.same_ice},
          {"scale", number_or_null(found_.scale)},
          {"reference", study_.reference},
          {"judged_in_its_place_by", found_.stand_in},
          {"reference_moves", found_.reference_moves ? Json(*found_.reference_moves) : Json(nullptr)},
          {"reference_coarse", found_.reference_coarse},
          {"chaos", number_or_null(found_.chaos)},
          {"horizon_s", found_.horizon_known ? Json(found_.horizon_s) : Json(nullptr)},
          {"horizon_ends", found_.horizon_ends},
          {"simulated_s", study_.plan.end - study_.plan.start},
          {"realisations", study_.plan.realisations},
          {"load_error_coverage", json_of(found_.coverage)},
          {"load_error_coverage_alone", json_of(found_.coverage_alone)},
          {"chosen", found_.chosen ? Json(label(*found_.chosen)) : Json(nullptr)},
          {"settings", settings},
          {"orders", orders},
          {"left_out", left_out},
          {"cannot_run", refused},
          {"simplifications_without_a_row", absent},
          {"not_done_for_the_budget", late_},
          {"with_more_time", outlook_json(outlook_)},
          {"text", sentences()},
          {"warnings", warnings()},
          {"jobs", timing_.jobs},
          {"elapsed_s", timing_.elapsed_s},
          {"jobs_at_work", number_or_null(timing_.busy)},
          {"slowdown_by_neighbours", number_or_null(timing_.slowdown)},
          {"parallel_efficiency", number_or_null(timing_.efficiency())},
          {"time_spread_relative", number_or_null(found_.time_spread)}};
}

}  // namespace nilas
