#include <fmt/format.h>

#include <cmath>

#include "hydro/manoeuvring/imo_criteria.h"
#include "hydro/manoeuvring/manoeuvre.h"

namespace nilas::hydro {

namespace {

constexpr double k_not_reached = -1;  // a time [s]

std::string in_lengths(double way, double length) { return fmt::format("{:.4g} m, {:.3f} L", way, way / length); }

class Straight : public Manoeuvre {
 public:
  explicit Straight(const ManoeuvreFrame& frame) : track_(frame) {}
  SteeringOrders go_on(const VesselInPlane& now, double t, double h, const SteeringOrders& present) override {
    track_.go_on(now, t, h);
    speed_ = now.speed();
    return {0, present.rps};
  }
  std::vector<bodies::RunFigure> figures() const override {
    if (!(track_.time() > 0)) return {};
    const double off = std::abs(track_.aside()), turned = -track_.turned() / k_deg, mean = track_.way() / track_.time();
    return {{"mean_speed_m_s", mean, "mean speed", fmt::format("{:.4g} m/s through the water", mean)},
            {"end_speed_m_s", speed_, "speed at the end", fmt::format("{:.4g} m/s through the water", speed_)},
            {"off_track_m", off, "off the track",
             fmt::format("{:.4g} m at the end, after {:.4g} m ahead", off, track_.ahead())},
            {"heading_change_deg", turned, "change of heading", fmt::format("{:.4g} deg, positive to port", turned)}};
  }
  void save(StateWriter out) const override {
    track_.save(out);
    out.add("speed", speed_);
  }
  void restore(const StateReader& in) override {
    track_.restore(in);
    in.get("speed", speed_);
  }

 private:
  ManoeuvreTrack track_;
  double speed_ = 0;  ///< [m/s]
};

class TurningCircle : public Manoeuvre {
 public:
  TurningCircle(const ManoeuvreFrame& frame, double angle) : track_(frame), angle_(angle), side_(angle < 0 ? -1 : 1) {}

  SteeringOrders go_on(const VesselInPlane& now, double t, double h, const SteeringOrders& present) override {
    const double turned = side_ * track_.turned(), time = track_.time();
    const double ahead = track_.ahead(), aside = side_ * track_.aside();
    track_.go_on(now, t, h);
    const double turned_now = side_ * track_.turned();
    // Values where the heading passes an angle are interpolated within this substep.
    const auto passes = [&](double angle, double reached) {
      return reached == k_not_reached && turned < angle && turned_now >= angle;
    };
    const auto at = [&](double angle, double from, double to) {
      return from + (angle - turned) / (turned_now - turned) * (to - from);
    };
    if (passes(0.5 * k_pi, quarter_time_)) {
      quarter_time_ = at(0.5 * k_pi, time, track_.time());
      advance_ = at(0.5 * k_pi, ahead, track_.ahead());
      transfer_ = at(0.5 * k_pi, aside, side_ * track_.aside());
    }
    if (passes(k_pi, half_time_)) {
      half_time_ = at(k_pi, time, track_.time());
      diameter_ = at(k_pi, aside, side_ * track_.aside());
    }
    speed_ = now.speed();
    rate_ = std::abs(now.motion.r);
    drift_ = side_ * now.drift();
    return {angle_, present.rps};
  }

  std::vector<bodies::RunFigure> figures() const override {
    std::vector<bodies::RunFigure> all;
    const double L = track_.length(), turned = side_ * track_.turned() / k_deg;
    all.push_back(
        {"heading_change_deg", turned, "change of heading",
         fmt::format("{:.4g} deg to {} in {:.4g} s", turned, side_ > 0 ? "starboard" : "port", track_.time())});
    if (quarter_time_ != k_not_reached) {
      all.push_back(
          {"advance_m", advance_, "advance",
           fmt::format("{} after {:.4g} s; IMO at most {} L", in_lengths(advance_, L), quarter_time_, k_imo_advance)});
      all.push_back({"transfer_m", transfer_, "transfer", in_lengths(transfer_, L)});
    }
    if (half_time_ != k_not_reached)
      all.push_back({"tactical_diameter_m", diameter_, "tactical diameter",
                     fmt::format("{} after {:.4g} s; IMO at most {} L", in_lengths(diameter_, L), half_time_,
                                 k_imo_tactical_diameter)});
    if (side_ * track_.turned() < 2 * k_pi || !(rate_ > 0)) return all;
    const double diameter = 2 * speed_ / rate_, ratio = speed_ / track_.approach_speed();
    all.push_back({"steady_diameter_m", diameter, "steady diameter", in_lengths(diameter, L)});
    all.push_back(
        {"steady_drift_deg", drift_ / k_deg, "steady drift angle", fmt::format("{:.4g} deg", drift_ / k_deg)});
    if (track_.approach_speed() > 0)
      all.push_back({"steady_speed_ratio_1", ratio, "speed in the turn",
                     fmt::format("{:.3f} of the approach speed of {:.4g} m/s", ratio, track_.approach_speed())});
    return all;
  }

  void save(StateWriter out) const override {
    track_.save(out);
    out.add("circle", std::array{advance_, transfer_, quarter_time_, diameter_, half_time_, speed_, rate_, drift_});
  }
  void restore(const StateReader& in) override {
    track_.restore(in);
    std::array<double, 8> all{};
    in.get("circle", all);
    advance_ = all[0];
    transfer_ = all[1];
    quarter_time_ = all[2];
    diameter_ = all[3];
    half_time_ = all[4];
    speed_ = all[5];
    rate_ = all[6];
    drift_ = all[7];
  }

 private:
  ManoeuvreTrack track_;
  double angle_;                                                     ///< [rad]
  double side_;                                                      ///< 1 to starboard, -1 to port
  double advance_ = 0, transfer_ = 0, diameter_ = 0;                 ///< where they were reached [m]
  double quarter_time_ = k_not_reached, half_time_ = k_not_reached;  ///< since the start [s]
  double speed_ = 0, rate_ = 0, drift_ = 0;                          ///< of the last substep [m/s, rad/s, rad]
};

}  // namespace

std::unique_ptr<Manoeuvre> make_straight(const ManoeuvreFrame& frame) { return std::make_unique<Straight>(frame); }

std::unique_ptr<Manoeuvre> make_turning_circle(const ManoeuvreFrame& frame, double angle) {
  return std::make_unique<TurningCircle>(frame, angle);
}

}  // namespace nilas::hydro
