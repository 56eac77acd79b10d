#include "core/output/loads/step_load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/statistics.h"
#include "core/output/loads/ice_load_text.h"
#include "core/output/text/console.h"

namespace nilas::output {

namespace {

std::string steps_text(long count) { return fmt::format("{} step{}", count, count == 1 ? "" : "s"); }

/// Two digits suffice for an error.
std::string share_text(double share) {
  constexpr double k_percent = 100, k_least = 1e-5;
  return share < k_least ? fmt::format("less than {:g} %", k_percent * k_least)
                         : fmt::format("{:.2g} %", k_percent * share);
}

}  // namespace

void StepLoads::add(const sim::StepRecord& record) {
  if (!record.load_check) return;
  const sim::LoadCheck& check = *record.load_check;
  if (!check.is_strict) {
    unsolved_.push_back(record.step);
    return;
  }
  double size = 0, error = 0;
  for (std::size_t k = 0; k < check.strict.size(); ++k) {
    size += check.strict[k].squaredNorm();
    error += (check.load[k] - check.strict[k]).squaredNorm();
  }
  if (size == 0 && error == 0) return;
  checked_.push_back(record.step);
  size_.push_back(std::sqrt(size));
  error_.push_back(std::sqrt(error));
}

StepLoadError StepLoads::error(const sim::RunInfo& info, const LoadWindow& window) const {
  StepLoadError found{.every = info.check_every, .tolerance = info.check_tolerance};
  const auto counts = [&](long step) {
    return step > static_cast<long>(window.first) && step <= static_cast<long>(window.last);
  };
  found.unsolved = std::count_if(unsolved_.begin(), unsolved_.end(), counts);
  std::vector<double> sizes, errors;
  for (std::size_t k = 0; k < checked_.size(); ++k) {
    if (!counts(checked_[k])) continue;
    sizes.push_back(size_[k]);
    errors.push_back(error_[k]);
  }
  found.checked = static_cast<long>(errors.size());
  if (errors.empty()) return found;
  constexpr double k_most = 0.95;
  found.mean = mean_of(sizes);
  // where ice bears nothing by the second solutions, all that the run counts is error
  const auto share = [&](double newton) { return newton == 0 ? 0 : found.mean > 0 ? newton / found.mean : 1; };
  found.median = share(median_of(errors));
  found.p95 = share(percentile_of(std::move(errors), k_most));
  return found;
}

void StepLoads::save(StateWriter out) const {
  out.add("checked", checked_);
  out.add("unsolved", unsolved_);
  out.add("size", size_);
  out.add("error", error_);
}

void StepLoads::restore(const StateReader& in) {
  in.get("checked", checked_);
  in.get("unsolved", unsolved_);
  in.get("size", size_, checked_.size());
  in.get("error", error_, checked_.size());
}

std::string step_load_text(const StepLoadError& error) {
  if (error.checked + error.unsolved == 0) return "";
  if (error.checked == 0)
    return fmt::format(
        "How far the ice load of one step is off is not known: a second solution to {:g} m/s did not succeed in any of "
        "{}.",
        error.tolerance, steps_text(error.unsolved));
  std::string text = fmt::format(
      "By a second solution of {} to {:g} m/s, the ice load of one step is off by {} in the median and by {} in the "
      "95th percentile, of {} on average.",
      steps_text(error.checked), error.tolerance, share_text(error.median), share_text(error.p95),
      force_text(error.mean));
  if (error.unsolved > 0)
    text += fmt::format(" In {} more the second solution did not succeed.", steps_text(error.unsolved));
  if (error.is_trusted()) return text;
  text += " Do not use single steps and raw peaks of this run.";
  text += error.p95 > StepLoadError::k_trusted
              ? " The residual does not show this, since sweeps hide the pressure of a jam. Set "
                "contact/@law=\"coulomb\" with contact/@solver=\"auto\", or a smaller contact/@tolerance."
              : " Steps whose second solution does not succeed are those that jam most, and may be off by more.";
  return text;
}

std::string step_load_lines(const StepLoadError& error) {
  const std::string text = step_load_text(error);
  return text.empty() ? "" : account_line("single steps", text);
}

nlohmann::ordered_json step_load_json(const StepLoadError& error) {
  nlohmann::ordered_json json{{"every_steps", error.every},
                              {"tolerance_m_s", error.tolerance},
                              {"checked_steps", error.checked},
                              {"unsolved_steps", error.unsolved}};
  if (error.checked == 0) return json;
  json["mean_N"] = error.mean;
  json["error_median_1"] = error.median;
  json["error_p95_1"] = error.p95;
  json["trusted"] = error.is_trusted();
  return json;
}

StepLoadError step_load_error_of(const nlohmann::ordered_json& summary) {
  StepLoadError error;
  if (!summary.is_object() || !summary.contains("step_load_error")) return error;
  const auto& json = summary.at("step_load_error");
  error.every = json.value("every_steps", 0L);
  error.tolerance = json.value("tolerance_m_s", 0.0);
  error.checked = json.value("checked_steps", 0L);
  error.unsolved = json.value("unsolved_steps", 0L);
  error.mean = json.value("mean_N", 0.0);
  error.median = json.value("error_median_1", 0.0);
  error.p95 = json.value("error_p95_1", 0.0);
  return error;
}

}  // namespace nilas::output
