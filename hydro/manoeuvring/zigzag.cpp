#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hydro/manoeuvring/imo_criteria.h"
#include "hydro/manoeuvring/manoeuvre.h"

namespace nilas::hydro {

namespace {

class Zigzag : public Manoeuvre {
 public:
  Zigzag(const ManoeuvreFrame& frame, double angle, double heading)
      : track_(frame), angle_(std::abs(angle)), heading_(heading), side_(angle < 0 ? -1 : 1) {}

  SteeringOrders go_on(const VesselInPlane& now, double t, double h, const SteeringOrders& present) override {
    track_.go_on(now, t, h);
    if (!overshoots_.empty()) overshoots_.back() = std::max(overshoots_.back(), -side_ * track_.turned() - heading_);
    if (side_ * track_.turned() >= heading_) {
      if (overshoots_.empty()) first_way_ = track_.way();
      times_.push_back(track_.time());
      overshoots_.push_back(side_ * track_.turned() - heading_);
      side_ = -side_;
    }
    return {side_ * angle_, present.rps};
  }

  std::vector<bodies::RunFigure> figures() const override {
    std::vector<bodies::RunFigure> all;
    const double L = track_.length(), speed = track_.approach_speed();
    const double angle_deg = angle_ / k_deg, heading_deg = heading_ / k_deg;
    if (overshoots_.empty()) return all;
    std::string way = fmt::format("{:.4g} m, {:.3f} L to the first switch", first_way_, first_way_ / L);
    if (imo_overshoot(angle_deg, heading_deg, 2, 0)) way += fmt::format("; IMO at most {} L", k_imo_initial_turning);
    all.push_back({"initial_turning_m", first_way_, "initial turning", way});
    for (std::size_t k = 0; k < std::min(overshoots_.size(), k_most_told); ++k) {
      const double overshoot = overshoots_[k] / k_deg;
      std::string text = fmt::format("{:.2f} deg after the switch at {:.4g} s", overshoot, times_[k]);
      const auto limit =
          imo_overshoot(angle_deg, heading_deg, static_cast<int>(k) + 1, speed > 0 ? L / speed : HUGE_VAL);
      if (limit) text += fmt::format("; IMO at most {:.3g} deg", *limit);
      if (k + 1 == overshoots_.size()) text += "; the last, and it may still grow";
      all.push_back({fmt::format("overshoot_{}_deg", k + 1), overshoot, fmt::format("overshoot {}", k + 1), text});
    }
    return all;
  }

  void save(StateWriter out) const override {
    track_.save(out);
    out.add("side", side_);
    out.add("first_way", first_way_);
    out.add("overshoots", overshoots_);
    out.add("times", times_);
  }
  void restore(const StateReader& in) override {
    track_.restore(in);
    in.get("side", side_);
    in.get("first_way", first_way_);
    in.get("overshoots", overshoots_);
    in.get("times", times_, overshoots_.size());
  }

 private:
  static constexpr std::size_t k_most_told = 4;

  ManoeuvreTrack track_;
  double angle_, heading_;          ///< [rad]
  double side_;                     ///< side of the rudder, 1 to starboard
  double first_way_ = 0;            ///< [m]
  std::vector<double> overshoots_;  ///< after each switch [rad]
  std::vector<double> times_;       ///< of the switches, since the start [s]
};

}  // namespace

std::unique_ptr<Manoeuvre> make_zigzag(const ManoeuvreFrame& frame, double angle, double heading) {
  return std::make_unique<Zigzag>(frame, angle, heading);
}

}  // namespace nilas::hydro
