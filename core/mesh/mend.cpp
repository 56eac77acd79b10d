#include "core/mesh/mend.h"

#include "core/base/error.h"
#include "core/bodies/weld.h"
#include "core/mesh/surface_mesh.h"

namespace nilas {

namespace {

/// As a reader of the written file will see it.
TriangleMesh as_stored(const SurfaceMesh& mesh) {
  const TriangleMesh rounded = rounded_to_float(triangles_of(mesh));
  Weld weld;
  for (const auto& t : rounded.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = rounded.vertices[static_cast<std::size_t>(t[k])];
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) weld.add(corners);
  }
  return weld.take();
}

bool sound(const TriangleMesh& mesh) { return find_defects(mesh).sound() && !crosses_itself(surface_of(mesh)); }

/// Where two shells were united, rounding leaves triangles as narrow as it is coarse, and lets them cross.
void settle(const MendSettings& settings, MendedMesh& result) {
  constexpr int k_rounds = 3;
  for (int round = 0; round < k_rounds && result.open.empty() && !sound(result.mesh); ++round) {
    PolygonSoup soup{result.mesh.vertices, {}};
    for (const auto& t : result.mesh.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
    SurfaceMesh mesh = mesh_of_soup(soup, settings.gap, false, result.done);
    close_borders(mesh, settings, result);
    if (result.open.empty()) resolve_shells(mesh, result);
    result.mesh = as_stored(mesh);
  }
}

MendedMesh mended_once(const PolygonSoup& soup, const MendSettings& settings, bool backs_are_copies) {
  MendedMesh result;
  try {
    SurfaceMesh mesh = mesh_of_soup(soup, settings.gap, backs_are_copies, result.done);
    close_borders(mesh, settings, result);
    if (result.open.empty()) resolve_shells(mesh, result);
    result.mesh = as_stored(mesh);
    settle(settings, result);
  } catch (const CGAL::Failure_exception& e) {
    throw InputError(std::string("the mesh could not be mended: ") + e.what());
  }
  const MeshDefects left = find_defects(result.mesh);
  if (result.open.empty() && !left.sound()) add_note(result.open, left.text(), 1, {left.example});
  return result;
}

}  // namespace

MendedMesh mend(const PolygonSoup& soup, const MendSettings& settings) {
  NILAS_DEMAND(settings.gap > 0);
  // knife edges are thinner than cracks are wide: the full gap only where a fine one leaves something open
  constexpr double k_fine = 1e-2;
  for (const bool backs_are_copies : {false, true})
    for (const double share : {k_fine, 1.0}) {
      try {
        MendedMesh tried = mended_once(soup, {share * settings.gap, settings.largest_hole}, backs_are_copies);
        if (tried.open.empty()) return tried;
      } catch (const InputError&) {
        continue;  // the last way's reason is given below
      }
    }
  return mended_once(soup, settings, false);
}

}  // namespace nilas
