#include "core/output/loads/load_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/statistics.h"
#include "core/output/loads/mean_error.h"

namespace nilas::output {

namespace {

constexpr std::size_t k_components = LoadResiduals::k_components;

std::array<double, k_components> components(const Wrench& w, const Vec2& along, const Vec2& across) {
  const Vec2 force = w.force.head<2>();
  return {w.force.x(),  w.force.y(),  w.force.z(),      w.torque.x(),
          w.torque.y(), w.torque.z(), along.dot(force), across.dot(force)};
}

/// The component of the contact load whose residual is also the error of this channel; empty for loads of other origin
/// or with other arms.
std::optional<std::size_t> component_of(const std::string& channel) {
  static const std::array<std::string, 6> names{"fx_N", "fy_N", "fz_N", "mx_Nm", "my_Nm", "mz_Nm"};
  if (channel == "ice_resistance_N") return names.size();
  if (channel == "ice_side_N") return names.size() + 1;
  const auto cut = channel.find('_');
  const std::string source = channel.substr(0, cut);
  const auto found = std::find(names.begin(), names.end(), channel.substr(cut + 1));
  const auto component = static_cast<std::size_t>(found - names.begin());
  const bool mapped = source == "contact" || source == "hull" || (source == "carriage" && component < 3);
  if (!mapped || found == names.end()) return std::nullopt;
  return component;
}

std::size_t headline_of(const std::vector<ChannelError>& channels) {
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [](const ChannelError& c) { return c.channel == "ice_resistance_N"; });
  return found == channels.end() ? 0 : static_cast<std::size_t>(found - channels.begin());
}

std::optional<double> own_chaos(const std::vector<double>& contact, bool ice_broke) {
  const MeanError error = ice_broke ? slow_mean_error(contact) : mean_error(contact);
  if (error.freedom == 0) return std::nullopt;
  return error.half_width();
}

/// Half width from the scatter between runs, for one further run. Before the runs diverge they share one motion and its
/// errors, so the true value is like a further run.
double chaos_of_runs(const std::vector<double>& means) {
  return mean_error_of_runs(means).half_width() * std::sqrt(static_cast<double>(means.size() + 1));
}

bool parted_in_time(const TwinStatistics& twins, double start, double end) {
  return twins.horizon && *twins.horizon - start <= 0.5 * (end - start);
}

}  // namespace

/// Mean of value(entry) over all entries; 0 of none.
template <class Value>
static double mean_over(const std::vector<double>& series, const Value& value) {
  if (series.empty()) return 0;
  double sum = 0;
  for (const double x : series) sum += value(x);
  return sum / static_cast<double>(series.size());
}

static double mean_over(const std::vector<double>& series) {
  return mean_over(series, [](double x) { return x; });
}

void LoadResiduals::add_to(std::vector<double>& row, const sim::StepRecord& record) {
  const sim::VesselRecord& vessel = record.vessel.value();
  constexpr double k_coarse = 1e-3;  // share of the speed, as in the default tolerance
  const double speed = vessel.carriage ? std::abs(vessel.state.v.head<2>().dot(vessel.course)) : 0;
  const bool coarse = speed > 0 && record.residuals.law_map_m_s > k_coarse * speed;
  row.push_back(record.solver_short ? 1 : 0);
  row.push_back(record.solver_short || coarse ? 1 : 0);
  // Absolute values of the components are bounds along any axis.
  const Vec2 ahead = vessel.course.cwiseAbs(), aside = sim::to_port(vessel.course).cwiseAbs();
  const auto solver = components(vessel.solver_residual, ahead, aside);
  const auto law = components(vessel.law_residual, vessel.course, sim::to_port(vessel.course));
  row.insert(row.end(), solver.begin(), solver.end());
  row.insert(row.end(), law.begin(), law.end());
}

double LoadResiduals::solver(std::size_t component, const LoadWindow& window) const {
  return mean_over(columns_.over(window, k_solver + component));
}

double LoadResiduals::law(std::size_t component, const LoadWindow& window) const {
  const std::vector<double> law = columns_.over(window, k_law + component);
  if (law.empty()) return 0;
  const double square = mean_over(law, [](double x) { return x * x; });
  return std::abs(mean_over(law)) + 2 * std::sqrt(square / static_cast<double>(law.size()));
}

double LoadResiduals::share_short(const LoadWindow& window, bool ice_broke) const {
  return mean_over(columns_.over(window, ice_broke ? k_coarse : k_short));
}

std::optional<LoadError> load_error(const LoadRecord& run, const LoadResiduals& residuals,
                                    const TwinStatistics* twins) {
  LoadError out;
  out.ice_broke = run.ice_broke;
  out.from_twins = twins != nullptr && twins->runs() > 1;
  out.chaos_from_twins = out.from_twins && parted_in_time(*twins, run.window.from, run.window.to);
  for (std::size_t c = 0; c < run.names.size(); ++c) {
    const auto component = component_of(run.names[c]);
    if (!component) continue;
    const auto series = run.series.over(run.window, c);
    if (series.empty()) continue;
    ChannelError error;
    error.channel = run.names[c];
    error.mean = out.from_twins ? mean_of(twins->mean_loads[c]) : mean_of(series);
    // The contact load's channels come first, in the order of the components.
    const bool of_course = *component >= k_components - k_num_course_loads;
    if (!out.chaos_from_twins)
      error.chaos = own_chaos(of_course ? series : run.series.over(run.window, *component), out.ice_broke);
    if (out.from_twins) error.chaos = std::max(error.chaos.value_or(0), chaos_of_runs(twins->mean_loads[c]));
    error.solver = residuals.solver(*component, run.window);
    error.law = residuals.law(*component, run.window);
    error.total = std::hypot(error.chaos.value_or(0), error.solver + error.law);
    out.channels.push_back(error);
  }
  if (out.channels.empty()) return std::nullopt;
  constexpr double k_many = 0.01;
  out.share_short = residuals.share_short(run.window, run.ice_broke);
  out.solver_at_least = out.share_short > k_many;
  out.headline = headline_of(out.channels);
  out.law_at_least = out.channels[out.headline].law > 0;
  return out;
}

}  // namespace nilas::output
