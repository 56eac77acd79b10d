#pragma once
/// Values of <vessel>.
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/vessel_choices.h"
#include "core/scene/elements/body_scene.h"
#include "core/scene/elements/manoeuvring_scene.h"
#include "core/scene/elements/mooring_scene.h"
#include "core/scene/elements/remote_scene.h"
#include "core/scene/elements/thruster_scene.h"
#include "core/scene/elements/wind_scene.h"

namespace nilas::scene {

struct MassScene {
  std::optional<double> value;    ///< [kg]
  std::optional<Vec3> cog;        ///< frame V [m]
  std::optional<Vec6> inertia;    ///< inertia about the centre of mass in V: xx yy zz xy xz yz [kg m^2]
  std::optional<double> draught;  ///< mass from the displaced volume [m]

  bool operator==(const MassScene&) const = default;
};
struct ForceBalanceScene {
  BalanceKind kind = BalanceKind::rigid;
  double stiffness = 1e7, damping = 1e4;
  std::string layout;  ///< absolute path, or empty

  bool operator==(const ForceBalanceScene&) const = default;
};
struct CarriageScene {
  double speed = 0, ramp = 0;
  RampShape ramp_shape = RampShape::linear;
  double heading_deg = 0;      ///< direction of motion in G
  std::optional<Vec3> joint;   ///< frame V [m]; default: the centre of mass
  std::array<bool, 6> free{};  ///< one entry per JointAxis
  CarriageStart start = CarriageStart::equilibrium;
  std::string path;  ///< absolute path, or empty
  ForceBalanceScene balance;

  bool operator==(const CarriageScene&) const = default;
};
/// <hull generate=...>: parameters of the generated form; unnamed ones keep the generator's defaults.
struct HullGenerateScene {
  HullKind kind = HullKind::icebreaker;
  std::map<std::string, double> parameters;  ///< value by XML name: length, beam, stem_angle_deg, triangles ...

  bool operator==(const HullGenerateScene&) const = default;
};

/// Default material of hull and parts.
constexpr const char* k_hull_material = "hull";

/// A part of the vessel. Its position and rotation are in V at zero joint coordinates.
struct PartScene : SolidScene {
  PartScene() { material = k_hull_material; }

  JointKind joint = JointKind::hinge;
  std::string to;          ///< name of another part or of the vessel; empty: the hull
  std::optional<Vec3> at;  ///< joint point in V [m]; default: the position
  Vec3 axis = Vec3::UnitZ();
  double stiffness = 0, damping = 0;
  double rest_angle_deg = 0, angle_deg = 0, rate_deg = 0;  ///< angles and rate of a hinge
  double rest_travel = 0, travel = 0, speed = 0;           ///< travel and speed of a slider [m, m/s]

  bool operator==(const PartScene&) const = default;
};
/// A rod from the vessel to a fixed point.
struct RodScene {
  std::string name;
  std::string on;                ///< name of a part or of the vessel; empty: the hull
  Vec3 at = Vec3::Zero();        ///< frame V, for a part at zero joint coordinates [m]
  Vec3 to = Vec3::Zero();        ///< frame G [m]
  std::optional<double> length;  ///< [m]; default: as placed
  int line = 0;

  bool operator==(const RodScene&) const = default;
};
struct VesselScene {
  std::string name = "ship";
  std::string hull;  ///< absolute path, or empty when generated
  std::optional<HullGenerateScene> generate;
  Vec3 position = Vec3::Zero();  ///< position of the origin of V
  bool position_has_z = true;    ///< two numbers given: z from floating equilibrium
  double heading_deg = 0;
  Vec3 velocity = Vec3::Zero();          ///< free vessel, in G [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< free vessel, in G [rad/s]
  MassScene mass;
  bool fixed = false;
  std::optional<CarriageScene> carriage;
  std::vector<PartScene> parts;
  std::vector<RodScene> rods;
  std::vector<ThrusterScene> thrusters;
  std::optional<ControlScene> control;
  std::optional<WindAreaScene> wind_area;
  std::optional<ManoeuvringScene> manoeuvring;
  std::optional<ManoeuvreScene> manoeuvre;
  std::optional<MooringScene> mooring;
  std::optional<RemoteControlScene> remote_control;

  bool operator==(const VesselScene&) const = default;
};

}  // namespace nilas::scene
