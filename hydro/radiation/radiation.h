#pragma once
/// The module of radiation: the load of the waves that the vessel's own motion has made.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/module.h"
#include "core/choices/radiation_choices.h"
#include "hydro/database/database.h"

namespace nilas::hydro {

struct RadiationSettings {
  RadiationModel model = RadiationModel::state_space;
  double error = 0.01;                      ///< root-mean-square error of the state space, as a share
  std::optional<int> order;                 ///< poles of each group of coupled modes; default: the fewest for the error
  std::optional<double> memory;             ///< of the convolution [s]
  std::optional<double> highest_frequency;  ///< damping above it is not used [rad/s]
};

/// The body that radiates and the database's frame D on it.
struct RadiatingBody {
  int body = 0;                          ///< index of the hull
  Vec3 origin_B = Vec3::Zero();          ///< origin of D from the centre of mass, body axes [m]
  double rotation = 0;                   ///< of the axes of D about the vertical, from x of the body towards y [rad]
  Mat6 mass_B = Mat6::Zero();            ///< mass about the centre of mass, without added mass, body axes
  Vec3 velocity = Vec3::Zero();          ///< of the centre of mass at the start, in G [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< at the start, in G [rad/s]
  Mat3 attitude = Mat3::Identity();      ///< of the body at the start, from its axes to those of G
  Vec3 current = Vec3::Zero();           ///< [m/s]
  double start = 0, step = 0;            ///< time of the start and length of a step [s]
};

struct BuiltRadiation {
  std::unique_ptr<bodies::ForceModule> module;
  std::string description;         ///< model, order, error, passivity or memory, and agreement with the added mass
  std::vector<std::string> notes;  ///< whole sentences on what was repaired in the database, or is doubtful
};

/// F(t) = -int_0^inf K(s) V(t - s) ds [Cummins 1962], the part of radiation beside the added mass at infinite
/// frequency.
/// - V are surge, sway, heave, roll, pitch and yaw velocities of the hull at the origin of D, relative to the uniform
///   current, in axes that turn with the vessel's yaw. Roll and pitch are taken as small: axes stay upright.
/// - Past velocities are kept in the axes of their own time, so the memory turns with the vessel.
/// - Before the start the motion was steady, with the velocities of the start in all six modes. Steady motion makes
///   no load: the database is that of a body without forward speed, and no effect of speed is added.
/// The load is explicit. A step h with h^2 K(0) > (M + A_inf), in any mode, is refused with the longest step.
/// The power of the load relative to the current is F . V exactly. Throws InputError for a database, a fit or a step
/// that cannot be used.
BuiltRadiation make_radiation(const Database& database, const RadiationSettings& settings, const RadiatingBody& body);

}  // namespace nilas::hydro
