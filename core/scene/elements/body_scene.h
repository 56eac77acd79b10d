#pragma once
/// Values of <body>, and what a <part> shares with it.
#include <optional>
#include <string>

#include "core/base/math.h"
#include "core/choices/body_choices.h"

namespace nilas {

/// The shape and mass of a <body> or of a <part> of the vessel.
struct SolidScene {
  static constexpr double k_density = 1000;  ///< where neither mass nor density is given [kg/m^3]

  std::string name;
  SolidShapeKind shape = SolidShapeKind::box;
  Vec3 size = Vec3::Ones();
  double radius = 0.5, height = 1;
  std::string mesh;  ///< absolute path
  std::optional<double> mass, density;
  std::optional<Vec3> cog;      ///< of a part: centre of mass in its own frame [m]
  std::optional<Vec6> inertia;  ///< xx yy zz xy xz yz [kg m^2]
  Vec3 position = Vec3::Zero();
  Vec3 rotation_deg = Vec3::Zero();  ///< yaw pitch roll
  std::string material = "structure";
  int line = 0;

  bool operator==(const SolidScene&) const = default;
};

struct BodyScene : SolidScene {
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  bool fixed = false;

  bool operator==(const BodyScene&) const = default;
};

}  // namespace nilas
