#include "core/vessel/control/observer.h"

#include "core/vessel/thrusters/actuator.h"

namespace nilas::vessel {

namespace {

constexpr double k_wave_damping = 0.1;  // zeta of the wave model [Fossen, Strand 1999]
constexpr double k_notch = 1;           // damping of the notch, same source
constexpr double k_cut_off = 1.22;      // cut-off over the waves' frequency, same source

}  // namespace

Mat3 plane_rotation(double heading) {
  Mat3 R = Mat3::Identity();
  R.topLeftCorner<2, 2>() << std::cos(heading), -std::sin(heading), std::sin(heading), std::cos(heading);
  return R;
}

PassiveObserver::PassiveObserver(const ObserverSettings& settings, const Vec3& position, const Vec3& velocity)
    : settings_(settings), position_(position), velocity_(velocity) {}

PassiveObserver::Gains PassiveObserver::gains(int axis, double period) const {
  const double slow = std::exp(-settings_.bandwidth[axis] * period);
  const double wave = settings_.wave_period ? 2 * k_pi / *settings_.wave_period : 0;
  const double fast = settings_.wave_period ? std::exp(-k_cut_off * wave * period) : slow;
  // The error after a sample, z^3 - p1 z^2 + p2 z - p3 with these sums of products of the poles.
  const double p1 = fast + 2 * slow, p2 = 2 * fast * slow + slow * slow, p3 = fast * slow * slow;
  constexpr double k_three = 3;
  Gains gains{};
  gains.position = 1 - p3;
  gains.velocity = 0.5 * (k_three + k_three * p3 - p1 - p2) / period;
  gains.bias = (1 - p3 - p1 + p2) / (period * period);
  if (settings_.wave_period) {
    gains.wave = -2 * (k_notch - k_wave_damping) * k_cut_off * period;
    gains.wave_rate = 2 * wave * (k_notch - k_wave_damping) * period;
  }
  return gains;
}

Eigen::Matrix2d PassiveObserver::wave_transition(double h) const {
  const double w = 2 * k_pi / *settings_.wave_period, decay = k_wave_damping * w;
  const double turn = w * std::sqrt(1 - k_wave_damping * k_wave_damping);
  const double c = std::cos(turn * h), s = std::sin(turn * h) / turn;
  Eigen::Matrix2d m;
  m << c + decay * s, s, -w * w * s, c - decay * s;
  return std::exp(-decay * h) * m;
}

double PassiveObserver::spectral_radius(double period) const {
  double radius = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Gains g = gains(axis, period);
    Eigen::Matrix<double, 5, 5> forward = Eigen::Matrix<double, 5, 5>::Zero();
    forward.topLeftCorner<3, 3>() << 1, period, 0.5 * period * period, 0, 1, period, 0, 0, 1;
    if (settings_.wave_period) forward.bottomRightCorner<2, 2>() = wave_transition(period);
    Eigen::Matrix<double, 5, 1> gain;
    gain << g.position, g.velocity, g.bias, g.wave, g.wave_rate;
    Eigen::Matrix<double, 1, 5> seen;
    seen << 1, 0, 0, 0, settings_.wave_period ? 1 : 0;
    const Eigen::Matrix<double, 5, 5> error = forward - gain * seen * forward;
    radius = std::max(radius, error.eigenvalues().cwiseAbs().maxCoeff());
  }
  return radius;
}

void PassiveObserver::predict(const Vec3& load, double h) {
  const Vec3 pull = (load + plane_rotation(position_.z()).transpose() * bias_).cwiseQuotient(settings_.mass);
  // The damping acts by the velocity at the end, so that any step is stable.
  const Vec3 next =
      (velocity_ + h * pull).cwiseQuotient(Vec3(Vec3::Ones() + h * settings_.damping.cwiseQuotient(settings_.mass)));
  const Vec3 mean = 0.5 * (velocity_ + next);
  position_ += h * (plane_rotation(position_.z() + 0.5 * h * mean.z()) * mean);
  velocity_ = next;
  if (!settings_.wave_period) return;
  const Eigen::Matrix2d m = wave_transition(h);
  const Vec3 wave = m(0, 0) * wave_ + m(0, 1) * wave_rate_;
  wave_rate_ = m(1, 0) * wave_ + m(1, 1) * wave_rate_;
  wave_ = wave;
}

void PassiveObserver::correct(const Vec3& measured, double period) {
  Vec3 innovation = measured - position_ - wave_rate_;
  innovation.z() = wrapped(innovation.z());
  const Mat3 R = plane_rotation(position_.z());
  const Vec3 own = R.transpose() * innovation;
  Vec3 step, force;
  for (int k = 0; k < 3; ++k) {
    const Gains g = gains(k, period);
    step[k] = g.position * own[k];
    velocity_[k] += g.velocity * own[k];
    force[k] = settings_.mass[k] * g.bias * own[k];
    wave_[k] += g.wave * innovation[k];
    wave_rate_[k] += g.wave_rate * innovation[k];
  }
  position_ += R * step;
  bias_ += R * force;
}

void PassiveObserver::save(StateWriter out) const {
  out.add("position", position_);
  out.add("velocity", velocity_);
  out.add("bias", bias_);
  out.add("wave", wave_);
  out.add("wave_rate", wave_rate_);
}

void PassiveObserver::restore(const StateReader& in) {
  in.get("position", position_);
  in.get("velocity", velocity_);
  in.get("bias", bias_);
  in.get("wave", wave_);
  in.get("wave_rate", wave_rate_);
}

}  // namespace nilas::vessel
