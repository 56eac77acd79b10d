#include "core/output/loads/run_statistics.h"

#include <algorithm>
#include <cmath>

#include "contact/measure/measure.h"
#include "core/base/error.h"
#include "core/base/machine.h"
#include "core/output/tables/structure_channels.h"

namespace nilas::output {

namespace {

/// Ratio in which 0 / 0 is 0: a balance that holds exactly.
double ratio(double part, double scale) { return part == 0 ? 0 : part / scale; }

}  // namespace

RunStatistics::Columns::Columns(const sim::RunInfo& info) : has_tow(info.has_vessel && info.has_carriage) {
  if (info.has_vessel) {
    residuals = VesselChannels(info).load_names().size();
    count = residuals + LoadResiduals::k_columns;
  }
  tow = count;
  if (has_tow) count += k_tow_columns + info.vessel_loads.size();
  structures = count;
  count += info.structures.size() * structure_load_names().size();
}

/// The table of a run; in memory where it has no file, or nothing to hold.
static StepSeries table(std::size_t columns, const std::filesystem::path& file, std::optional<std::int64_t> keep) {
  return columns == 0 || file.empty() ? StepSeries(columns) : StepSeries(columns, file, keep);
}

RunStatistics::RunStatistics(const sim::RunInfo& info, const std::filesystem::path& file,
                             std::optional<std::int64_t> keep)
    : info_(info),
      columns_(info),
      series_(table(columns_.count, file, keep)),
      structure_first_ice_(info.structures.size(), k_never),
      processor_s_(processor_seconds()),
      works_(info.work_names.size(), 0),
      reactions_(info) {
  for (const auto& residual : contact::residual_columns()) worst_.push_back({residual.name});
  for (const char* name :
       {"penetration_max_m", "penetration_mean_m", "imbalance_J", "momentum_imbalance_Ns",
        "angular_momentum_imbalance_Nms", "momentum_imbalance_relative", "angular_momentum_imbalance_relative"})
    worst_.push_back({name});
  for (const std::string& column : info.module_columns) worst_.push_back({column});
  if (info.has_vessel) load_names_ = VesselChannels(info).load_names();
}

void RunStatistics::start(double t, const sim::Ledger& ledger) {
  t_start_ = t_end_ = t;
  energy_put_in_ = ledger.kinetic;
  works_ = ledger.works;
  processor_s_ = processor_seconds();
}

void RunStatistics::add(const sim::StepRecord& record, const std::vector<double>& vessel_values) {
  ++steps_;
  t_end_ = record.t;
  std::size_t column = 0;
  for (const auto& residual : contact::residual_columns()) note(column++, record.residuals.*residual.member, record.t);
  for (const double value :
       {record.penetration_max, record.penetration_mean, record.ledger.imbalance, record.momentum_imbalance,
        record.angular_momentum_imbalance, ratio(record.momentum_imbalance, record.momentum_scale),
        ratio(record.angular_momentum_imbalance, record.angular_momentum_scale)})
    note(column++, value, record.t);
  for (const double value : record.module_values) note(column++, value, record.t);
  for (std::size_t k = 0; k < works_.size(); ++k) energy_put_in_ += std::abs(record.ledger.works[k] - works_[k]);
  works_ = record.ledger.works;
  for (std::size_t p = 0; p < total_ms_.size(); ++p) total_ms_[p] += record.ms[p];
  shortfalls_.unconverged_steps += record.solver_short;
  shortfalls_.uncorrected_steps += !record.positions_corrected;
  detection_ += record.detection;
  reactions_.add(record);
  h_ = record.h;
  if (!record.broken.empty()) first_break_ = std::min(first_break_, record.t);
  constexpr double k_milli = 1e-3;
  const double processor_s = processor_seconds();
  costs_.add(record, 1 / k_milli * (processor_s - processor_s_));
  processor_s_ = processor_s;
  step_loads_.add(record);
  row_.clear();
  if (info_.has_vessel) add_vessel(record, vessel_values);
  add_structures(record);
  series_.append(row_);
}

void RunStatistics::add_vessel(const sim::StepRecord& record, const std::vector<double>& vessel_values) {
  const sim::VesselRecord& vessel = record.vessel.value();
  const std::vector<double> loads = VesselChannels(info_).loads(vessel_values);
  row_.insert(row_.end(), loads.begin(), loads.end());
  LoadResiduals::add_to(row_, record);
  if (vessel.touches_ice) first_ice_ = std::min(first_ice_, record.t - record.h);
  if (!columns_.has_tow) return;
  const auto along = [&](const Vec3& x) { return x.head<2>().dot(vessel.course); };
  row_.push_back(along(vessel.carriage.value().about_com.force));
  row_.push_back(vessel.hydro ? -along(vessel.hydro->force) : 0);
  row_.push_back(-along(vessel.contact.force - vessel.ice));
  row_.push_back(along(vessel.state.v));
  for (std::size_t m = 0; m < info_.vessel_loads.size(); ++m) row_.push_back(-along(vessel.module_loads[m].force));
}

void RunStatistics::add_structures(const sim::StepRecord& record) {
  NILAS_DEMAND(record.structures.size() == info_.structures.size());
  for (std::size_t k = 0; k < record.structures.size(); ++k) {
    if (record.structures[k].touches_ice)
      structure_first_ice_[k] = std::min(structure_first_ice_[k], record.t - record.h);
    const std::vector<double> loads = nilas::output::structure_loads(record.structures[k], info_.drift_course);
    row_.insert(row_.end(), loads.begin(), loads.end());
  }
}

void RunStatistics::note(std::size_t column, double value, double t) {
  Worst& worst = worst_[column];
  // A NaN replaces any number, and the first NaN stays.
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
  series_.save(out.group("series"));
  step_loads_.save(out.group("step_loads"));
  out.add("first_ice", first_ice_);
  out.add("first_break", first_break_);
  out.add("structures_first_ice", structure_first_ice_);
  costs_.save(out.group("costs"));
  out.add("h", h_);
  out.add("works", works_);
  out.add("energy_put_in", energy_put_in_);
  out.add("t_start", t_start_);
  out.add("t_end", t_end_);
  out.add("steps", steps_);
  out.add("total_ms", total_ms_);
  out.add("unconverged_steps", shortfalls_.unconverged_steps);
  out.add("uncorrected_steps", shortfalls_.uncorrected_steps);
  std::vector<long> counts;
  for (const auto count : detect::k_detector_counts) counts.push_back(detection_.*count);
  out.add("detection", counts);
  reactions_.save(out.group("reactions"));
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
  series_.restore(in.group("series"), static_cast<std::size_t>(steps_));
  step_loads_.restore(in.group("step_loads"));
  in.get("first_ice", first_ice_);
  in.get("first_break", first_break_);
  in.get("structures_first_ice", structure_first_ice_, info_.structures.size());
  costs_.restore(in.group("costs"));
  in.get("h", h_);
  in.get("works", works_, works_.size());
  in.get("energy_put_in", energy_put_in_);
  in.get("t_start", t_start_);
  in.get("t_end", t_end_);
  in.get("total_ms", total_ms_);
  in.get("unconverged_steps", shortfalls_.unconverged_steps);
  in.get("uncorrected_steps", shortfalls_.uncorrected_steps);
  std::vector<long> counts;
  in.get("detection", counts, detect::k_detector_counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) detection_.*detect::k_detector_counts[k] = counts[k];
  reactions_.restore(in.group("reactions"));
  processor_s_ = processor_seconds();
}

const Worst& RunStatistics::worst(const std::string& name) const {
  const auto found = std::find_if(worst_.begin(), worst_.end(), [&](const Worst& w) { return w.name == name; });
  NILAS_DEMAND(found != worst_.end());
  return *found;
}

double RunStatistics::relative_imbalance() const { return ratio(std::abs(worst("imbalance_J").value), energy_put_in_); }

LoadWindow RunStatistics::window_from(std::optional<double> first_ice, std::optional<double> ramp_end) const {
  if (first_ice && *first_ice >= k_never) first_ice.reset();
  if (steps_ == 0) return {t_start_, t_start_, 0, 0, "the whole run"};
  return load_window({t_start_, h_, static_cast<std::size_t>(steps_), info_.statistics, ramp_end, first_ice});
}

LoadWindow RunStatistics::window() const { return window_from(first_ice_, info_.ramp_end); }

double RunStatistics::peak_filter() const {
  return info_.peak_filter.value_or(default_peak_filter(info_.vessel_length));
}

std::optional<LoadError> RunStatistics::load_error(const TwinStatistics* twins) const {
  const LoadWindow counted = window();
  return nilas::output::load_error({load_names_, SeriesPart(series_, 0), counted, first_break_ - 0.5 * h_ < counted.to},
                                   LoadResiduals(SeriesPart(series_, columns_.residuals)), twins);
}

std::vector<double> RunStatistics::load_series(std::size_t channel, const LoadWindow& window) const {
  return series_.column(channel, window.first, window.last);
}

std::vector<double> RunStatistics::load_named(const std::string& name, const LoadWindow& window) const {
  const auto found = std::find(load_names_.begin(), load_names_.end(), name);
  NILAS_DEMAND(found != load_names_.end());
  return load_series(static_cast<std::size_t>(found - load_names_.begin()), window);
}

std::optional<double> RunStatistics::mean_tow(const LoadWindow& window) const {
  if (steps_ == 0 || !columns_.has_tow || info_.course != sim::CourseKind::carriage) return std::nullopt;
  return mean_of_tow(k_tow, window);
}

double RunStatistics::mean_of_tow(std::size_t column, const LoadWindow& window) const {
  return load_statistics(SeriesPart(series_, columns_.tow).over(window, column)).mean;
}

TowForce RunStatistics::tow_force(const LoadWindow& window) const {
  const LoadStatistics tow = load_statistics(SeriesPart(series_, columns_.tow).over(window, k_tow));
  TowForce force;
  force.mean = tow.mean;
  force.std = tow.std;
  force.ice = load_statistics(load_named("ice_resistance_N", window)).mean;
  force.water = mean_of_tow(k_water, window);
  force.others = mean_of_tow(k_others, window);
  force.inertia = force.mean - force.ice - force.others - force.water;  // Newton's law along the course
  for (std::size_t m = 0; m < info_.vessel_loads.size(); ++m) {
    const double mean = mean_of_tow(k_tow_columns + m, window);
    force.modules.emplace_back(info_.vessel_loads[m], mean);
    force.inertia -= mean;
  }
  force.on_rods = !info_.rods.empty();
  force.speed = mean_of_tow(k_speed, window);
  return force;
}

std::optional<IceLoad> RunStatistics::ice_load(const TwinStatistics* twins) const {
  const auto error = load_error(twins);
  if (!error) return std::nullopt;
  IceLoad load;
  load.window = window();
  load.filter = peak_filter();
  load.step = h_;
  load.rigid = info_.rigid_contacts;
  load.elastic = info_.elastic_contacts;
  const auto component = [&](const char* name, const std::vector<double>& series) {
    ComponentLoad found = component_load(series, load.window.from, h_, load.filter, error->ice_broke);
    for (const ChannelError& c : error->channels)
      if (c.channel == name) {
        found.statistics.mean = c.mean;
        if (c.chaos) found.half_width = c.total;
      }
    return found;
  };
  const std::vector<double> along = load_named("ice_resistance_N", load.window);
  load.along = component("ice_resistance_N", along);
  load.across = component("ice_side_N", load_named("ice_side_N", load.window));
  load.touched = load.along.statistics.max > 0 || load.across.statistics.max > 0;
  load.filter = load.along.peak.filter;
  load.in_largest = share_of_largest_percent(along);
  load.on_step = step_dependence(along, h_, load.filter, load.rigid);
  load.on_step.doubted = step_load_error().is_doubted();
  if (mean_tow(load.window)) load.tow = tow_force(load.window);
  return load;
}

StepLoadError RunStatistics::step_load_error() const {
  if (info_.has_vessel) return step_loads_.error(info_, window());
  return step_loads_.error(info_, {t_start_, t_end_, 0, static_cast<std::size_t>(steps_), ""});
}

StructureLoad RunStatistics::structure_load(std::size_t structure) const {
  const auto& names = structure_load_names();
  const SeriesPart series(series_, columns_.structures + structure * names.size());
  StructureLoad load;
  load.name = info_.structures[structure].name;
  load.ice.window = window_from(structure_first_ice_[structure], std::nullopt);
  load.ice.filter = info_.peak_filter.value_or(default_peak_filter(info_.structures[structure].length));
  load.ice.step = h_;
  load.ice.touched = structure_first_ice_[structure] < k_never;
  load.ice.rigid = info_.rigid_contacts;
  load.ice.elastic = info_.elastic_contacts;
  for (std::size_t c = 0; c < names.size(); ++c)
    load.loads.emplace_back(names[c], component_load(series.over(load.ice.window, c), load.ice.window.from, h_,
                                                     load.ice.filter, first_break_ - 0.5 * h_ < load.ice.window.to));
  const std::size_t along_course = names.size() - k_num_course_loads;
  load.ice.along = load.loads[along_course].second;
  load.ice.across = load.loads.back().second;
  load.ice.filter = load.ice.along.peak.filter;
  const std::vector<double> along = series.over(load.ice.window, along_course);
  load.ice.in_largest = share_of_largest_percent(along);
  load.ice.on_step = step_dependence(along, h_, load.ice.filter, load.ice.rigid);
  load.ice.on_step.doubted = step_load_error().is_doubted();
  return load;
}

std::vector<StructureLoad> RunStatistics::structure_loads() const {
  std::vector<StructureLoad> all;
  for (std::size_t k = 0; k < info_.structures.size(); ++k) all.push_back(structure_load(k));
  return all;
}

std::string RunStatistics::slowdown() const {
  const double first = first_ice_ < k_never && h_ > 0 ? (first_ice_ - t_start_) / h_ : 0;
  return costs_.slowdown(static_cast<std::size_t>(std::max(0.0, first)));
}

double RunStatistics::mean_ms(sim::Phase phase) const {
  return steps_ > 0 ? total_ms_[static_cast<std::size_t>(phase)] / static_cast<double>(steps_) : 0;
}

}  // namespace nilas::output
