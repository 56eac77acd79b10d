#pragma once
/// Values of <body>, and what a <part> shares with it.
#include <optional>
#include <string>
#include <variant>

#include "core/base/math.h"
#include "core/choices/body_choices.h"
#include "core/choices/variant_kind.h"

namespace nilas::scene {

struct BoxScene {
  Vec3 size = Vec3::Ones();  ///< edge lengths [m]

  bool operator==(const BoxScene&) const = default;
};
struct SphereScene {
  double radius = 0.5;  ///< [m]

  bool operator==(const SphereScene&) const = default;
};
struct CylinderScene {
  double radius = 0.5, height = 1;  ///< [m]

  bool operator==(const CylinderScene&) const = default;
};
struct MeshScene {
  std::string file;         ///< absolute path of a hull folder or an STL file
  std::optional<Vec3> cog;  ///< centre of mass of a part in its own frame [m]

  bool operator==(const MeshScene&) const = default;
};
struct PlaneScene {
  bool operator==(const PlaneScene&) const = default;
};
/// The shapes, in the order of SolidShapeKind.
using SolidShape = std::variant<BoxScene, SphereScene, CylinderScene, MeshScene, PlaneScene>;

/// The shape and mass of a <body> or of a <part> of the vessel.
struct SolidScene {
  static constexpr double k_density = 1000;  ///< where neither mass nor density is given [kg/m^3]

  std::string name;
  SolidShape shape;
  std::optional<double> mass, density;  ///< [kg], [kg/m^3]; not both
  std::optional<Vec6> inertia;          ///< xx yy zz xy xz yz [kg m^2]
  Vec3 position = Vec3::Zero();         ///< [m]
  Vec3 rotation_deg = Vec3::Zero();     ///< yaw pitch roll
  std::string material = "structure";
  int line = 0;

  SolidShapeKind kind() const { return kind_of<SolidShapeKind>(shape); }
  bool operator==(const SolidScene&) const = default;
};

struct BodyScene : SolidScene {
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();  ///< [m/s], [rad/s]
  bool fixed = false;

  bool operator==(const BodyScene&) const = default;
};

}  // namespace nilas::scene
