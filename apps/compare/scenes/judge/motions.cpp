#include "apps/compare/scenes/judge/motions.h"

#include <algorithm>
#include <cmath>

#include "apps/compare/scenes/run/motion.h"

namespace nilas::compare {

namespace {

constexpr double k_same_place = 1e-9;  // a thousand times the offset by which realisations start apart [m]

/// The motion of a run. It is empty if the run stored none, which is possible for a run folder of the user.
SampledMotion motion_of(const RunRow& row, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "runs" / row.run.id / "bodies.csv";
  return std::filesystem::exists(file) && std::filesystem::file_size(file) > 0 ? read_motion(file) : SampledMotion();
}

std::optional<MotionError> motion_error(const SampledMotion& motion, const SampledMotion& truth, double from,
                                        double until) {
  MotionError error;
  bool any = false;
  for (const auto& apart : distances(motion, truth)) {
    if (apart.t > until || apart.t <= from) continue;
    any = true;
    error.rms_m = std::max(error.rms_m, apart.rms);
    error.largest_m = std::max(error.largest_m, apart.largest);
    error.axes_m = error.axes_m.cwiseMax(apart.axes);
    error.turn_rad = std::max(error.turn_rad, apart.turn);
  }
  return any ? std::optional(error) : std::nullopt;
}

/// Shortens the horizon to that of one realisation, if it is earlier.
void see_realisation(const Plan& plan, const SampledMotion& motion, const SampledMotion& perturbed, Horizon& horizon) {
  constexpr double k_share = 1e-4;
  const auto apart_over_time = distances(motion, perturbed);
  if (apart_over_time.empty()) return;
  horizon.known = true;
  const double threshold = std::max(k_same_place, k_share * longest_path(motion));
  horizon.threshold_m = std::max(horizon.threshold_m, threshold);
  double good = plan.start;
  for (const auto& apart : apart_over_time) {
    if (apart.largest > threshold || !apart.same_bodies) {
      horizon.until_s = std::min(horizon.until_s, good);
      horizon.ends = true;
      return;
    }
    good = apart.t;
  }
}

}  // namespace

bool same_ice(const RunTable& rows, const std::vector<int>& shared, const std::filesystem::path& folder) {
  SampledMotion begin;
  for (const int r : shared) {
    const RunRow* row = done_run(rows, RunKind::grid, 0, r);
    SampledMotion motion = row == nullptr ? SampledMotion() : motion_of(*row, folder);
    if (motion.empty()) return false;
    motion.resize(1);
    if (begin.empty()) begin = motion;
    const auto apart = distances(begin, motion);
    if (apart.empty() || apart.front().largest > k_same_place || !apart.front().same_bodies) return false;
  }
  return shared.size() > 1;
}

Horizon horizon_of(const Plan& plan, const RunTable& rows, const std::filesystem::path& folder) {
  Horizon horizon;
  horizon.until_s = plan.end;
  for (int r = 0; r < plan.realisations; ++r) {
    const RunRow *first = done_run(rows, RunKind::grid, 0, r), *perturbed = done_run(rows, RunKind::twin, 0, r);
    if (first != nullptr && perturbed != nullptr)
      see_realisation(plan, motion_of(*first, folder), motion_of(*perturbed, folder), horizon);
  }
  return horizon;
}

RunTable with_motion_errors(const Plan& plan, const Horizon& horizon, const std::filesystem::path& folder,
                            RunTable rows) {
  for (int r = 0; r < plan.realisations; ++r) {
    const RunRow* judge = judge_of(rows, r);
    if (judge == nullptr) continue;
    const SampledMotion truth = motion_of(*judge, folder);
    for (auto& row : rows)
      if (row.run.realisation == r && row.result.done() && !row.judges)
        row.motion = motion_error(motion_of(row, folder), truth, plan.start, horizon.until_s);
  }
  return rows;
}

Measure measure_of(const RunTable& rows, const std::string& headline, const JudgingLoads& reference,
                   const std::filesystem::path& folder) {
  if (!headline.empty() && std::abs(reference.mean.mean) > 0) return {"load", "N", std::abs(reference.mean.mean)};
  double turn = 0, distance = 0, path = 0;
  for (const auto& row : rows) {
    if (!row.motion) continue;
    distance = std::max(distance, row.motion->rms_m);
    turn = std::max(turn, row.motion->turn_rad);
  }
  if (const RunRow* first = done_run(rows, RunKind::grid, 0, 0)) path = longest_path(motion_of(*first, folder));
  const bool spins = path < k_rounding_share && turn > distance;
  return spins ? Measure{"turn", "rad", 1} : Measure{"distance", "m", path};
}

}  // namespace nilas::compare
