#pragma once
/// All waves of a scene: surface, pressure and motion of the water in linear theory.
#include <cstdint>
#include <vector>

#include "hydro/flow/flow.h"
#include "hydro/waves/wave_train.h"

namespace nilas::hydro {

/// The sum of all waves. For one wave with t_ = w t - k x . d + phase (Newman, Marine Hydrodynamics, 1977, 6.2):
///   elevation        a cos t_
///   pressure head    a cos t_ cosh k(z + h) / cosh kh   dynamic pressure over rho g
///   velocity along d a w cos t_ cosh k(z + h) / sinh kh
///   velocity upwards -a w sin t_ sinh k(z + h) / sinh kh
/// z is the height above still water. Wheeler's stretching (1970) takes these profiles from the actual surface
/// downwards: z is replaced by (z - elevation) / (1 + elevation / h). So the whole pressure is zero at the surface.
/// Above the surface the values at the surface hold. Under ice, amplitudes fall as IceCover says; the water's motion
/// is then only nearly free of divergence. In the ramp of a train its amplitude rises by (1 - cos(pi t / ramp)) / 2.
class WaveField : public Flow {
 public:
  /// `level`: z of still water in G [m]; `start`: time at which ramps begin [s]. Throws InputError for trains that
  /// contradict themselves.
  WaveField(std::vector<WaveTrain> trains, double gravity, double level, double start, std::uint64_t seed);

  const std::vector<WaveComponent>& components() const { return components_; }
  const std::vector<WaveTrain>& trains() const { return trains_; }
  double level() const { return level_; }
  double gravity() const { return gravity_; }
  /// The share of its amplitude that a train has at time t.
  double ramp(std::size_t train, double t) const;
  /// No surface is higher above, or deeper below, still water than this [m].
  double greatest_elevation() const { return greatest_; }
  /// The length of the shortest wave [m]; infinite where there is none.
  double shortest_length() const;

  /// Height of the surface above still water at a horizontal position [m].
  double elevation(const Vec2& x, double t) const;
  Vec3 velocity(const Vec3& p_G, double t) const override;

 private:
  std::vector<WaveTrain> trains_;
  double gravity_, level_, start_;
  double greatest_ = 0;
  std::vector<WaveComponent> components_;
};

/// a cos t_ and a sin t_ of one component at one place and time, with ramp and attenuation [m].
struct WavePhasor {
  double cos = 0, sin = 0;
};

/// The waves over one horizontal position at one time.
class WaveColumn {
 public:
  WaveColumn(const WaveField& field, const Vec2& x, double t);
  const std::vector<WavePhasor>& phasors() const { return phasors_; }
  double elevation() const { return elevation_; }
  /// The dynamic pressure over rho g at the height z above still water [m].
  double pressure_head(double z) const;
  /// At the height z above still water, frame G [m/s].
  Vec3 velocity(double z) const;
  /// Of the water at rest otherwise, without the convective part [m/s^2].
  Vec3 acceleration(double z) const;
  /// Angular acceleration of a small horizontal element of the water: (d a_z/dy, -d a_z/dx, 0) [1/s^2].
  Vec3 tilt_acceleration(double z) const;

 private:
  /// cosh k(z + h) / cosh kh, the same over sinh kh, and sinh k(z + h) / sinh kh.
  struct Profile {
    double pressure, along, up;
  };
  Profile profile(const WaveComponent& wave, double z) const;

  const WaveField* field_;
  std::vector<WavePhasor> phasors_;
  double elevation_ = 0;
};

}  // namespace nilas::hydro
