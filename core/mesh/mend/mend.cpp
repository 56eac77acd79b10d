#include "core/mesh/mend/mend.h"

#include <fmt/format.h>

#include <optional>

#include "core/base/error.h"
#include "core/geometry/weld.h"
#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

/// The mesh as it will be read back from the written file.
geometry::TriangleMesh as_stored(const SurfaceMesh& mesh) {
  const geometry::TriangleMesh rounded = geometry::rounded_to_float(triangles_of(mesh));
  geometry::Weld weld;
  for (const auto& t : rounded.triangles) {
    std::array<Vec3, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = rounded.vertices[t[k]];
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0]) weld.add(corners);
  }
  return weld.take();
}

/// One pass of all steps. The mesh may still have faults that the final rounding causes.
geometry::TriangleMesh remade(const PolygonSoup& soup, const MendSettings& settings, bool backs_are_copies,
                              MendedMesh& notes) {
  WeldedSoup welded = mesh_of_soup(soup, settings.gap, backs_are_copies, notes);
  close_borders(welded, settings, notes);
  if (notes.open.empty()) resolve_shells(welded.mesh, notes);
  geometry::TriangleMesh mesh = as_stored(welded.mesh);
  if (notes.open.empty() && mesh.triangles.empty()) throw InputError(k_nothing_left);
  return mesh;
}

/// The faults that keep a mesh from being that of a solid, with their places.
std::vector<MeshNote> faults_of(const geometry::TriangleMesh& mesh) {
  std::vector<MeshNote> faults;
  if (const geometry::MeshDefects left = geometry::find_defects(mesh); !left.sound()) {
    add_note(faults, left.text(), 1, {left.example});
    return faults;
  }
  const auto pinches = pinched_vertices(mesh);
  add_note(faults, "points where the surface touches itself", pinches.size(), pinches);
  if (!faults.empty()) return faults;
  const auto places = crossings(surface_of(mesh));
  add_note(faults, "pairs of faces that cross once rounded to float32", places.size(), places);
  return faults;
}

/// Where two shells were united, rounding leaves triangles as narrow as it is coarse, and lets them cross.
void settle(const MendSettings& settings, MendedMesh& result) {
  constexpr int k_rounds = 3;
  for (int round = 0; result.open.empty(); ++round) {
    std::vector<MeshNote> faults = faults_of(result.mesh);
    if (faults.empty() || round == k_rounds) {
      result.open = std::move(faults);
      return;
    }
    PolygonSoup soup{result.mesh.vertices, {}};
    for (const auto& t : result.mesh.triangles) soup.polygons.push_back({t[0], t[1], t[2]});
    result.mesh = remade(soup, settings, false, result);
    if (!result.open.empty()) result.open = std::move(faults);  // closer to the file than the faults that mending met
  }
}

MendedMesh mended_once(const PolygonSoup& soup, const MendSettings& settings, bool backs_are_copies) {
  MendedMesh result;
  by_cgal("the mesh could not be mended", [&] {
    result.mesh = remade(soup, settings, backs_are_copies, result);
    settle(settings, result);
  });
  return result;
}

/// Only the points that polygons use: what else a file holds may lie anywhere.
PolygonSoup without_unused(const PolygonSoup& soup) {
  PolygonSoup kept;
  std::vector<int> number(soup.points.size(), -1);
  for (const auto& loop : soup.polygons) {
    auto& fresh = kept.polygons.emplace_back();
    for (const int v : loop) {
      int& n = number[v];
      if (n < 0) {
        n = static_cast<int>(kept.points.size());
        kept.points.push_back(soup.points[v]);
      }
      fresh.push_back(n);
    }
  }
  return kept;
}

/// Throws InputError for a face of so many corners that cutting it into triangles takes minutes.
void demand_few_corners(const PolygonSoup& soup) {
  constexpr std::size_t k_most = 10000;
  for (const auto& loop : soup.polygons) {
    if (loop.size() <= k_most) continue;
    const Vec3& p = soup.points[loop.front()];
    throw InputError(fmt::format("a face from ({:.6g}, {:.6g}, {:.6g}) m on has {} corners; allowed: {}", p.x(), p.y(),
                                 p.z(), loop.size(), k_most));
  }
}

/// Distance below which doubles cannot tell points this far from the origin apart [m].
double least_gap(const PolygonSoup& soup) {
  constexpr double k_least = 1e-12;  // share of the largest coordinate
  double furthest = 0;
  for (const auto& p : soup.points) furthest = std::max(furthest, p.cwiseAbs().maxCoeff());
  return k_least * furthest;
}

/// The result of one method of mending, or why there is none.
struct Attempt {
  std::optional<MendedMesh> mesh;
  std::exception_ptr refused;
};

Attempt attempt(const PolygonSoup& soup, const MendSettings& settings, bool backs_are_copies) {
  try {
    return {mended_once(soup, settings, backs_are_copies), {}};
  } catch (const InputError&) {
    return {{}, std::current_exception()};
  }
}

}  // namespace

MendedMesh mend(const PolygonSoup& given, const MendSettings& settings) {
  NILAS_DEMAND(settings.gap > 0);
  const PolygonSoup soup = without_unused(given);
  demand_few_corners(soup);
  const double least = least_gap(soup);
  // knife edges are thinner than cracks are wide: the full gap only where a fine one leaves something open
  constexpr double k_fine = 1e-2;
  Attempt plain;  // the full gap, backs no copies: what it leaves open says most
  for (const bool backs_are_copies : {false, true})
    for (const double share : {k_fine, 1.0}) {
      const MendSettings how{std::max(share * settings.gap, least), settings.largest_hole};
      Attempt tried = attempt(soup, how, backs_are_copies);
      if (tried.mesh && tried.mesh->open.empty()) return std::move(*tried.mesh);
      if (!backs_are_copies) plain = std::move(tried);
    }
  if (!plain.mesh) std::rethrow_exception(plain.refused);
  return std::move(*plain.mesh);
}

}  // namespace nilas::mesh
