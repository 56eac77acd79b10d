#include "core/output/run/run_summary.h"

#include <cmath>

#include "core/base/json_text.h"

namespace nilas::output {

namespace {

using Json = nlohmann::ordered_json;

Json::json_pointer place(const std::string& path) { return Json::json_pointer(path); }

/// A user's name, escaped for a JSON pointer (RFC 6901).
std::string in_path(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return out;
}

/// Calls `visit(path, figure)` for every figure with a fixed path. Reading and writing share these paths.
template <class Summary, class Visit>
void visit_figures(Summary& s, const Visit& visit) {
  visit("/scene", s.scene);
  visit("/status", s.status);
  visit("/ended_early", s.ended_early);
  visit("/seed", s.seed);
  visit("/time_end_s", s.time_end_s);
  visit("/steps", s.steps);
  visit("/wall_s", s.wall_s);
  visit("/real_time_factor", s.real_time_factor);
  visit("/ice/floes_end", s.floes_end);
  visit("/shortfalls/unconverged_steps", s.unconverged_steps);
  visit("/step_load_error/error_median_1", s.step_load_median);
  visit("/step_load_error/error_p95_1", s.step_load_p95);
  visit("/worst/penetration_max_m/value", s.penetration_max_m);
  visit("/worst/imbalance_J/relative_to_energy_put_in", s.imbalance_relative);
  visit("/worst/momentum_imbalance_relative/value", s.momentum_imbalance_relative);
  for (const auto& column : contact::residual_columns())
    visit(std::string("/worst/") + column.name + "/value", s.residuals.*column.member);
  for (int p = 0; p < sim::k_num_phases; ++p)
    visit(std::string("/modules/ms_per_step/") + sim::to_string(static_cast<sim::Phase>(p)), s.phase_ms[p]);
  visit("/ice_load/touched", s.touched);
}

/// Visits the statistics of a channel, then its error estimate.
template <class Statistics, class Visit>
void visit_load(const std::string& channel, Statistics& s, const Visit& visit) {
  const std::string path = "/loads/" + in_path(channel);
  visit(path + "/mean", s.mean);
  visit(path + "/std", s.std);
  visit(path + "/max", s.max);
  visit(path + "/p99", s.p99);
}
template <class Figures, class Visit>
void visit_load_error(const std::string& channel, Figures& s, const Visit& visit) {
  const std::string path = "/load_error/channels/" + in_path(channel);
  visit(path + "/estimate", s.estimate);
  visit(path + "/solver", s.solver);
  visit(path + "/law", s.law);
  visit(path + "/chaos", s.chaos);
}
template <class Span, class Visit>
void visit_window(Span& s, const Visit& visit) {
  visit("/window/from_s", s.from);
  visit("/window/to_s", s.to);
  visit("/window/reason", s.reason);
}

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}
  void operator()(const std::string& path, double& x) const {
    const Json* found = at(path);
    x = found != nullptr && found->is_number() ? found->get<double>() : RunSummary::k_none;
  }
  void operator()(const std::string& path, std::string& x) const {
    if (const Json* found = at(path); found != nullptr && found->is_string()) x = found->get<std::string>();
  }
  void operator()(const std::string& path, std::optional<std::uint64_t>& x) const {
    if (const Json* found = at(path); found != nullptr && found->is_number_integer()) x = found->get<std::uint64_t>();
  }
  void operator()(const std::string& path, std::optional<bool>& x) const {
    if (const Json* found = at(path); found != nullptr && found->is_boolean()) x = found->get<bool>();
  }
  /// Names of the members of an object.
  std::vector<std::string> names(const std::string& path) const {
    std::vector<std::string> all;
    if (const Json* found = at(path); found != nullptr && found->is_object())
      for (const auto& [name, value] : found->items()) all.push_back(name);
    return all;
  }

 private:
  const Json* at(const std::string& path) const {
    return json_.contains(place(path)) ? &json_.at(place(path)) : nullptr;
  }
  const Json& json_;
};

class Writer {
 public:
  explicit Writer(Json& json) : json_(json) {}
  void operator()(const std::string& path, double x) const {
    if (std::isfinite(x)) json_[place(path)] = x;
  }
  void operator()(const std::string& path, const std::string& x) const {
    if (!x.empty()) json_[place(path)] = x;
  }
  template <class Value>
  void operator()(const std::string& path, const std::optional<Value>& x) const {
    if (x) json_[place(path)] = *x;
  }

 private:
  Json& json_;
};

}  // namespace

const LoadStatistics* RunSummary::load(const std::string& channel) const {
  for (const auto& [name, statistics] : loads)
    if (name == channel) return &statistics;
  return nullptr;
}

contact::Residuals RunSummary::no_residuals() {
  contact::Residuals none;
  for (const auto& column : contact::residual_columns()) none.*column.member = k_none;
  return none;
}

std::array<double, sim::k_num_phases> RunSummary::no_phases() {
  std::array<double, sim::k_num_phases> none{};
  none.fill(k_none);
  return none;
}

RunSummary run_summary_from(const Json& json) {
  RunSummary summary;
  if (!json.is_object()) return summary;
  const Reader read(json);
  visit_figures(summary, read);
  for (double& ms : summary.phase_ms)
    if (std::isnan(ms)) ms = 0;  // a module that was not built takes no time
  if (json.contains("window")) visit_window(summary.window.emplace(), read);
  for (const auto& name : read.names("/loads"))
    visit_load(name, summary.loads.emplace_back(name, LoadStatistics{}).second, read);
  for (const auto& name : read.names("/load_error/channels")) visit_load_error(name, summary.load_errors[name], read);
  return summary;
}

Json to_json(const RunSummary& summary) {
  if (!summary.exists()) return nullptr;
  Json json = Json::object();
  const Writer write(json);
  visit_figures(summary, write);
  if (summary.window) visit_window(*summary.window, write);
  for (const auto& [name, statistics] : summary.loads) visit_load(name, statistics, write);
  for (const auto& [name, figures] : summary.load_errors) visit_load_error(name, figures, write);
  return json;
}

RunSummary read_run_summary(const std::filesystem::path& run_folder) {
  const std::filesystem::path file = run_folder / "summary.json";
  return std::filesystem::exists(file) ? run_summary_from(Json::parse(json_file_text(file), nullptr, false))
                                       : RunSummary{};
}

}  // namespace nilas::output
