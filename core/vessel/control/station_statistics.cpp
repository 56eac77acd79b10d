#include "core/vessel/control/station_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace nilas::vessel {

void StationStatistics::add(const StationSample& sample, double t, double h) {
  const bool outside = watch_circle_ && sample.offset > *watch_circle_;
  const double middle = t - 0.5 * h;
  const bool counts = middle >= from_ && middle <= to_;
  // A vessel that is outside where the window begins raises its alarm there.
  const bool leaves = outside && (outside_ == 0 || time_ == 0);
  outside_ = outside ? 1 : 0;
  if (!counts) return;
  time_ += h;
  offset_squared_ += h * sample.offset * sample.offset;
  offset_max_ = std::max(offset_max_, sample.offset);
  heading_squared_ += h * sample.heading_error * sample.heading_error;
  heading_max_ = std::max(heading_max_, std::abs(sample.heading_error));
  thrust_ += h * sample.thrust_use;
  if (sample.saturated) {
    saturated_time_ += h;
    force_shortfall_ = std::max(force_shortfall_, sample.force_shortfall);
    moment_shortfall_ = std::max(moment_shortfall_, sample.moment_shortfall);
  }
  if (outside) outside_time_ += h;
  if (leaves) ++alarms_;
}

std::optional<double> StationStatistics::total(std::string_view name) const {
  const double time = time_ > 0 ? time_ : 1;  // all sums are zero then
  if (name == k_dp_time) return time_;
  if (name == k_dp_offset_rms) return std::sqrt(offset_squared_ / time);
  if (name == k_dp_offset_max) return offset_max_;
  if (name == k_dp_heading_rms) return std::sqrt(heading_squared_ / time);
  if (name == k_dp_heading_max) return heading_max_;
  if (name == k_dp_outside) return outside_time_;
  if (name == k_dp_alarms) return static_cast<double>(alarms_);
  if (name == k_dp_thrust_use) return thrust_ / time;
  if (name == k_dp_saturation_share) return saturated_time_ / time;
  return std::nullopt;
}

std::string StationStatistics::saturation_text(double share) const {
  constexpr double k_percent = 100;
  if (share == 0) return "never: they gave all that the control wanted";
  return fmt::format("in {:.3g} % of the time they gave less than the control wanted, by up to {:.3g} N and {:.3g} N m",
                     k_percent * share, force_shortfall_, moment_shortfall_);
}

std::vector<bodies::RunFigure> StationStatistics::figures() const {
  const auto value = [&](std::string_view name) { return total(name).value(); };
  const double rms = value(k_dp_offset_rms), turn = value(k_dp_heading_rms) / k_deg;
  const double most_turn = heading_max_ / k_deg, use = value(k_dp_thrust_use), short_of = value(k_dp_saturation_share);
  constexpr double k_percent = 100;
  std::vector<bodies::RunFigure> figures{
      {"time_s", time_, "positioning", fmt::format("counted over {:g} s", time_)},
      {"offset_rms_m", rms, "offset", fmt::format("{:.3g} m rms, at most {:.3g} m", rms, offset_max_)},
      {"offset_max_m", offset_max_, "", ""},
      {"heading_error_rms_deg", turn, "heading error",
       fmt::format("{:.3g} deg rms, at most {:.3g} deg", turn, most_turn)},
      {"heading_error_max_deg", most_turn, "", ""},
      {"thrust_use_1", use, "thrust used", fmt::format("{:.3g} % of all limits, mean", k_percent * use)},
      {"saturation_share_1", short_of, "thrusters saturated", saturation_text(short_of)},
      {"force_shortfall_max_N", force_shortfall_, "", ""},
      {"moment_shortfall_max_Nm", moment_shortfall_, "", ""}};
  if (!watch_circle_) return figures;
  figures.push_back({"time_outside_s", outside_time_, "watch circle",
                     fmt::format("left {} times, {:.3g} s outside of {:g} m", alarms_, outside_time_, *watch_circle_)});
  figures.push_back({"alarms", static_cast<double>(alarms_), "", ""});
  return figures;
}

void StationStatistics::save(StateWriter out) const {
  out.add("sums", std::vector<double>{time_, offset_squared_, offset_max_, heading_squared_, heading_max_,
                                      outside_time_, thrust_, saturated_time_, force_shortfall_, moment_shortfall_});
  out.add("alarms", alarms_);
  out.add("outside", outside_);
}

void StationStatistics::restore(const StateReader& in) {
  const std::vector<double*> members{
      &time_,         &offset_squared_, &offset_max_,     &heading_squared_, &heading_max_,
      &outside_time_, &thrust_,         &saturated_time_, &force_shortfall_, &moment_shortfall_};
  std::vector<double> sums;
  in.get("sums", sums, members.size());
  for (std::size_t k = 0; k < sums.size(); ++k) *members[k] = sums[k];
  in.get("alarms", alarms_);
  in.get("outside", outside_);
}

}  // namespace nilas::vessel
