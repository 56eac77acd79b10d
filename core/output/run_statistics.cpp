#include "core/output/run_statistics.h"

#include <algorithm>
#include <cmath>

#include "contact/measure.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// 0 / 0 is a balance that holds exactly.
double ratio(double part, double scale) { return part == 0 ? 0 : part / scale; }

}  // namespace

RunStatistics::RunStatistics(const RunInfo& info) : works_(info.work_names.size(), 0) {
  for (const auto& residual : residual_columns()) worst_.push_back({residual.name});
  for (const char* name :
       {"penetration_max_m", "penetration_mean_m", "imbalance_J", "momentum_imbalance_Ns",
        "angular_momentum_imbalance_Nms", "momentum_imbalance_relative", "angular_momentum_imbalance_relative"})
    worst_.push_back({name});
  if (!info.has_vessel) return;
  const VesselChannels channels(info);
  load_names_.assign(channels.names().begin(), channels.names().begin() + channels.num_loads());
  load_series_.resize(load_names_.size());
}

void RunStatistics::start(double t, const Ledger& ledger) {
  t_start_ = t_end_ = t;
  energy_put_in_ = ledger.kinetic;
  works_ = ledger.works;
}

void RunStatistics::add(const StepRecord& record, const std::vector<double>& vessel_values) {
  ++steps_;
  t_end_ = record.t;
  std::size_t column = 0;
  for (const auto& residual : residual_columns()) note(column++, record.residuals.*residual.member, record.t);
  for (const double value :
       {record.penetration_max, record.penetration_mean, record.ledger.imbalance, record.momentum_imbalance,
        record.angular_momentum_imbalance, ratio(record.momentum_imbalance, record.momentum_scale),
        ratio(record.angular_momentum_imbalance, record.angular_momentum_scale)})
    note(column++, value, record.t);
  for (std::size_t k = 0; k < works_.size(); ++k) energy_put_in_ += std::abs(record.ledger.works[k] - works_[k]);
  works_ = record.ledger.works;
  for (std::size_t p = 0; p < total_ms_.size(); ++p) total_ms_[p] += record.ms[p];
  shortfalls_.unconverged_steps += record.solver_short;
  shortfalls_.uncorrected_steps += !record.positions_corrected;
  shortfalls_.detection_fallbacks += record.detection_fallbacks;
  for (std::size_t c = 0; c < load_series_.size(); ++c) load_series_[c].push_back(vessel_values[c]);
  if (!load_series_.empty()) load_residuals_.add(record.vessel.value());
}

void RunStatistics::note(std::size_t column, double value, double t) {
  Worst& worst = worst_[column];
  // The negated comparison lets a value that is not a number in, and then keeps the first of them.
  if (std::isnan(worst.value) || std::abs(value) <= std::abs(worst.value)) return;
  worst.value = value;
  worst.time = t;
}

void RunStatistics::save(StateWriter out) const {
  std::vector<double> worst, times;
  for (const Worst& w : worst_) {
    worst.push_back(w.value);
    times.push_back(w.time);
  }
  out.add("worst", worst);
  out.add("worst_time", times);
  for (std::size_t c = 0; c < load_series_.size(); ++c) out.group("loads").add(load_names_[c], load_series_[c]);
  if (!load_series_.empty()) load_residuals_.save(out.group("load_residuals"));
  out.add("works", works_);
  out.add("energy_put_in", energy_put_in_);
  out.add("t_start", t_start_);
  out.add("t_end", t_end_);
  out.add("steps", steps_);
  out.add("total_ms", total_ms_);
  out.add("unconverged_steps", shortfalls_.unconverged_steps);
  out.add("uncorrected_steps", shortfalls_.uncorrected_steps);
  out.add("detection_fallbacks", shortfalls_.detection_fallbacks);
}

void RunStatistics::restore(const StateReader& in) {
  std::vector<double> worst, times;
  in.get("worst", worst, worst_.size());
  in.get("worst_time", times, worst_.size());
  for (std::size_t k = 0; k < worst_.size(); ++k) {
    worst_[k].value = worst[k];
    worst_[k].time = times[k];
  }
  in.get("steps", steps_);
  for (std::size_t c = 0; c < load_series_.size(); ++c)
    in.group("loads").get(load_names_[c], load_series_[c], static_cast<std::size_t>(steps_));
  if (!load_series_.empty()) load_residuals_.restore(in.group("load_residuals"));
  in.get("works", works_, works_.size());
  in.get("energy_put_in", energy_put_in_);
  in.get("t_start", t_start_);
  in.get("t_end", t_end_);
  in.get("total_ms", total_ms_);
  in.get("unconverged_steps", shortfalls_.unconverged_steps);
  in.get("uncorrected_steps", shortfalls_.uncorrected_steps);
  in.get("detection_fallbacks", shortfalls_.detection_fallbacks);
}

const Worst& RunStatistics::worst(const std::string& name) const {
  const auto found = std::find_if(worst_.begin(), worst_.end(), [&](const Worst& w) { return w.name == name; });
  NILAS_DEMAND(found != worst_.end());
  return *found;
}

double RunStatistics::relative_imbalance() const { return ratio(std::abs(worst("imbalance_J").value), energy_put_in_); }

std::optional<LoadError> RunStatistics::load_error(const TwinStatistics* twins) const {
  return nilas::load_error({load_names_, load_series_, t_start_, t_end_}, load_residuals_, twins);
}

double RunStatistics::mean_ms(Phase phase) const {
  return steps_ > 0 ? total_ms_[static_cast<std::size_t>(phase)] / static_cast<double>(steps_) : 0;
}

}  // namespace nilas
