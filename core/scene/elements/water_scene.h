#pragma once
/// Values of <water>, <hydro> and <tank>.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/choices/defaults.h"
#include "core/scene/elements/added_mass_scene.h"
#include "core/scene/elements/database_scene.h"
#include "core/scene/elements/radiation_scene.h"
#include "core/scene/elements/wave_scene.h"
#include "core/scene/elements/wind_scene.h"

namespace nilas::scene {

struct CurrentScene {
  Vec3 velocity = Vec3::Zero();
  std::string profile, series;  ///< absolute paths, or empty

  bool operator==(const CurrentScene&) const = default;
};
struct WaterScene {
  double density = defaults::k_water_density, level = 0;
  std::optional<CurrentScene> current;
  std::vector<WaveScene> waves;

  bool operator==(const WaterScene&) const = default;
};

struct DragScene {
  double form = defaults::k_form_drag, skin = defaults::k_skin_friction;

  bool operator==(const DragScene&) const = default;
};
struct VirtualDragScene {
  double coefficient = 0.1;
  Vec3 velocity = Vec3::Zero();

  bool operator==(const VirtualDragScene&) const = default;
};
struct HydroScene {
  bool buoyancy = false;
  std::optional<DragScene> drag;
  std::optional<VirtualDragScene> virtual_drag;
  std::optional<AddedMassScene> added_mass;
  std::optional<WaveLoadsScene> wave_loads;
  std::optional<DatabaseScene> database;
  std::optional<RadiationScene> radiation;
  bool restoring = false;      ///< linear hydrostatics of the vessel from the database
  std::vector<JetScene> jets;  ///< of <propeller_wash>

  bool operator==(const HydroScene&) const = default;
};

struct TankScene {
  double length = 10, width = 5, depth = 2, wall_thickness = 0.2;
  bool floor = true;

  bool operator==(const TankScene&) const = default;
};

}  // namespace nilas::scene
