#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "hydro/manoeuvring/manoeuvre.h"

namespace nilas::hydro {

namespace {

/// An integral that rests where its command is at a limit and it would push it further.
double wound(double integral, double error, double h, double command, double least, double most) {
  if ((command >= most && error > 0) || (command <= least && error < 0)) return integral;
  return integral + h * error;
}

class CourseAutopilot : public Manoeuvre {
 public:
  CourseAutopilot(const ManoeuvreFrame& frame, std::vector<CourseOrder> orders, const AutopilotGains& gains)
      : track_(frame), orders_(std::move(orders)), gains_(gains) {}

  SteeringOrders go_on(const VesselInPlane& now, double t, double h, const SteeringOrders& present) override {
    const bool first = !track_.has_begun();
    track_.go_on(now, t, h);
    const CourseOrder& order = order_at(t);
    // Both to port, as the heading.
    const double error = std::remainder(order.heading - now.yaw, 2 * k_pi), rate = -now.motion.r;
    const double slow = order.speed - now.motion.u;
    const double turn =
        gains_.heading_gain * (error + turn_integral_ / gains_.heading_time) - gains_.yaw_rate_gain * rate;
    const double rps =
        gains_.rps_per_speed * (order.speed + gains_.speed_gain * (slow + speed_integral_ / gains_.speed_time));
    const SteeringOrders orders{-std::clamp(turn, -gains_.max_rudder, gains_.max_rudder),
                                std::clamp(rps, 0.0, gains_.max_rps)};
    if (first) return orders;
    turn_integral_ = wound(turn_integral_, error, h, turn, -gains_.max_rudder, gains_.max_rudder);
    speed_integral_ = wound(speed_integral_, slow, h, rps, 0, gains_.max_rps);
    time_ += h;
    sums_[0] += h * now.motion.u;
    sums_[1] += h * slow * slow;
    sums_[2] += h * error * error;
    sums_[3] += h * present.rudder * present.rudder;
    sums_[4] += std::abs(turn) >= gains_.max_rudder ? h : 0;
    sums_[5] += rps >= gains_.max_rps ? h : 0;
    return orders;
  }

  std::vector<bodies::RunFigure> figures() const override {
    if (!(time_ > 0)) return {};
    constexpr double k_percent = 100;
    const auto mean = [&](std::size_t k) { return sums_.at(k) / time_; };
    const double speed = mean(0), slow = std::sqrt(mean(1)), error = std::sqrt(mean(2)) / k_deg;
    const double rudder = std::sqrt(mean(3)) / k_deg, limit = k_percent * mean(4), full = k_percent * mean(5);
    return {{"mean_speed_m_s", speed, "mean speed", fmt::format("{:.4g} m/s ahead through the water", speed)},
            {"speed_error_rms_m_s", slow, "speed error", fmt::format("{:.3g} m/s (rms)", slow)},
            {"heading_error_rms_deg", error, "heading error", fmt::format("{:.3g} deg (rms)", error)},
            {"rudder_rms_deg", rudder, "rudder asked for", fmt::format("{:.3g} deg (rms)", rudder)},
            {"rudder_at_limit_percent", limit, "rudder at its limit", fmt::format("{:.3g} % of the time", limit)},
            {"propeller_at_limit_percent", full, "propeller at limit", fmt::format("{:.3g} % of the time", full)}};
  }

  void save(StateWriter out) const override {
    track_.save(out);
    out.add("integrals", std::array{turn_integral_, speed_integral_, time_});
    out.add("sums", sums_);
  }
  void restore(const StateReader& in) override {
    track_.restore(in);
    std::array<double, 3> all{};
    in.get("integrals", all);
    turn_integral_ = all[0];
    speed_integral_ = all[1];
    time_ = all[2];
    in.get("sums", sums_);
  }

 private:
  /// The last order whose time has come, or the first.
  const CourseOrder& order_at(double t) const {
    const auto next =
        std::upper_bound(orders_.begin(), orders_.end(), t, [](double at, const CourseOrder& o) { return at < o.t; });
    return next == orders_.begin() ? orders_.front() : *(next - 1);
  }

  ManoeuvreTrack track_;
  std::vector<CourseOrder> orders_;
  AutopilotGains gains_;
  double turn_integral_ = 0, speed_integral_ = 0;  ///< [rad s], [m]
  double time_ = 0;                                ///< under control [s]
  /// Integrals over that time of surge velocity, square of the speed error, of the heading error and of the rudder
  /// order, and the times with the rudder and with the propeller at the limit.
  std::array<double, 6> sums_{};
};

}  // namespace

std::vector<CourseOrder> read_course_orders(const std::string& file, double scale) {
  const CsvTable table = read_csv(file, {"t_s", "heading_deg", "speed_m_s"});
  const double root = std::sqrt(scale);
  std::vector<CourseOrder> orders;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    const auto refuse = [&](const std::string& fault) {
      throw InputError(fmt::format("{}:{}: {}", file, table.lines[k], fault));
    };
    if (k > 0 && !(row[0] > table.rows[k - 1][0]))
      refuse(fmt::format("t_s is {:g} after {:g}; allowed: times that rise", row[0], table.rows[k - 1][0]));
    if (!(row[2] >= 0)) refuse(fmt::format("speed_m_s is {:g}; allowed: >= 0", row[2]));
    orders.push_back({root * row[0], row[1] * k_deg, root * row[2]});
  }
  return orders;
}

std::unique_ptr<Manoeuvre> make_course(const ManoeuvreFrame& frame, std::vector<CourseOrder> orders,
                                       const AutopilotGains& gains) {
  NILAS_DEMAND(!orders.empty() && gains.heading_time > 0 && gains.speed_time > 0);
  return std::make_unique<CourseAutopilot>(frame, std::move(orders), gains);
}

}  // namespace nilas::hydro
