#include "core/mesh/mend/surface_mesh.h"

#include <algorithm>
#include <map>

namespace nilas::mesh {

void silence_cgal() {
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});
}

geometry::TriangleMesh triangles_of(const SurfaceMesh& mesh) {
  geometry::TriangleMesh out;
  std::vector<int> number(mesh.num_vertices() + mesh.number_of_removed_vertices(), -1);
  for (const auto v : mesh.vertices()) {
    number[v] = static_cast<int>(out.vertices.size());
    out.vertices.push_back(to_vec(mesh.point(v)));
  }
  for (const auto f : mesh.faces()) {
    std::array<int, 3> t{};
    std::size_t k = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) t.at(k++) = number[v];
    out.triangles.push_back(t);
  }
  return out;
}

std::vector<Vec3> pinched_vertices(const geometry::TriangleMesh& mesh) {
  std::vector<std::map<int, int>> around(mesh.vertices.size());  // from each neighbour to the next
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) around[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  std::vector<Vec3> pinched;
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (around[v].empty()) continue;
    std::size_t walked = 0;
    for (auto next = around[v].begin(); next != around[v].end(); next = around[v].find(next->second)) {
      ++walked;
      if (next->second == around[v].begin()->first) break;
    }
    if (walked < around[v].size()) pinched.push_back(mesh.vertices[v]);
  }
  return pinched;
}

SurfaceMesh surface_of(const geometry::TriangleMesh& mesh) {
  SurfaceMesh out;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const auto& p : mesh.vertices) vertices.push_back(out.add_vertex(to_point(p)));
  const auto vertex = [&](int i) { return vertices[i]; };
  for (const auto& t : mesh.triangles)
    NILAS_DEMAND(out.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) != SurfaceMesh::null_face());
  return out;
}

Vec3 middle(const SurfaceMesh& mesh, SurfaceMesh::Face_index face) {
  Vec3 sum = Vec3::Zero();
  double corners = 0;
  for (const auto v : mesh.vertices_around_face(mesh.halfedge(face))) {
    sum += to_vec(mesh.point(v));
    corners += 1;
  }
  return sum / corners;
}

void add_note(std::vector<MeshNote>& notes, std::string what, std::size_t count, const std::vector<Vec3>& places) {
  if (count == 0) return;
  auto note = std::find_if(notes.begin(), notes.end(), [&](const MeshNote& old) { return old.what == what; });
  if (note == notes.end()) note = notes.insert(notes.end(), {std::move(what), 0, {}});
  note->count += count;
  const std::size_t shown = std::min(places.size(), MeshNote::k_most_places - note->places.size());
  note->places.insert(note->places.end(), places.begin(), places.begin() + static_cast<std::ptrdiff_t>(shown));
}

}  // namespace nilas::mesh
