#include "core/output/load_error.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/output/load_statistics.h"
#include "core/output/mean_error.h"

namespace nilas {

namespace {

constexpr std::size_t k_components = 6;

std::array<double, k_components> components(const Wrench& w) {
  return {w.force.x(), w.force.y(), w.force.z(), w.torque.x(), w.torque.y(), w.torque.z()};
}

/// The component of the contact load that a channel is off with; nothing for loads of other origin or other arms.
std::optional<std::size_t> component_of(const std::string& channel) {
  static const std::array<std::string, k_components> names{"fx_N", "fy_N", "fz_N", "mx_Nm", "my_Nm", "mz_Nm"};
  const auto cut = channel.find('_');
  const std::string source = channel.substr(0, cut);
  const auto found = std::find(names.begin(), names.end(), channel.substr(cut + 1));
  const auto component = static_cast<std::size_t>(found - names.begin());
  const bool mapped = source == "contact" || source == "hull" || (source == "carriage" && component < 3);
  if (!mapped || found == names.end()) return std::nullopt;
  return component;
}

std::size_t headline_of(const std::vector<ChannelError>& channels) {
  const auto has_carriage =
      std::any_of(channels.begin(), channels.end(), [](const ChannelError& c) { return c.channel == "carriage_fx_N"; });
  const std::string source = has_carriage ? "carriage" : "contact";
  std::size_t best = 0;
  double largest = -1;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const bool horizontal = channels[c].channel == source + "_fx_N" || channels[c].channel == source + "_fy_N";
    if (!horizontal || !(std::abs(channels[c].mean) > largest)) continue;
    best = c;
    largest = std::abs(channels[c].mean);
  }
  return best;
}

std::optional<double> own_chaos(const std::vector<double>& contact) {
  const MeanError error = mean_error(contact);
  if (error.freedom == 0) return std::nullopt;
  return error.half_width();
}

/// Until they part all runs go one way, which their errors in common have chosen: the truth is one more draw.
double chaos_of_runs(const std::vector<double>& means) {
  return mean_error_of_runs(means).half_width() * std::sqrt(static_cast<double>(means.size() + 1));
}

bool parted_in_time(const TwinStatistics& twins, double start, double end) {
  return twins.horizon && *twins.horizon - start <= 0.5 * (end - start);
}

}  // namespace

void LoadResidualSums::add(const VesselRecord& vessel) {
  const auto solver = components(vessel.solver_residual), law = components(vessel.law_residual);
  for (std::size_t c = 0; c < k_components; ++c) {
    solver_[c] += solver[c];
    law_[c] += law[c];
    law_squares_[c] += law[c] * law[c];
  }
}

double LoadResidualSums::solver(std::size_t component, long steps) const {
  return solver_[component] / static_cast<double>(steps);
}

double LoadResidualSums::law(std::size_t component, long steps) const {
  return (std::abs(law_[component]) + 2 * std::sqrt(law_squares_[component])) / static_cast<double>(steps);
}

void LoadResidualSums::save(StateWriter out) const {
  out.add("solver", solver_);
  out.add("law", law_);
  out.add("law_squares", law_squares_);
}

void LoadResidualSums::restore(const StateReader& in) {
  in.get("solver", solver_, k_components);
  in.get("law", law_, k_components);
  in.get("law_squares", law_squares_, k_components);
}

std::optional<LoadError> load_error(const LoadRecord& run, const LoadResidualSums& residuals,
                                    const TwinStatistics* twins) {
  LoadError out;
  out.from_twins = twins != nullptr && twins->runs() > 1;
  out.chaos_from_twins = out.from_twins && parted_in_time(*twins, run.start, run.end);
  for (std::size_t c = 0; c < run.names.size(); ++c) {
    const auto component = component_of(run.names[c]);
    const auto& series = run.series[c];
    if (!component || series.empty()) continue;
    const auto steps = static_cast<long>(series.size());
    ChannelError error;
    error.channel = run.names[c];
    error.mean = out.from_twins ? mean_of_runs(twins->mean_loads[c]) : load_statistics(series).mean;
    // the contact load's channels come first, in the order of the components
    if (!out.chaos_from_twins) error.chaos = own_chaos(run.series[*component]);
    if (out.from_twins) error.chaos = std::max(error.chaos.value_or(0), chaos_of_runs(twins->mean_loads[c]));
    error.solver = residuals.solver(*component, steps);
    error.law = residuals.law(*component, steps);
    error.total = std::hypot(error.chaos.value_or(0), error.solver + error.law);
    out.channels.push_back(error);
  }
  if (out.channels.empty()) return std::nullopt;
  out.headline = headline_of(out.channels);
  return out;
}

}  // namespace nilas
