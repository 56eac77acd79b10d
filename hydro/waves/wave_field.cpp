#include "hydro/waves/wave_field.h"

#include <algorithm>
#include <cmath>

namespace nilas::hydro {

WaveField::WaveField(std::vector<WaveTrain> trains, double gravity, double level, double start, std::uint64_t seed)
    : trains_(std::move(trains)), gravity_(gravity), level_(level), start_(start) {
  for (std::size_t i = 0; i < trains_.size(); ++i)
    for (WaveComponent& wave : waves_of(trains_[i], gravity, seed, "waves " + std::to_string(i))) {
      wave.train = i;
      greatest_ += wave.amplitude;
      components_.push_back(wave);
    }
}

double WaveField::ramp(std::size_t train, double t) const {
  const double share = (t - start_) / trains_[train].ramp;  // infinite or not a number without a ramp
  return share < 1 && trains_[train].ramp > 0 ? 0.5 * (1 - std::cos(k_pi * std::max(share, 0.0))) : 1;
}

double WaveField::shortest_length() const {
  double number = 0;
  for (const WaveComponent& wave : components_) number = std::max(number, wave.number);
  return 2 * k_pi / number;
}

double WaveField::elevation(const Vec2& x, double t) const { return WaveColumn(*this, x, t).elevation(); }

Vec3 WaveField::velocity(const Vec3& p_G, double t) const {
  return WaveColumn(*this, p_G.head<2>(), t).velocity(p_G.z() - level_);
}

WaveColumn::WaveColumn(const WaveField& field, const Vec2& x, double t) : field_(&field) {
  const auto& trains = field.trains();
  phasors_.reserve(field.components().size());
  std::size_t train = trains.size();
  double ramp = 0, behind = 0;
  for (const WaveComponent& wave : field.components()) {
    if (wave.train != train) {
      train = wave.train;
      ramp = field.ramp(train, t);
      behind = trains[train].ice.distance(x);
    }
    const double covered = wave.decay * behind;
    const double amplitude = ramp * wave.amplitude * (covered > 0 ? std::exp(-covered) : 1);
    const double angle = wave.frequency * t - wave.number * x.dot(wave.direction) + wave.phase;
    phasors_.push_back({amplitude * std::cos(angle), amplitude * std::sin(angle)});
    elevation_ += phasors_.back().cos;
  }
}

WaveColumn::Profile WaveColumn::profile(const WaveComponent& wave, double z) const {
  const double depth = field_->trains()[wave.train].depth;
  const double below = std::clamp((z - elevation_) / (1 + elevation_ / depth), -depth, 0.0);
  const double falling = std::exp(wave.number * below);
  if (depth == k_deep_water) return {falling, falling, falling};
  // Exponentials that do not overflow: cosh k(z + h) / cosh kh = (e^(kz) + e^(-k(z + 2h))) / (1 + e^(-2kh)).
  const double from_floor = std::exp(-wave.number * (below + 2 * depth));
  const double twice = std::exp(-2 * wave.number * depth);
  return {(falling + from_floor) / (1 + twice), (falling + from_floor) / (1 - twice),
          (falling - from_floor) / (1 - twice)};
}

double WaveColumn::pressure_head(double z) const {
  double head = 0;
  for (std::size_t i = 0; i < phasors_.size(); ++i)
    head += phasors_[i].cos * profile(field_->components()[i], z).pressure;
  return head;
}

Vec3 WaveColumn::velocity(double z) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < phasors_.size(); ++i) {
    const WaveComponent& wave = field_->components()[i];
    const Profile at = profile(wave, z);
    sum.head<2>() += wave.frequency * phasors_[i].cos * at.along * wave.direction;
    sum.z() -= wave.frequency * phasors_[i].sin * at.up;
  }
  return sum;
}

Vec3 WaveColumn::acceleration(double z) const {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < phasors_.size(); ++i) {
    const WaveComponent& wave = field_->components()[i];
    const Profile at = profile(wave, z);
    const double square = wave.frequency * wave.frequency;
    sum.head<2>() -= square * phasors_[i].sin * at.along * wave.direction;
    sum.z() -= square * phasors_[i].cos * at.up;
  }
  return sum;
}

Vec3 WaveColumn::tilt_acceleration(double z) const {
  Vec2 slope = Vec2::Zero();  // gradient of the vertical acceleration
  for (std::size_t i = 0; i < phasors_.size(); ++i) {
    const WaveComponent& wave = field_->components()[i];
    slope -= wave.frequency * wave.frequency * wave.number * phasors_[i].sin * profile(wave, z).up * wave.direction;
  }
  return {slope.y(), -slope.x(), 0};
}

}  // namespace nilas::hydro
