#include "apps/compare/scenes/judge/merits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "apps/compare/scenes/judge/chance.h"
#include "apps/compare/scenes/judge/load_errors.h"
#include "apps/compare/scenes/judge/pairing.h"
#include "apps/compare/scenes/judge/ranking.h"
#include "apps/compare/scenes/judge/row_loads.h"
#include "apps/compare/scenes/judge/shared_realisations.h"
#include "apps/compare/scenes/run/motion.h"
#include "core/base/statistics.h"

namespace nilas {

namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

class Judge {
 public:
  Judge(const Plan& plan, const std::map<std::string, RunResult>& results, std::filesystem::path folder, Judged judged)
      : plan_(plan),
        folder_(std::move(folder)),
        against_first_(judged == Judged::by_first_setting),
        one_reference_(judged == Judged::by_one_run) {
    for (const auto& run : plan.runs) {
      const auto found = results.find(run.id);
      found_.rows.push_back({run, found == results.end() ? RunResult{} : found->second});
    }
    // the plan's order depends on how fast the machine was; a table's must not
    const auto place = [](const RunRow& row) { return std::tuple(row.run.kind, row.run.setting, row.run.realisation); };
    std::sort(found_.rows.begin(), found_.rows.end(),
              [&](const RunRow& a, const RunRow& b) { return place(a) < place(b); });
  }

  Findings judged() {
    found_.one_reference = one_reference_;
    if (!against_first_) find_stand_in();
    for (auto& row : found_.rows) row.judges = row.result.done() && is_reference(row);
    choose_headline();
    find_shared();
    if (!found_.headline.empty()) measure_row_loads(plan_, folder_, found_);
    measure_motions();
    measure_loads();
    choose_measure();
    for (std::size_t s = 0; s < plan_.settings.size(); ++s) add_merit(s);
    set_floors();
    if (found_.measure == "load") pair_up(plan_, found_);
    check_reference();
    if (found_.measure == "load" && !against_first_) judge_load_errors(plan_, chaos_of_difference_, found_);
    spread_of_times();
    rank(found_);
    // a vessel that was not touched says nothing of what a setting is worth to its loads
    if (!against_first_ && (found_.headline.empty() || found_.measure == "load")) choose(found_);
    find_orders(plan_, found_);
    return std::move(found_);
  }

 private:
  bool is_reference(const RunRow& row) const {
    if (judging_setting_) return row.run.kind == RunKind::grid && row.run.setting == *judging_setting_;
    return row.run.kind == (by_check_ ? RunKind::check : RunKind::reference);
  }

  /// Where no run of the reference is done: the one at twice its step, else the most accurate setting that is done.
  void find_stand_in() {
    const auto done = [&](RunKind kind) {
      return std::any_of(found_.rows.begin(), found_.rows.end(),
                         [&](const RunRow& row) { return row.run.kind == kind && row.result.done(); });
    };
    for (const auto& row : found_.rows)
      if (row.run.kind == RunKind::reference && !row.result.done() && found_.reference_trouble.empty())
        found_.reference_trouble = row.result.status + (row.result.cause.empty() ? "" : ": " + row.result.cause);
    if (done(RunKind::reference)) return;
    by_check_ = done(RunKind::check);
    if (by_check_) found_.stand_in = "the reference at twice its step";
    if (by_check_) return;
    const auto finer = [&](std::size_t a, std::size_t b) {
      const CompareSetting &x = plan_.settings[a], &y = plan_.settings[b];
      return std::tuple(x.law != "coulomb", x.step, x.tolerance == 0, x.tolerance) <
             std::tuple(y.law != "coulomb", y.step, y.tolerance == 0, y.tolerance);
    };
    std::optional<std::size_t> finest;
    for (const auto& row : found_.rows)
      if (row.run.kind == RunKind::grid && row.result.done() && (!finest || finer(row.run.setting, *finest)))
        finest = row.run.setting;
    if (!finest) return;
    judging_setting_ = finest;
    found_.stand_in = '"' + label_of(plan_.settings[*finest], plan_.settings.front()) + '"';
  }

  const RunRow* first_of(int realisation) const { return done_run(found_, RunKind::grid, 0, realisation); }
  const RunRow* twin_of(int realisation) const { return done_run(found_, RunKind::twin, 0, realisation); }
  double load_of(const RunRow& row, const char* statistic = "mean") const {
    return load_statistic(row, found_.headline, statistic);
  }
  /// Empty where the run stored none, as a run folder of the user's may.
  Motion motion_of(const RunRow& row) const {
    const std::filesystem::path file = folder_ / "runs" / row.run.id / "bodies.csv";
    return std::filesystem::exists(file) && std::filesystem::file_size(file) > 0 ? read_motion(file) : Motion();
  }

  /// As `nilas run` announces it.
  void choose_headline() {
    const std::string channel = k_course_channels.front();
    for (const auto& row : found_.rows)
      if (row.result.done() && !std::isnan(row.result.number("/loads/" + channel + "/mean"))) found_.headline = channel;
  }

  void find_shared() {
    std::vector<DoneRuns> settings(plan_.settings.size());
    const auto count = static_cast<std::size_t>(plan_.realisations);
    std::vector<bool> judged(count, false);
    for (auto& setting : settings) setting.done.resize(count, false);
    for (const auto& row : found_.rows) {
      const auto r = static_cast<std::size_t>(row.run.realisation);
      if (row.judges) judged[r] = true;
      if (row.run.kind != RunKind::grid) continue;
      DoneRuns& runs = settings[row.run.setting];
      if (row.result.done()) runs.done[r] = true;
      runs.failed = runs.failed || row.result.failed();
    }
    found_.shared = shared_realisations(settings, judged);
  }
  bool shares(int realisation) const {
    return std::find(found_.shared.begin(), found_.shared.end(), realisation) != found_.shared.end();
  }

  void find_same_ice() {
    constexpr double k_same = 1e-9;  // a thousand times what realisations are set apart by [m]
    Motion begin;
    for (const int r : found_.shared) {
      const RunRow* row = done_run(found_, RunKind::grid, 0, r);
      Motion motion = row == nullptr ? Motion() : motion_of(*row);
      if (motion.empty()) return;
      motion.resize(1);
      if (begin.empty()) begin = motion;
      const auto apart = distances(begin, motion);
      if (apart.empty() || apart.front().largest > k_same || !apart.front().same_bodies) return;
    }
    found_.same_ice = found_.shared.size() > 1;
  }

  void measure_motions() {
    find_same_ice();
    found_.horizon_s = plan_.end;
    for (int r = 0; r < plan_.realisations; ++r) find_horizon(r);
    for (int r = 0; r < plan_.realisations; ++r) {
      const RunRow* reference = reference_of(found_, r);
      if (reference == nullptr) continue;
      const Motion truth = motion_of(*reference);
      for (auto& row : found_.rows)
        if (row.run.realisation == r && row.result.done() && !row.judges)
          row.motion = motion_error(motion_of(row), truth);
    }
  }

  /// Twins part exponentially: as soon as they are apart by a ten thousandth of the largest way of a body, motions are
  /// no longer compared.
  void find_horizon(int realisation) {
    constexpr double k_share = 1e-4;
    const RunRow *first = first_of(realisation), *twin = twin_of(realisation);
    if (first == nullptr || twin == nullptr) return;
    const Motion motion = motion_of(*first);
    const auto apart_over_time = distances(motion, motion_of(*twin));
    if (apart_over_time.empty()) return;
    found_.horizon_known = true;
    constexpr double k_least = 1e-9;  // a thousand times what they start apart [m]
    const double threshold = std::max(k_least, k_share * largest_way(motion));
    found_.horizon_threshold_m = std::max(found_.horizon_threshold_m, threshold);
    double good = plan_.start;
    for (const auto& apart : apart_over_time) {
      if (apart.largest > threshold || !apart.same_bodies) {
        found_.horizon_s = std::min(found_.horizon_s, good);
        found_.horizon_ends = true;
        return;
      }
      good = apart.t;
    }
  }

  std::optional<MotionError> motion_error(const Motion& motion, const Motion& truth) const {
    MotionError error;
    int samples = 0;
    for (const auto& apart : distances(motion, truth)) {
      if (apart.t > found_.horizon_s || apart.t <= plan_.start) continue;
      ++samples;
      error.rms_m = std::max(error.rms_m, apart.rms);
      error.largest_m = std::max(error.largest_m, apart.largest);
      error.axes_m = error.axes_m.cwiseMax(apart.axes);
      error.turn_rad = std::max(error.turn_rad, apart.turn);
    }
    return samples > 0 ? std::optional(error) : std::nullopt;
  }

  void measure_loads() {
    for (const auto& row : found_.rows) found_.references_done += row.judges ? 1 : 0;
    if (found_.headline.empty()) return;
    std::vector<double> loads;
    for (int r = 0; r < plan_.realisations; ++r) {
      if (const RunRow* first = first_of(r))
        for (auto& row : found_.rows)
          if (row.run.realisation == r && row.result.done() && &row != first)
            row.own_difference = load_of(row) - load_of(*first);
      const RunRow* reference = reference_of(found_, r);
      if (reference == nullptr) continue;
      const double load = load_of(*reference);
      if (shares(r)) loads.push_back(load);
      for (auto& row : found_.rows)
        if (row.run.realisation == r && row.result.done() && !row.judges) row.load_difference = load_of(row) - load;
    }
    found_.reference_load = loads.empty() ? k_nan : mean_of(loads);
    const auto of_judges = [&](const char* statistic) {
      std::vector<double> values;
      for (const auto& row : found_.rows)
        if (row.judges && shares(row.run.realisation)) values.push_back(load_of(row, statistic));
      return estimate_of(values);
    };
    found_.reference_mean = of_judges("mean");
    found_.reference_std = of_judges("std");
    found_.reference_max = of_judges("max");
    found_.reference_p99 = of_judges("p99");
  }

  void choose_measure() {
    double way = 0, turn = 0, distance = 0;
    for (const auto& row : found_.rows) {
      if (!row.motion) continue;
      distance = std::max(distance, row.motion->rms_m);
      turn = std::max(turn, row.motion->turn_rad);
    }
    if (!found_.headline.empty() && std::abs(found_.reference_load) > 0) {
      found_.measure = "load";
      found_.unit = "N";
      found_.scale = std::abs(found_.reference_load);
      return;
    }
    if (const RunRow* first = first_of(0)) way = largest_way(motion_of(*first));
    // a top that spins in its place
    const bool turns = way < k_rounding_share && turn > distance;
    found_.measure = turns ? "turn" : "distance";
    found_.unit = turns ? "rad" : "m";
    found_.scale = turns ? 1 : way;
  }

  std::optional<double> primary(const RunRow& row) const {
    if (found_.measure == "load") return row.load_difference;
    if (!row.motion) return std::nullopt;
    return found_.measure == "turn" ? row.motion->turn_rad : row.motion->rms_m;
  }

  template <class Value>
  std::vector<double> over_runs(std::size_t setting, const Value& value) const {
    std::vector<double> values;
    for (const auto& row : found_.rows)
      if (row.run.kind == RunKind::grid && row.run.setting == setting && row.result.done() &&
          shares(row.run.realisation))
        if (const std::optional<double> v = value(row); v && !std::isnan(*v)) values.push_back(*v);
    return values;
  }
  template <class Value>
  double worst(std::size_t setting, const Value& value) const {
    double most = k_nan;
    for (const double v : over_runs(setting, [&](const RunRow& row) { return std::optional(value(row)); }))
      most = std::isnan(most) ? std::abs(v) : std::max(most, std::abs(v));
    return most;
  }

  void add_merit(std::size_t setting) {
    Merit m;
    m.setting = setting;
    for (const auto& row : found_.rows) {
      if (row.run.kind != RunKind::grid || row.run.setting != setting) continue;
      ++m.planned;
      m.done += row.result.done() ? 1 : 0;
      m.failed += row.result.failed() ? 1 : 0;
      if (row.result.done() && shares(row.run.realisation)) m.realisations.push_back(row.run.realisation);
      if (row.result.failed() && m.trouble.empty())
        m.trouble = row.result.status + (row.result.cause.empty() ? "" : ": " + row.result.cause);
    }
    if (m.done == 0 && m.trouble.empty()) m.trouble = "not run";
    m.partial = m.done > 0 && m.realisations.size() < found_.shared.size();
    const auto load = [&](const char* statistic) {
      return estimate_of(over_runs(setting, [&](const RunRow& row) { return std::optional(load_of(row, statistic)); }));
    };
    const auto number = [&](const char* path) {
      return worst(setting, [&](const RunRow& row) { return row.result.number(path); });
    };
    m.load = load("mean");
    m.load_std = load("std");
    m.load_max = load("max");
    m.load_p99 = load("p99");
    m.load_difference = estimate_of(over_runs(setting, [](const RunRow& row) { return row.load_difference; }));
    const auto of_motion = [&](double MotionError::*member) {
      return estimate_of(over_runs(setting, [&](const RunRow& row) {
        return row.motion ? std::optional((*row.motion).*member) : std::nullopt;
      }));
    };
    m.motion = of_motion(&MotionError::rms_m);
    m.turn = of_motion(&MotionError::turn_rad);
    m.penetration_max_m = number("/worst/penetration_max_m/value");
    m.penetration_mean_m = worst(setting, [](const RunRow& row) { return row.result.penetration_mean_m; });
    m.law_map_m_s = number("/worst/law_map_m_s/value");
    m.natural_map_m_s = number("/worst/natural_map_m_s/value");
    m.energy_error = number("/worst/imbalance_J/relative_to_energy_put_in");
    m.momentum_error = number("/worst/momentum_imbalance_relative/value");
    m.unconverged_share = worst(setting, [](const RunRow& row) {
      return row.result.number("/shortfalls/unconverged_steps") / row.result.number("/steps");
    });
    const auto times =
        over_runs(setting, [](const RunRow& row) { return std::optional(row.result.compute_per_second()); });
    m.time = median_of(times);
    m.ms_per_step =
        median_of(over_runs(setting, [](const RunRow& row) { return std::optional(row.result.ms_per_step()); }));
    const auto errors = over_runs(setting, [&](const RunRow& row) { return primary(row); });
    m.error = errors.empty() ? k_nan : std::abs(mean_of(errors));
    if (setting == judging_setting_ && m.done > 0) m.error = 0;
    m.judges = setting == judging_setting_;
    found_.merits.push_back(m);
  }

  /// Motions within the horizon part by less than its threshold, so that differences above it are told from chaos;
  /// loads by Student's t on what twins and realisations scatter.
  void set_floors() {
    if (found_.measure != "load") {
      found_.common_floor = !found_.horizon_known ? std::numeric_limits<double>::infinity()
                            : found_.horizon_ends ? found_.horizon_threshold_m
                                                  : k_rounding_share * found_.scale;
      for (auto& m : found_.merits) m.floor = found_.common_floor;
      for (auto& m : found_.merits) m.told = m.error > m.floor;
      return;
    }
    int most = 1;  // of the reference's realisations, not all may be done
    for (const auto& m : found_.merits) most = std::max(most, m.load_difference.count);
    std::vector<double> twins;
    std::vector<std::vector<double>> settings;
    for (int r = 0; r < plan_.realisations; ++r)
      if (const RunRow* first = first_of(r), *twin = twin_of(r); first != nullptr && twin != nullptr)
        twins.push_back(load_of(*first) - load_of(*twin));
    for (const auto& m : found_.merits)
      if (m.load_difference.count == most && !m.judges)
        settings.push_back(over_runs(m.setting, [](const RunRow& row) { return row.load_difference; }));
    if (one_reference_ && settings.size() == 1) settings.clear();  // which scatters as one run, not as a difference
    const PooledVariance pooled = found_.chance = pooled_variance(twins, settings);
    const bool measured = pooled.degrees > 0;
    found_.chaos = measured ? std::sqrt(0.5 * pooled.value) : k_nan;
    chaos_of_difference_ = measured ? student_95(pooled.degrees) * std::sqrt(pooled.value) : k_nan;
    // one run that all are judged by does not average out, and differences from it scatter as single runs do
    const double reference = one_reference_ ? 0.5 * pooled.value : 0, runs = pooled.value - reference;
    const auto limit = [&](double variance, double degrees, int count) {
      return floor_of(variance, degrees, count, reference) + k_rounding_share * found_.scale;
    };
    found_.common_floor = limit(runs, pooled.degrees, most);
    for (auto& m : found_.merits) {
      const int count = m.load_difference.count;
      const double own = variance_of_difference(m);
      const bool wild = !std::isnan(own) && own > fisher_95(count - 1, pooled.degrees) * runs;
      m.floor = wild ? limit(own, count - 1, count) : limit(runs, pooled.degrees, count);
      if (m.done == 0) m.floor = k_nan;
      m.told = m.error > m.floor;
    }
  }

  static double variance_of_difference(const Merit& m) {
    return m.load_difference.standard_error * m.load_difference.standard_error * m.load_difference.count;
  }

  /// Runs of one setting do nearly the same work: how far their times scatter is what a time can be trusted to.
  void spread_of_times() {
    std::vector<double> relative;
    for (std::size_t s = 0; s < plan_.settings.size(); ++s) {
      std::vector<double> times;
      for (const auto& row : found_.rows)
        if (row.run.kind == RunKind::grid && row.run.setting == s && row.result.done())
          if (const double time = row.result.compute_per_second(); !std::isnan(time)) times.push_back(time);
      if (times.size() > 1) relative.push_back(std::sqrt(variance_of(times)) / mean_of(times));
    }
    double squares = 0;
    for (const double r : relative) squares += r * r / static_cast<double>(relative.size());
    found_.time_spread = relative.empty() ? k_nan : std::sqrt(squares);
    for (auto& m : found_.merits) m.time_spread = found_.time_spread * m.time;
  }

  void check_reference() {
    for (const auto& row : found_.rows)
      if (row.run.kind == RunKind::check && row.result.done() && found_.stand_in.empty())
        if (const auto moves = primary(row)) found_.reference_moves = std::abs(*moves);
    if (!found_.reference_moves) return;
    const double moves = *found_.reference_moves;
    // a single run's difference below what chaos does to it is none
    if (found_.measure == "load" && !std::isnan(found_.chaos))
      found_.reference_chance = 2 * std::sqrt(2.0) * found_.chaos;
    found_.reference_coarse =
        moves > found_.reference_chance && std::any_of(found_.merits.begin(), found_.merits.end(),
                                                       [&](const Merit& m) { return m.told && m.error < moves; });
  }

  const Plan& plan_;
  std::filesystem::path folder_;
  bool against_first_, one_reference_;
  std::optional<std::size_t> judging_setting_ = against_first_ ? std::optional<std::size_t>(0) : std::nullopt;
  bool by_check_ = false;
  double chaos_of_difference_ = k_nan;  ///< of two runs of one realisation, 95 % [N]
  Findings found_;
};

}  // namespace

Estimate estimate_of(const std::vector<double>& values) {
  Estimate e;
  e.count = static_cast<int>(values.size());
  e.mean = values.empty() ? k_nan : mean_of(values);
  e.standard_error = std::sqrt(variance_of(values) / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
  return e;
}

const RunRow* reference_of(const Findings& found, int realisation) {
  for (const auto& row : found.rows)
    if (row.judges && row.run.realisation == realisation) return &row;
  return nullptr;
}

const RunRow* done_run(const Findings& found, RunKind kind, std::size_t setting, int realisation) {
  for (const auto& row : found.rows)
    if (row.run.kind == kind && row.run.setting == setting && row.run.realisation == realisation && row.result.done())
      return &row;
  return nullptr;
}

double floor_of(double variance, double degrees, int realisations, double reference) {
  if (!(degrees > 0)) return std::numeric_limits<double>::infinity();
  return student_95(degrees) * std::sqrt(variance / std::max(1, realisations) + reference);
}

Findings find(const Plan& plan, const std::map<std::string, RunResult>& results, const std::filesystem::path& folder,
              Judged judged) {
  return Judge(plan, results, folder, judged).judged();
}

}  // namespace nilas
