#pragma once
/// A scene as plain values: what the XML said, with every default filled in. What is not named is an empty optional or
/// list. The members' own values are the scene file's defaults, which the schema (schema.h) prints.
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

namespace nilas {

struct TimeScene {
  double step = 0.01;  ///< [s]
  double start = 0;    ///< [s]
  double end = 10;     ///< [s]

  bool operator==(const TimeScene&) const = default;
};

/// An input file that the scene refers to.
struct InputFile {
  std::string source;  ///< absolute path
  std::string copy;    ///< what the scene as run calls it, relative to the run folder: inputs/ship/fluid.stl
  std::string sha256;  ///< in hexadecimal digits
};

struct Scene {
  std::string name = "scene";
  std::filesystem::path file;  ///< where it was read from
  TimeScene time;
  Vec3 gravity{0, 0, -defaults::k_gravity};
  std::uint64_t seed = 1;
  std::uint64_t twin = 0;  ///< 0: the scene itself; others start next to nothing aside
  ContactScene contact;
  std::optional<WaterScene> water;
  std::optional<HydroScene> hydro;
  std::optional<TankScene> tank;
  std::optional<VesselScene> vessel;
  std::optional<IceScene> ice;
  std::optional<FractureScene> fracture;
  std::vector<BodyScene> bodies;
  OutputScene output;
  std::vector<std::string> notes;  ///< what the reader wants said once, e.g. a default that fell back to a built model
  std::vector<std::string> derived;  ///< defaults that follow from the scene's scale, and why
  std::vector<Fault> warnings;       ///< valid values that can hardly be meant, with their places
  /// Where the first element of each path and its given attributes stand: "vessel/carriage", "vessel/carriage/@speed".
  /// A place is a fault without a message.
  std::map<std::string, Fault> places;
  std::vector<InputFile> inputs;  ///< in the order of the scene, each once
  std::string as_run;             ///< the XML with every default and override written out, and input files by `copy`
  std::string fingerprint;  ///< SHA-256 of it but for time/@end and what of <output> only concerns checkpoints and
                            ///< statistics: what a run's states depend on
};

/// A warning that is placed at `path` ("vessel/carriage/@speed"), or where that is not given at the nearest element
/// above it.
Fault warning_at(const Scene& scene, const std::string& path, const std::string& message);

}  // namespace nilas
