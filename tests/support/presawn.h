#pragma once
/// The pre-sawn scenes with other hull meshes and perturbed fields. A measure that shares no code with contact/detect
/// gives how deep their pieces lie in hull and sheets.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/field/field.h"
#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/collision/sat_oracle.h"

namespace nilas::test {

/// Scene presawn-<letter> as shipped.
inline scene::Scene shipped_presawn(char letter) {
  return scene::read_scene(std::string(NILAS_SOURCE_DIR) + "/apps/scenes/presawn-" + letter + ".xml");
}

/// Scene presawn-<letter> with its grid as single floes, each moved by up to `amount` [m] in x and y; seed 0 moves
/// nothing. `triangles`: number of triangles of a generated hull that replaces the scene's.
inline scene::Scene presawn(char letter, std::uint64_t seed = 0, double amount = 0, std::optional<int> triangles = {}) {
  scene::Scene scene = shipped_presawn(letter);
  if (triangles) {
    scene.vessel->hull.clear();
    scene.vessel->generate = {HullKind::icebreaker, {{"triangles", *triangles}}};
  }
  const scene::FieldScene field = scene.ice->fields.at(0);
  const auto& cut = std::get<scene::GridFieldScene>(field.form);
  field::GridSpec grid;
  grid.low = {cut.region[0], cut.region[1]};
  grid.high = {cut.region[2], cut.region[3]};
  grid.rows = cut.rows;
  grid.columns = cut.columns;
  grid.gap = cut.gap;
  grid.shear = cut.shear_deg * k_deg;
  grid.stagger = cut.stagger;
  RandomStream random(seed, "perturbation");
  for (const auto& piece : field::grid_field(grid).floes) {
    const Vec2 shift = seed == 0 ? Vec2(0, 0) : Vec2(random.uniform(-amount, amount), random.uniform(-amount, amount));
    scene::FloeScene floe;
    floe.outline = piece.outline;
    for (auto& p : floe.outline) p += shift;
    floe.velocity = field.velocity;
    scene.ice->floes.push_back(floe);
  }
  scene.ice->fields.clear();
  return scene;
}

/// A convex triangle mesh with a brute-force search over separating axes: all face normals, and every pair of edges
/// whose cross product is a normal of the Minkowski difference.
class ConvexOracle {
 public:
  ConvexOracle(const geometry::TriangleMesh& mesh, const Mat3& R, const Vec3& p) {
    for (const Vec3& v : mesh.vertices) hull_.vertices.push_back(R * v + p);
    std::map<std::pair<int, int>, Vec3> first_side;
    for (const auto& triangle : mesh.triangles) {
      const auto corner = [&](int k) { return hull_.vertices[triangle[k % 3]]; };
      const Vec3 n = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      hull_.normals.push_back(n);
      offsets_.push_back(n.dot(corner(0)));
      for (int k = 0; k < 3; ++k) {
        const int i = triangle[k], j = triangle[(k + 1) % 3];
        const auto [other, is_new] = first_side.try_emplace(std::minmax(i, j), n);
        if (!is_new) edges_.push_back({corner(k), (corner(k + 1) - corner(k)).normalized(), n, other->second});
      }
    }
  }

  /// Largest separation of `piece` from the mesh along any axis [m]. Below 0 it is minus the length of the shortest
  /// translation that separates them.
  double separation(const oracle::Solid& piece) const {
    double most = -std::numeric_limits<double>::infinity();
    const auto lowest = [&](const Vec3& n) {
      double low = std::numeric_limits<double>::infinity();
      for (const Vec3& v : piece.vertices) low = std::min(low, n.dot(v));
      return low;
    };
    for (std::size_t f = 0; f < hull_.normals.size(); ++f)
      most = std::max(most, lowest(hull_.normals[f]) - offsets_[f]);
    if (most >= 0) return most;
    for (const Vec3& n : piece.normals) most = std::max(most, oracle::separation(hull_, piece, -n));
    for (const Vec3& along : directions(piece))
      for (const Edge& edge : edges_) {
        if (along.dot(edge.n1) * along.dot(edge.n2) >= 0) continue;
        const Vec3 across = along.cross(edge.along).normalized();
        const Vec3 n = across.dot(edge.n1 + edge.n2) > 0 ? across : Vec3(-across);
        most = std::max(most, lowest(n) - n.dot(edge.p));
      }
    return most;
  }

 private:
  struct Edge {
    Vec3 p, along, n1, n2;  ///< A point of the edge, its direction, and the normals on its two sides.
  };

  static std::vector<Vec3> directions(const oracle::Solid& piece) {
    std::vector<Vec3> all;
    for (const auto& [i, j] : piece.edges) {
      const Vec3 along = (piece.vertices[j] - piece.vertices[i]).normalized();
      constexpr double k_parallel = 1e-9;
      if (std::none_of(all.begin(), all.end(), [&](const Vec3& d) { return d.cross(along).norm() < k_parallel; }))
        all.push_back(along);
    }
    return all;
  }

  oracle::Solid hull_;
  std::vector<double> offsets_;
  std::vector<Edge> edges_;
};

/// Measures how deep the free pieces of a scene with a convex fixed hull lie in it and in the fixed sheets.
class PresawnOverlap {
 public:
  explicit PresawnOverlap(const sim::Simulation& simulation)
      : simulation_(simulation), hull_([&] {
          const bodies::Bodies& bodies = simulation.bodies();
          const auto vessel = static_cast<std::size_t>(simulation.vessel_index());
          // The mesh is the hull's triangles, not the faces that the contact search merged from them.
          return ConvexOracle(bodies.shape[vessel]->surface, bodies.R_GB[vessel], bodies.p_GB[vessel]);
        }()) {}

  struct Depth {
    double hull = 0, sheets = 0;  ///< Depth in the hull and in the sheets [m].
  };
  /// The largest depths at the present poses.
  Depth measure() const {
    const bodies::Bodies& bodies = simulation_.bodies();
    Depth depth;
    for (std::size_t b = 0; b < bodies.id.size(); ++b) {
      if (bodies.motion[b] != bodies::Motion::free) continue;
      const oracle::Solid piece = oracle::posed(bodies, static_cast<int>(b));
      depth.hull = std::max(depth.hull, -hull_.separation(piece));
      for (std::size_t s = 0; s < bodies.id.size(); ++s)
        if (bodies.kind[s] == bodies::BodyKind::floe && bodies.motion[s] == bodies::Motion::fixed &&
            is_near(bodies, b, s))
          depth.sheets =
              std::max(depth.sheets, -oracle::all_axes(oracle::posed(bodies, static_cast<int>(s)), piece).front().s);
    }
    return depth;
  }

 private:
  /// Whether a piece is in reach of a sheet, which lies on one side of the channel.
  static bool is_near(const bodies::Bodies& bodies, std::size_t piece, std::size_t sheet) {
    const double inner = 0.85;  // Inner edge of the sheets, |y| [m].
    const bool same_side = bodies.p_GB[piece].y() * bodies.p_GB[sheet].y() > 0;
    return same_side && std::abs(bodies.p_GB[piece].y()) + bodies.shape[piece]->bounding_radius > inner;
  }

  const sim::Simulation& simulation_;
  ConvexOracle hull_;
};

}  // namespace nilas::test
