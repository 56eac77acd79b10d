#include "core/sim/build/vessel_doubts.h"

#include <filesystem>

#include "core/base/file_bytes.h"
#include "core/geometry/mesh_box.h"
#include "core/hull/hull_doubts.h"
#include "hydro/wetted.h"

namespace nilas::sim {

/// The file name to give to `nilas hull`: the mesh of a hull folder, or the file itself.
static std::string mesh_file(const std::filesystem::path& hull) {
  return (is_folder(hull) ? hull.filename() / "fluid.stl" : hull.filename()).string();
}

std::vector<std::string> vessel_doubts(const scene::Scene& scene, const WorldParts& parts) {
  if (!scene.vessel) return {};
  const scene::VesselScene& vessel = *scene.vessel;
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  const geometry::TriangleMesh& surface = parts.bodies.shape[b]->surface;
  hull::HullUse use;
  use.generated = vessel.generate.has_value();
  use.fixed = vessel.fixed;
  if (!use.generated) use.file = mesh_file(vessel.hull);
  if (parts.water && scene.hydro && scene.hydro->buoyancy) {
    const Vec3& p = parts.bodies.p_GB[b];
    const double draught = parts.water->level - (p.z() + geometry::box_of(surface).min().z());
    if (draught > 0 && !vessel.position_has_z) use.draught = draught;
    if (!vessel.fixed && vessel.mass.value && vessel.parts.empty() && vessel.rods.empty()) {
      use.displaced = hydro::submerged_mesh(surface, parts.bodies.R_GB[b], p, parts.water->level).volume;
      use.mass_afloat = parts.bodies.mass[b] / parts.water->density;
    }
  }
  geometry::TriangleMesh mesh = surface;
  for (auto& p : mesh.vertices) p += parts.info.vessel_mass.com;
  return hull::hull_doubts(mesh, use);
}

}  // namespace nilas::sim
