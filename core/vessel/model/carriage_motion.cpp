#include <algorithm>
#include <cmath>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

/// Natural cubic spline through (x, y, yaw), relative to the first row. The spline of SimTK (SplineFitter with
/// smoothing 0) agrees within 1e-11 m, but is not used. It needs at least four rows where a straight path has two,
/// misses 20000 uneven rows by up to 6e-11 m, and takes 12 to 19 times as long (tests/bench/library_twins.cpp).
struct CarriageMotion::Knots {
  std::vector<double> t;
  std::vector<Vec3> value;
  std::vector<Vec3> second;  ///< second derivatives at the knots

  /// Second derivatives from the tridiagonal system of continuous slopes, zero at both ends.
  void fit();
  struct Curve {
    Vec3 value, rate, bend;  ///< value, first and second derivative
  };
  /// The cubic between the two knots around `within`, an instant of the path, evaluated at `time`.
  Curve at(double time, double within) const;
};

void CarriageMotion::Knots::fit() {
  const std::size_t n = t.size();
  second.assign(n, Vec3::Zero());
  std::vector<double> pivot(n, 1);
  const auto slope = [&](std::size_t i) -> Vec3 { return (value[i + 1] - value[i]) / (t[i + 1] - t[i]); };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = t[i] - t[i - 1];
    const double elimination = i > 1 ? before / pivot[i - 1] : 0;
    pivot[i] = 2 * (t[i + 1] - t[i - 1]) - elimination * before;
    constexpr double k_weight = 6;  // factor of the slope change in the spline's continuity condition
    second[i] = k_weight * (slope(i) - slope(i - 1)) - elimination * second[i - 1];
  }
  for (std::size_t i = n - 2; i > 0; --i) second[i] = (second[i] - (t[i + 1] - t[i]) * second[i + 1]) / pivot[i];
}

CarriageMotion::Knots::Curve CarriageMotion::Knots::at(double time, double within) const {
  const auto above = std::upper_bound(t.begin() + 1, t.end() - 1, within);
  const auto i = static_cast<std::size_t>(above - t.begin()) - 1;
  const double span = t[i + 1] - t[i];
  const double b = (time - t[i]) / span, a = 1 - b;
  constexpr double k_sixth = 1.0 / 6.0;
  const double bend = k_sixth * span * span;
  const Vec3 p =
      a * value[i] + b * value[i + 1] + bend * ((a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1]);
  const Vec3 v = (value[i + 1] - value[i]) / span +
                 k_sixth * span * ((1 - 3 * a * a) * second[i] + (3 * b * b - 1) * second[i + 1]);
  return {p, v, a * second[i] + b * second[i + 1]};
}

CarriageMotion CarriageMotion::straight(const Vec3& start, double yaw, double speed, double direction, double ramp,
                                        double t0, RampShape shape) {
  NILAS_DEMAND(ramp >= 0);
  CarriageMotion motion;
  motion.start_ = start;
  motion.yaw_ = yaw;
  motion.speed_ = speed;
  motion.direction_ = direction;
  motion.ramp_ = ramp;
  motion.t0_ = t0;
  motion.shape_ = shape;
  return motion;
}

CarriageMotion CarriageMotion::path(const Vec3& start, double yaw, const std::string& csv_file, double scale) {
  const CsvTable table = read_csv(csv_file, {"t_s", "x_m", "y_m", "yaw_deg"});
  if (table.rows.size() < 2) throw InputError(csv_file + ": a path needs at least 2 rows");
  auto knots = std::make_shared<Knots>();
  const double in_time = std::sqrt(scale);
  const auto& first = table.rows.front();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    const double t = in_time * row[0];
    if (i > 0 && !(t > knots->t.back()))
      throw InputError(csv_file + ":" + std::to_string(table.lines[i]) + ": t_s must grow from row to row");
    knots->t.push_back(t);
    knots->value.emplace_back(scale * (row[1] - first[1]), scale * (row[2] - first[2]), (row[3] - first[3]) * k_deg);
  }
  knots->fit();
  CarriageMotion motion;
  motion.start_ = start;
  motion.yaw_ = yaw;
  motion.knots_ = std::move(knots);
  return motion;
}

std::array<double, 2> CarriageMotion::path_span() const {
  NILAS_DEMAND(knots_ != nullptr);
  return {knots_->t.front(), knots_->t.back()};
}

std::vector<double> CarriageMotion::kinks() const {
  if (knots_) return knots_->t;
  if (speed_ == 0) return {};
  return ramp_ > 0 ? std::vector<double>{t0_, t0_ + ramp_} : std::vector<double>{t0_};
}

CarriageMotion::Moment CarriageMotion::moment(double t, double within) const {
  Moment moment{{start_, yaw_, Vec3::Zero(), 0}, {}};
  State& state = moment.now;
  if (knots_) {
    const double first = knots_->t.front(), last = knots_->t.back();
    const bool rests = within < first || within > last;
    const double held = std::clamp(within, first, last);
    const Knots::Curve curve = knots_->at(rests ? held : t, held);
    state.p += Vec3(curve.value.x(), curve.value.y(), 0);
    state.yaw += curve.value.z();
    if (rests) return moment;
    state.v = {curve.rate.x(), curve.rate.y(), 0};
    state.yaw_rate = curve.rate.z();
    moment.acceleration.v = {curve.bend.x(), curve.bend.y(), 0};
    moment.acceleration.yaw_rate = curve.bend.z();
    return moment;
  }
  const double run = t - t0_;
  if (within - t0_ < 0) return moment;
  const Vec3 along(std::cos(direction_), std::sin(direction_), 0);
  const bool ramping = within - t0_ < ramp_;
  if (ramping && shape_ == RampShape::smooth) {
    const double s = run / ramp_;
    constexpr double k_slope = 6;  // factor in the derivative of s^2 (3 - 2 s), which is 6 s (1 - s)
    state.p += speed_ * ramp_ * s * s * s * (1 - 0.5 * s) * along;
    state.v = speed_ * s * s * (3 - 2 * s) * along;
    moment.acceleration.v = k_slope * speed_ / ramp_ * s * (1 - s) * along;
    return moment;
  }
  state.p += (ramping ? 0.5 * speed_ * run * run / ramp_ : speed_ * (run - 0.5 * ramp_)) * along;
  state.v = (ramping ? speed_ * run / ramp_ : speed_) * along;
  if (ramping) moment.acceleration.v = speed_ / ramp_ * along;
  return moment;
}

}  // namespace nilas::vessel
