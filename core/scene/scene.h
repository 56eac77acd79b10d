#pragma once
/// A scene as plain values: the content of the XML with every default filled in. Anything not named is an empty
/// optional or list. The members' initial values are the scene file's defaults, which the schema (schema.h) prints.
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/choices/defaults.h"
#include "core/scene/elements/body_scene.h"
#include "core/scene/elements/contact_scene.h"
#include "core/scene/elements/fracture_scene.h"
#include "core/scene/elements/ice_scene.h"
#include "core/scene/elements/output_scene.h"
#include "core/scene/elements/vessel_scene.h"
#include "core/scene/elements/water_scene.h"
#include "core/scene/elements/wind_scene.h"

namespace nilas::scene {

struct TimeScene {
  double step = 0.01;  ///< [s]
  double start = 0;    ///< [s]
  double end = 10;     ///< [s]

  bool operator==(const TimeScene&) const = default;
};

/// An input file that the scene refers to.
struct InputFile {
  std::string source;  ///< absolute path
  std::string copy;    ///< name in the scene as run, relative to the run folder: inputs/ship/fluid.stl
  std::string sha256;  ///< SHA-256 in hexadecimal digits
};

struct Scene {
  std::string name = "scene";
  double scale = 1;            ///< factor of lengths for files, and for constants of the program: --scale
  std::filesystem::path file;  ///< file that it was read from
  TimeScene time;
  Vec3 gravity{0, 0, -defaults::k_gravity};
  std::uint64_t seed = 1;
  std::uint64_t twin = 0;  ///< 0: the scene itself; else a perturbed run, bodies up to 1e-12 m away
  ContactScene contact;
  std::optional<WaterScene> water;
  std::optional<HydroScene> hydro;
  std::optional<WindScene> wind;
  std::optional<TankScene> tank;
  std::optional<VesselScene> vessel;
  std::optional<IceScene> ice;
  std::optional<FractureScene> fracture;
  std::vector<BodyScene> bodies;
  OutputScene output;
  std::optional<ViewScene> view;
  std::vector<std::string> notes;    ///< notes to print once, such as a replaced default
  std::vector<std::string> derived;  ///< defaults that follow from the scene's scale, and why
  std::vector<Fault> warnings;       ///< valid but implausible values, with their places
  /// Places of the first element of each path and of its given attributes: "vessel/carriage", "vessel/carriage/@speed".
  /// A place is a fault without a message.
  std::map<std::string, Fault> places;
  std::vector<InputFile> inputs;  ///< input files in the order of the scene, each once
  std::string as_run;             ///< the XML with every default and override written out, and input files by `copy`
  std::string fingerprint;  ///< SHA-256 of as_run without time/@end and the settings of <output> for checkpoints and
                            ///< statistics: identifies everything that a run's states depend on
};

/// A warning placed at `path` ("vessel/carriage/@speed") or, where that is not given, at the nearest element above it.
Fault warning_at(const Scene& scene, const std::string& path, const std::string& message);

}  // namespace nilas::scene
