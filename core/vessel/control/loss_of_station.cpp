#include "core/vessel/control/loss_of_station.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace nilas::vessel {

void LossOfStation::add(const Vec2& force, double moment, Shortfall shortfall, double h) {
  time_ += h;
  switch (shortfall) {
    case Shortfall::none:
      return;
    case Shortfall::force:
      force_time_ += h;
      force_ += h * force;
      force_size_ += h * force.norm();
      return;
    case Shortfall::moment:
      moment_time_ += h;
      moment_ += h * moment;
      moment_size_ += h * std::abs(moment);
      return;
  }
}

bool LossOfStation::one_way() const {
  constexpr double k_one_way = 0.5;  // of the magnitude: a swinging load cancels itself, a steady one does not
  if (moment_time_ > force_time_) return std::abs(moment_) > k_one_way * moment_size_;
  return force_.norm() > k_one_way * force_size_;
}

std::string LossOfStation::seen() const {
  constexpr double k_percent = 100;
  return fmt::format(
      "The thrusters gave less than the control wanted in {:.0f} % of the time. The {} that was wanted then {}",
      k_percent * short_share(), moment_time_ > force_time_ ? "moment" : "force",
      one_way() ? "pointed one way. So the loads on the vessel exceed the thrusters, or the control diverged in its "
                  "first swing. Allowed are stronger thrusters, fewer failures, weaker ice, current and wind, or a "
                  "lower <control bandwidth>."
                : "swung to and fro. So the control diverges. Allowed are a lower <control bandwidth>, a shorter "
                  "sensor_period, sensor_delay or lag of the thrusters, or a damping that suits the vessel.");
}

std::string LossOfStation::text() const {
  constexpr double k_percent = 100, k_seldom = 0.05;  // share of the time
  if (short_share() >= k_seldom) return seen();
  return fmt::format(
      "The thrusters gave what the control wanted in {:.0f} % of the time. So the control is too slow for the loads on "
      "the vessel, or it diverges. Allowed are another <control bandwidth>, or a damping_ratio and damping that suit "
      "the vessel.",
      k_percent * (1 - short_share()));
}

std::string LossOfStation::swinging() const {
  constexpr double k_often = 0.5;  // share of the time
  return short_share() < k_often || one_way() ? std::string() : seen();
}

void LossOfStation::save(StateWriter out) const {
  out.add("loads",
          std::array{time_, force_time_, force_.x(), force_.y(), force_size_, moment_time_, moment_, moment_size_});
}

void LossOfStation::restore(const StateReader& in) {
  std::array<double, 8> all{};
  in.get("loads", all);
  time_ = all[0];
  force_time_ = all[1];
  force_ = {all[2], all[3]};
  force_size_ = all[4];
  moment_time_ = all[5];
  moment_ = all[6];
  moment_size_ = all[7];
}

}  // namespace nilas::vessel
