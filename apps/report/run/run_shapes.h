#pragma once
/// The shapes of a run's vessel and fixed bodies.
#include <cstdint>
#include <string>
#include <vector>

#include "apps/report/run/run_data.h"
#include "core/geometry/mesh.h"
#include "core/sim/account/step_record.h"

namespace nilas::report {

struct RunBody {
  std::vector<std::int64_t> ids;  ///< of the body; of a vessel those of its hull and its parts
  std::string name;
  bool is_vessel = false;
  geometry::TriangleMesh mesh;  ///< in V of a vessel, else in G [m]
};

struct RunShapes {
  std::vector<RunBody> bodies;       ///< the vessel first
  std::vector<std::int64_t> others;  ///< ids of walls and of the scene's bodies, which come after those of floes
  bool with_ice = false;             ///< whether the ids of `others` count the floes
  sim::RunInfo info;                 ///< without ice where the ice was left out
  const RunBody* find(const std::string& name, bool is_vessel) const;
};

/// Builds the scene of a run again. The ice of a scene with a vessel is left out, since packing it takes long, unless
/// `with_ice`: identities of fixed bodies then are those of the run. Throws InputError, FileError or SceneError where
/// the scene cannot be built, as where its input files are missing.
RunShapes run_shapes(const scene::Scene& scene, bool with_ice);

/// The pose of the vessel's frame V in G in the row of vessel.csv nearest to t [s].
Pose vessel_pose(const RunTable& vessel, double t, const Vec3& com_V);

}  // namespace nilas::report
