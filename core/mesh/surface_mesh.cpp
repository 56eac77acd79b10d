#include "core/mesh/surface_mesh.h"

#include "core/base/error.h"

namespace nilas {

TriangleMesh triangles_of(const SurfaceMesh& mesh) {
  TriangleMesh out;
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

SurfaceMesh surface_of(const TriangleMesh& mesh) {
  SurfaceMesh out;
  std::vector<SurfaceMesh::Vertex_index> vertices;
  for (const auto& p : mesh.vertices) vertices.push_back(out.add_vertex(to_point(p)));
  const auto vertex = [&](int i) { return vertices[static_cast<std::size_t>(i)]; };
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

void add_note(std::vector<MeshNote>& notes, std::string what, std::size_t count, std::vector<Vec3> places) {
  if (count == 0) return;
  if (places.size() > MeshNote::k_most_places) places.resize(MeshNote::k_most_places);
  notes.push_back({std::move(what), count, std::move(places)});
}

}  // namespace nilas
