#include "apps/compare/scenes/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "core/choices/solver_name.h"

namespace nilas {

namespace {

/// Of the budget; the rest is for starting, reading, drawing and for estimates that fall short.
constexpr double k_share = 0.85;

/// Roughly, a solve's time over that of nsgs in fields of floes: for estimates before anything was run.
double time_of(SolverName solver) {
  switch (solver) {
    case SolverName::pgs:
      return 0.6;
    case SolverName::nsgs:
    case SolverName::enumerate:
      return 1;
    case SolverName::automatic:
      return 1.2;
    case SolverName::apgd:
    case SolverName::newton:
      return 5;
    case SolverName::admm:
      return 8;
    case SolverName::eg:
      return 10;
    case SolverName::newton_order_free:
      return 15;
    case SolverName::eg_order_free:
      return 20;
    case SolverName::ipm:
      return 25;
  }
  return 1;
}

/// Each decade of accuracy costs about so much more.
constexpr double k_per_decade = 2.5;

double tolerance_weight(double tolerance) {
  constexpr double k_usual = 1e-6;
  return tolerance > 0 ? std::pow(k_per_decade, std::log10(k_usual / tolerance)) : 1;
}

/// What `auto` falls back on for this law, measured in presawn-a.xml and towing.xml.
double law_weight(const CompareSetting& setting) {
  constexpr double k_convex = 8;
  return setting.solver == "auto" && setting.law == "ccp" ? k_convex : 1;
}

double weight(const CompareSetting& setting) {
  return time_of(choice_named<SolverName>(setting.solver)) * law_weight(setting) * tolerance_weight(setting.tolerance);
}

/// The plan's parts while it is cut to size.
struct Draft {
  std::vector<std::size_t> candidates;  ///< what has not been given up for good
  std::vector<std::size_t> kept;
  int realisations = 0;
  double length = 0;  ///< simulated [s]
  double reference_tolerance = 0;
};

class Planner {
 public:
  explicit Planner(const PlanInput& input)
      : settings_(input.settings),
        core_(input.core),
        reference_(input.reference),
        cost_(input.cost),
        request_(input.request) {
    const PlanRequest& request = request_;
    for (std::size_t k = 0; k < settings_.size(); ++k) draft_.kept.push_back(k);
    draft_.candidates = draft_.kept;
    draft_.realisations = request.realisations;
    draft_.length = request.end - request.start;
    draft_.reference_tolerance = reference_.tolerance;
    room_ = request.budget_s > 0 ? std::max(0.0, k_share * request.budget_s - k_closing_s) * request.jobs
                                 : std::numeric_limits<double>::infinity();
    whole_s_ = (wall_seconds() + k_closing_s) / k_share;
  }

  Plan plan() {
    if (!request_.reference && !request_.fixed_length) return against_first();
    if (!fits()) keep_core();
    if (!fits()) loosen_reference();
    if (!fits()) drop_tighter();
    if (!fits() && !request_.fixed_realisations) draft_.realisations = std::min(draft_.realisations, 2);
    if (!fits() && !request_.fixed_length) shorten(0);
    if (!fits()) drop_core(1);
    refill();
    return written();
  }

 private:
  /// The settings stand in the order of their importance, and each tells something by itself beside the first: rather
  /// fewer of them than a window that is no more than the first touch of the ice.
  Plan against_first() {
    constexpr double k_quarter = 0.25;
    const bool free = !request_.fixed_realisations;
    if (!fits() && free) draft_.realisations = std::min(draft_.realisations, 2);
    if (!fits()) shorten(k_quarter);
    if (!fits() && free) draft_.realisations = 1;
    if (!fits()) drop_core(2);
    if (!fits()) shorten(0);
    if (!fits()) drop_core(1);
    refill();
    return written();
  }

  double setting_seconds(std::size_t k) const {
    const CompareSetting &setting = settings_[k], &first = settings_.front();
    return cost_.setup_s +
           cost_.steps_seconds(draft_.length, solver_weight(setting, first)) * first.step / setting.step;
  }
  /// Problems grow harder as ice piles up, and tight solves feel it most.
  double reference_seconds(double step) const {
    constexpr double k_harder = 2;
    const double weight = k_harder * cost_.reference_weight(draft_.reference_tolerance);
    return cost_.setup_s + cost_.steps_seconds(draft_.length, weight) * settings_.front().step / step;
  }
  double references_seconds() const {
    if (!request_.reference) return 0;
    return reference_seconds(reference_step()) * draft_.realisations +
           (request_.check ? reference_seconds(2 * reference_step()) : 0);
  }
  /// Half the finest that is kept; one that goes from event to event has no such step.
  double reference_step() const {
    if (!request_.check) return reference_.step;
    double finest = std::numeric_limits<double>::infinity();
    for (const std::size_t k : draft_.kept) finest = std::min(finest, settings_[k].step);
    return 0.5 * finest;
  }
  double total() const {
    double sum = setting_seconds(0) * draft_.realisations;  // its twins
    for (const std::size_t k : draft_.kept) sum += setting_seconds(k) * draft_.realisations;
    return sum + references_seconds();
  }
  double wall_seconds() const {
    return std::max(total() / request_.jobs, request_.reference ? reference_seconds(reference_step()) : 0);
  }
  /// With so many jobs the longest run may be what is waited for.
  bool fits() const {
    const double longest = request_.reference ? reference_seconds(reference_step()) : setting_seconds(0);
    return total() <= room_ && longest * request_.jobs <= room_;
  }

  void keep_core() { draft_.kept.resize(std::min(draft_.kept.size(), core_)); }

  double tightest() const {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : draft_.kept)
      if (settings_[k].tolerance > 0) least = std::min(least, settings_[k].tolerance);
    constexpr double k_usual = 1e-6;  // where all go by sweeps [m/s]
    return std::isfinite(least) ? least : k_usual;
  }
  bool reference_takes_most() const {
    constexpr double k_most = 0.3;
    return request_.reference && !request_.fixed_reference && references_seconds() > k_most * total();
  }

  void loosen_reference() {
    constexpr double k_decade = 10, k_rounding = 1 + 1e-9;
    while (draft_.reference_tolerance * k_decade <= loosest_reference(tightest()) * k_rounding && !fits() &&
           reference_takes_most())
      draft_.reference_tolerance *= k_decade;
  }

  /// Where what a tight solve adds is paid with simulated time, it is the time that tells more.
  void drop_tighter() {
    const double own = settings_.front().tolerance;
    if (request_.fixed_tolerances || !(own > 0) || !reference_takes_most()) return;
    const auto tighter = [&](std::size_t k) { return settings_[k].tolerance > 0 && settings_[k].tolerance < own; };
    std::erase_if(draft_.kept, tighter);
    std::erase_if(draft_.candidates, tighter);
    loosen_reference();
  }

  double coarsest() const {
    double step = 0;
    for (const auto& setting : settings_) step = std::max(step, setting.step);
    return step;
  }

  /// Keeps a share of what follows the window's begin, and 20 steps of it at least.
  void shorten(double share) {
    constexpr int k_least_steps = 20;
    const double full = draft_.length, step = coarsest();
    const double before = std::isnan(cost_.window_from) ? 0 : std::clamp(cost_.window_from - request_.start, 0.0, full);
    const double least = std::min(full, before + std::max(share * (full - before), k_least_steps * step));
    double low = least, high = full;
    constexpr int k_halvings = 40;
    for (int k = 0; k < k_halvings; ++k) {
      draft_.length = 0.5 * (low + high);
      (fits() ? low : high) = draft_.length;
    }
    draft_.length = std::max(least, std::floor(rounded(low) / step) * step);
  }

  /// Two digits: a noisy estimate does not change them often.
  static double rounded(double length) {
    const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
    return std::floor(length / unit) * unit;
  }

  void drop_core(std::size_t least) {
    while (!fits() && draft_.kept.size() > least) draft_.kept.pop_back();
  }

  /// What was cut from the end comes back as far as there is room: cheap settings may stand behind costly ones.
  void refill() {
    std::vector<std::size_t> whole = draft_.kept;
    for (const std::size_t k : draft_.candidates) {
      if (std::find(whole.begin(), whole.end(), k) != whole.end()) continue;
      draft_.kept.push_back(k);
      if (!fits()) draft_.kept.pop_back();
    }
    std::sort(draft_.kept.begin(), draft_.kept.end());
  }

  Plan written() const {
    Plan plan;
    plan.start = request_.start;
    plan.scene_end = request_.end;
    plan.end = request_.start + draft_.length;
    plan.realisations = draft_.realisations;
    for (const std::size_t k : draft_.kept) plan.settings.push_back(settings_[k]);
    plan.reference = plan.check = reference_;
    plan.reference.tolerance = plan.check.tolerance = draft_.reference_tolerance;
    plan.reference.step = reference_step();
    plan.check.step = 2 * plan.reference.step;
    constexpr double k_samples = 60;
    const double step = coarsest();
    plan.sample_every = step * std::max(1.0, std::floor(draft_.length / k_samples / step));
    list_omissions(plan);
    list_runs(plan);
    plan.estimate_s = wall_seconds() + k_closing_s;
    plan.whole_s = whole_s_;
    return plan;
  }

  void list_omissions(Plan& plan) const {
    const auto omit = [&](const std::string& what, const std::string& why) { plan.omissions.push_back({what, why}); };
    const std::string budget = fmt::format("the budget of {:g} s", request_.stated_budget_s);
    if (draft_.length < request_.end - request_.start)
      omit(fmt::format("simulated time from {:g} s to {:g} s", plan.end, request_.end), budget);
    if (draft_.realisations < request_.realisations)
      omit(fmt::format("{} of {} realisations", request_.realisations - draft_.realisations, request_.realisations),
           budget);
    if (draft_.reference_tolerance > reference_.tolerance * 2)
      omit(fmt::format("the reference at {:.0e} m/s (it is solved to {:.0e} m/s)", reference_.tolerance,
                       draft_.reference_tolerance),
           budget);
    for (std::size_t k = 0; k < settings_.size(); ++k)
      if (std::find(draft_.kept.begin(), draft_.kept.end(), k) == draft_.kept.end())
        omit(fmt::format("{} (about {:.3g} s of processor time)", label_of(settings_[k], settings_.front()),
                         setting_seconds(k) * draft_.realisations),
             budget);
  }

  void list_runs(Plan& plan) const {
    for (int r = 0; r < draft_.realisations; ++r) {
      plan.runs.push_back({fmt::format("s00-r{}", r), RunKind::grid, 0, r, setting_seconds(0)});
      if (request_.reference)
        plan.runs.push_back(
            {fmt::format("reference-r{}", r), RunKind::reference, 0, r, reference_seconds(reference_step())});
      if (request_.reference && request_.check && r == 0)
        plan.runs.push_back({"check-r0", RunKind::check, 0, 0, reference_seconds(2 * reference_step())});
      plan.runs.push_back({fmt::format("s00-r{}-twin", r), RunKind::twin, 0, r, setting_seconds(0)});
      for (std::size_t k = 1; k < draft_.kept.size(); ++k)
        plan.runs.push_back({fmt::format("s{:02d}-r{}", k, r), RunKind::grid, k, r, setting_seconds(draft_.kept[k])});
    }
    // realisation by realisation keeps what is done balanced, and what tells most comes first, so that a budget that is
    // used up early takes the least: what the others are judged by; the first setting and its twin, which tell what
    // chance does even where the budget has no room for the rest of their realisation; then the settings
    // where the first setting judges, the one that matters most comes before what chance does to it
    const bool judges = !request_.reference;
    const auto rank = [judges](const PlannedRun& run) {
      const bool first = run.realisation == 0;
      switch (run.kind) {
        case RunKind::reference:
          return first ? 0 : 3;
        case RunKind::twin:
          return 2;
        case RunKind::check:
          return 3;
        case RunKind::grid:
          break;
      }
      return run.setting == 0 || (judges && first && run.setting == 1) ? 1 : 4;
    };
    const auto place = [&](const PlannedRun& run) { return std::tuple(run.realisation, rank(run), run.setting); };
    std::stable_sort(plan.runs.begin(), plan.runs.end(),
                     [&](const PlannedRun& a, const PlannedRun& b) { return place(a) < place(b); });
  }

  const std::vector<CompareSetting>& settings_;
  std::size_t core_;
  const CompareSetting& reference_;
  const CostModel& cost_;
  const PlanRequest& request_;
  Draft draft_;
  double room_ = 0;     ///< processor time [s]
  double whole_s_ = 0;  ///< budget for all that was asked [s]
};

}  // namespace

double CostModel::steps_seconds(double length, double weight) const {
  double sum = 0, before = 0, last = 0;
  for (const Stretch& stretch : rate) {
    const double lasts = std::min(stretch.until, length) - before;
    if (lasts <= 0) break;
    last = stretch.other + weight * stretch.solver;
    sum += lasts * last;
    before += lasts;
  }
  return sum + std::max(0.0, length - before) * last;
}

double CostModel::reference_weight(double tolerance) const {
  if (reference.empty()) return 1;
  if (tolerance <= reference.front().tolerance) return reference.front().weight;
  for (std::size_t k = 1; k < reference.size(); ++k) {
    const Tightness &a = reference[k - 1], &b = reference[k];
    if (tolerance > b.tolerance) continue;
    const double share = std::log(tolerance / a.tolerance) / std::log(b.tolerance / a.tolerance);
    return a.weight * std::pow(b.weight / a.weight, share);
  }
  return reference.back().weight;
}

double loosest_reference(double tolerance) {
  constexpr double k_tighter = 0.1;
  return k_tighter * tolerance;
}

std::vector<double> measured_tolerances(double asked, bool fixed, const CompareSetting& own) {
  std::vector<double> tolerances{asked};
  constexpr double k_usual = 1e-6;  // where the scene goes by sweeps [m/s]
  const double loosest = loosest_reference(own.tolerance > 0 ? own.tolerance : k_usual);
  if (!fixed && loosest > asked) tolerances.push_back(loosest);
  return tolerances;
}

double solver_weight(const CompareSetting& setting, const CompareSetting& first) {
  return weight(setting) / weight(first);
}

const CompareSetting& Plan::setting_of(const PlannedRun& run) const {
  if (run.kind == RunKind::reference) return reference;
  return run.kind == RunKind::check ? check : settings[run.setting];
}

std::vector<Omission> absent_simplifications(const Scene& scene) {
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
      lists[static_cast<std::size_t>(known - reasons.begin())] += "; " + omission.what;
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

Plan make_plan(const PlanInput& input) { return Planner(input).plan(); }

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

Overrides realisation_overrides(std::uint64_t seed, const PlannedRun& run, bool vary_seed) {
  const auto number = static_cast<std::uint64_t>(run.realisation);
  constexpr std::uint64_t k_twins = 1000;  // beyond any count of realisations
  const std::uint64_t twin = run.kind == RunKind::twin ? k_twins + number : number;
  return {{"seed/@value", std::to_string(vary_seed ? seed + number : seed)}, {"seed/@twin", std::to_string(twin)}};
}

}  // namespace nilas
