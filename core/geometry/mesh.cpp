#include "core/geometry/mesh.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "core/base/error.h"

namespace nilas::geometry {

namespace {

/// One use of an edge by a triangle.
struct EdgeUse {
  int low, high;  ///< vertices
  bool upwards;   ///< walked from low to high
  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  }
};

bool repeats_vertex(const std::array<int, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool has_no_area(const TriangleMesh& mesh, const std::array<int, 3>& t) {
  constexpr double k_rounding = 1e-14;  // height over longest edge below which double precision cannot tell it from 0
  const Vec3 ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
  const Vec3 ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
  const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  return ab.cross(ac).norm() <= k_rounding * longest2;
}

std::vector<EdgeUse> sorted_edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    if (repeats_vertex(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  }
  std::stable_sort(uses.begin(), uses.end());
  return uses;
}

}  // namespace

std::string MeshDefects::text() const {
  if (sound()) return "closed and outward";
  std::string s;
  const auto add = [&](const std::string& what) { s += (s.empty() ? "" : ", ") + what; };
  const auto count = [&](int n, const char* one, const char* more) {
    if (n > 0) add(std::to_string(n) + " " + (n == 1 ? one : more));
  };
  count(open_edges, "open edge", "open edges");
  count(non_manifold_edges, "edge shared by more than two triangles or wound inconsistently",
        "edges shared by more than two triangles or wound inconsistently");
  count(degenerate_triangles, "triangle without area", "triangles without area");
  if (inward) add("triangles wound inwards (the volume is not positive)");
  std::array<char, 96> place{};
  std::snprintf(place.data(), place.size(), " at (%.6g, %.6g, %.6g) m", example.x(), example.y(), example.z());
  return s + "; for example" + place.data();
}

double signed_volume(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  constexpr double k_tetrahedron = 1.0 / 6.0;  // volume of a tetrahedron over its triple product
  const Vec3 reference = mesh.vertices.front();
  double triple_products = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - reference, b = mesh.vertices[t[1]] - reference;
    triple_products += a.dot(b.cross(mesh.vertices[t[2]] - reference));
  }
  return k_tetrahedron * triple_products;
}

MeshDefects find_defects(const TriangleMesh& mesh) {
  MeshDefects defects;
  const int vertices = static_cast<int>(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const int v : t) NILAS_DEMAND(v >= 0 && v < vertices);
  if (mesh.triangles.empty()) {
    defects.open_edges = 1;
    return defects;
  }
  defects.inward = !(signed_volume(mesh) > 0);
  bool has_example = false;
  const auto note = [&](int& count, const Vec3& place) {
    ++count;
    if (!has_example) defects.example = place;
    has_example = true;
  };
  const auto uses = sorted_edge_uses(mesh);
  for (auto first = uses.begin(); first != uses.end();) {
    const auto last = std::upper_bound(first, uses.end(), *first);
    const Vec3 middle = 0.5 * (mesh.vertices[first->low] + mesh.vertices[first->high]);
    if (last - first == 1)
      note(defects.open_edges, middle);
    else if (last - first > 2 || first->upwards == (first + 1)->upwards)
      note(defects.non_manifold_edges, middle);
    first = last;
  }
  for (const auto& t : mesh.triangles)
    if (repeats_vertex(t) || has_no_area(mesh, t)) note(defects.degenerate_triangles, mesh.vertices[t[0]]);
  if (!has_example) defects.example = mesh.vertices[mesh.triangles.front()[0]];
  return defects;
}

TriangleMesh rounded_to_float(TriangleMesh mesh) {
  for (auto& p : mesh.vertices)
    for (double& x : p) {
      // volatile: g++ 12 -O2 leaves out a conversion to float and back of two neighbouring numbers (SLP vectoriser)
      const volatile float stored = static_cast<float>(x);
      x = static_cast<double>(stored);
    }
  return mesh;
}

}  // namespace nilas::geometry
