#include "apps/compare/scenes/report/front_points.h"

#include <cmath>

#include "apps/compare/scenes/judge/ranking.h"

namespace nilas::compare {

namespace {

constexpr double k_out_of_sight = 1e-3;  // share that stands for 0, which a logarithmic axis cannot show

std::vector<FrontPoint> front_points(const Findings& found) {
  std::vector<FrontPoint> points;
  for (const auto& m : found.merits) {
    const double error = m.significant ? m.error : m.floor;
    if (!(m.time > 0) || !(error > 0) || !std::isfinite(error) || m.done == 0 || m.partial) continue;
    const bool scatters = found.measure.is_load() && m.load_difference.count > 1;
    points.push_back({&m, error, scatters ? m.load_difference.standard_error : 0});
  }
  return points;
}

}  // namespace

double FrontPoint::shortest() const { return std::max(merit->time - merit->time_spread, k_out_of_sight * merit->time); }

double FrontPoint::lowest() const { return std::max(error - spread, k_out_of_sight * error); }

std::optional<Front> front_of(const Findings& found) {
  Front front{front_points(found), {}, {}, {}};
  if (front.points.empty()) return std::nullopt;
  Extent time, error;
  for (const auto& point : front.points) {
    time.add(point.merit->time);
    if (point.time_scatters()) time.add(point.shortest());
    if (point.time_scatters()) time.add(point.longest());
    error.add(point.error);
    error.add(point.highest());
  }
  const double least = error.low / k_axis_room;
  if (found.check.moves) error.high = std::max(error.high, *found.check.moves);
  // a smaller change lies below all that is shown
  if (found.check.moves && *found.check.moves > least) front.reference_moves = found.check.moves;
  front.time = log_axis(time);
  front.error = log_axis(error);
  return front;
}

std::optional<Findings> judged_by_motion(Findings found) {
  const bool moves =
      std::any_of(found.merits.begin(), found.merits.end(), [](const Merit& m) { return m.motion.mean > 0; });
  if (!found.measure.is_load() || !moves || !found.horizon.known) return std::nullopt;
  found.measure = {"distance", "m", 0};
  found.check.moves.reset();
  found.choice.chosen.reset();
  std::erase_if(found.merits, [](const Merit& m) { return m.done == 0 || std::isnan(m.motion.mean); });
  for (auto& m : found.merits) {
    m.error = m.motion.mean;
    m.floor = found.horizon.ends ? found.horizon.threshold_m : k_rounding_share;
    m.significant = m.error > m.floor;
  }
  found.merits = with_dominance(found.merits);
  return found;
}

bool in_key(const Merit& merit, const Findings& found) {
  return !merit.dominated || found.choice.chosen == merit.setting || merit.setting == 0;
}

std::string quantity_of(const Measure& measure) {
  if (measure.is_load()) return "mean ice load";
  return measure.name == "turn" ? "attitude" : "positions (rms)";
}

}  // namespace nilas::compare
