/// Crossings within and between the closed shells of a mesh.
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <fmt/format.h>

#include <new>

#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

bool clean(const SurfaceMesh& mesh) { return !mesh.is_empty() && CGAL::is_closed(mesh) && !crosses_itself(mesh); }

double volume(const SurfaceMesh& mesh) { return std::abs(PMP::volume(mesh)); }

/// Both ways CGAL has; the one that changes the volume less, where it is small.
bool uncross(SurfaceMesh& shell) {
  constexpr double k_most_change = 0.02;  // of the volume: beyond it what was meant is anyone's guess
  const auto close_to_before = [&](const SurfaceMesh& tried) {
    return clean(tried) && std::abs(volume(tried) - volume(shell)) <= k_most_change * volume(shell);
  };
  for (const bool local : {true, false}) {
    SurfaceMesh tried = shell;
    try {
      if (local)
        PMP::experimental::remove_self_intersections(tried, CGAL::parameters::preserve_genus(false));
      else
        PMP::experimental::autorefine_and_remove_self_intersections(tried);
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {
      continue;
    }
    tried.collect_garbage();
    if (!close_to_before(tried)) continue;
    shell = std::move(tried);
    return true;
  }
  return false;
}

/// A point of `inner` decides: the two do not cross.
bool inside(const SurfaceMesh& inner, const SurfaceMesh& outer) {
  const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side(outer);
  for (const auto v : inner.vertices())
    if (const auto where = side(inner.point(v)); where != CGAL::ON_BOUNDARY) return where == CGAL::ON_BOUNDED_SIDE;
  return true;
}

enum class Union { separate, dropped, replaced, united, failed };

/// Adds `shell` to `whole`.
Union unite(SurfaceMesh& whole, SurfaceMesh& shell) {
  if (!PMP::do_intersect(whole, shell)) {
    if (inside(shell, whole)) return Union::dropped;
    if (!inside(whole, shell)) return Union::separate;
    whole = shell;
    return Union::replaced;
  }
  SurfaceMesh a = whole, b = shell, both;
  try {
    if (!PMP::corefine_and_compute_union(a, b, both, CGAL::parameters::throw_on_self_intersection(true)))
      return Union::failed;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return Union::failed;
  }
  both.collect_garbage();
  if (!clean(both)) return Union::failed;
  whole = std::move(both);
  return Union::united;
}

struct Shells {
  std::vector<SurfaceMesh> separate;
  std::vector<Vec3> dropped, united, failed;
};

/// Largest first, each to the first of those before that it meets.
Shells united(std::vector<SurfaceMesh> shells) {
  std::stable_sort(shells.begin(), shells.end(), [](const auto& a, const auto& b) { return volume(a) > volume(b); });
  Shells result;
  for (auto& shell : shells) {
    const Vec3 place = middle(shell, *shell.faces().begin());
    // a shell may bridge several that were apart
    for (std::size_t k = 0; k < result.separate.size();) {
      SurfaceMesh& whole = result.separate[k];
      const Union how = unite(whole, shell);
      if (how == Union::failed) result.failed.push_back(place);
      if (how == Union::united) result.united.push_back(place);
      if (how == Union::dropped || how == Union::replaced) result.dropped.push_back(place);
      if (how == Union::dropped || how == Union::failed) {
        shell.clear();
        break;
      }
      if (how == Union::separate) {
        ++k;
        continue;
      }
      shell = std::move(whole);
      result.separate.erase(result.separate.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    }
    if (!shell.is_empty()) result.separate.push_back(std::move(shell));
  }
  return result;
}

/// Outward and free of crossings, each by itself.
std::vector<SurfaceMesh> mended_shells(const SurfaceMesh& mesh, MendedMesh& notes) {
  std::vector<SurfaceMesh> shells;
  PMP::split_connected_components(mesh, shells);
  std::vector<Vec3> turned, uncrossed, crossed;
  for (auto& shell : shells) {
    if (const auto places = crossings(shell); !places.empty()) {
      auto& into = uncross(shell) ? uncrossed : crossed;
      into.insert(into.end(), places.begin(), places.end());
    }
    if (PMP::volume(shell) < 0) {
      turned.push_back(middle(shell, *shell.faces().begin()));
      PMP::reverse_face_orientations(shell);
    }
  }
  add_note(notes.done, "shells wound inwards turned", turned.size(), turned);
  add_note(notes.done, "pairs of faces that cross within a shell cut apart", uncrossed.size(), uncrossed);
  add_note(notes.open, "pairs of faces that cross within a shell", crossed.size(), crossed);
  return shells;
}

}  // namespace

bool crosses_itself(const SurfaceMesh& mesh) { return PMP::does_self_intersect(mesh); }

std::vector<Vec3> crossings(const SurfaceMesh& mesh) {
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  std::vector<Vec3> places;
  for (const auto& [a, b] : pairs) places.push_back(0.5 * (middle(mesh, a) + middle(mesh, b)));
  return places;
}

void resolve_shells(SurfaceMesh& mesh, MendedMesh& notes) {
  std::vector<SurfaceMesh> shells = mended_shells(mesh, notes);
  std::erase_if(shells, [](const SurfaceMesh& shell) { return !(volume(shell) > 0); });
  if (shells.empty() && notes.open.empty()) throw InputError(k_nothing_left);
  if (notes.open.empty() && shells.size() > 1) {
    Shells result = united(std::move(shells));
    add_note(notes.done, "overlapping shells united", result.united.size(), result.united);
    add_note(notes.done, "shells inside another dropped", result.dropped.size(), result.dropped);
    add_note(notes.open, "shells that overlap and could not be united", result.failed.size(), result.failed);
    shells = std::move(result.separate);
  }
  mesh.clear();
  for (const auto& shell : shells) CGAL::copy_face_graph(shell, mesh);
}

}  // namespace nilas::mesh
