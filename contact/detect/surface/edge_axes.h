#pragma once
/// Axes made by an edge of one polytope and an edge of the other: crossing edges, and the nearest points of edges and
/// vertices when the parts are apart.
#include <vector>

#include "contact/detect/broad/pair_view.h"

namespace nilas {

/// An edge in A's frame.
struct EdgeInA {
  int edge = -1;  ///< of its part
  Vec3 start = Vec3::Zero(), along = Vec3::Zero(), middle = Vec3::Zero();
  Vec3 n0 = Vec3::Zero(), n1 = Vec3::Zero();  ///< outward normals of its faces
  Vec3 arc = Vec3::Zero();                    ///< n1 x n0
};

/// Edges of both parts to combine; kept between pairs for its storage.
struct EdgeChoice {
  std::vector<EdgeInA> of_a, of_b;
  std::vector<int> chosen;
  Eigen::ArrayXd heights, heights_of_centre;
};

/// A point of each part, in A's frame; the nearer to the other part, the fewer edges face it.
struct NearPoints {
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
};

/// All edges that may make an axis better than `at_least` [m], or hold a nearest point of parts that are apart: those
/// with a face that looks at the other part's near point, and, for an `at_least` below zero, where only crossings
/// count, at its centre. For the others no direction between their faces' normals separates more than that point's
/// height over these faces.
void choose_facing_edges(const PairView& pair, double at_least, const NearPoints& near, EdgeChoice& edges);

/// The edges at the supports along n: those at the supporting vertices and around the face there that looks most along
/// n.
void choose_edges_along(const PairView& pair, const Vec3& n, EdgeChoice& edges);

/// The edges with these numbers alone.
void choose_two_edges(const PairView& pair, int edge_a, int edge_b, EdgeChoice& edges);

/// Replaces `best` where crossing edges do better: a pair of edges is a face of the Minkowski difference where their
/// normal arcs cross [Gregorius 2013, The separating axis test between convex polyhedra], and then s is exact without a
/// search. `room`: storage.
void try_crossing_edges(const PairView& pair, const EdgeChoice& edges, std::vector<Axis>& room, Axis& best);
/// All crossings with a separation above `least` [m], as axes.
void list_crossing_edges(const EdgeChoice& edges, double least, std::vector<Axis>& out);
/// Replaces `best` where the nearest points of two edges give a larger separation; needs parts that are apart.
void try_nearest_edges(const PairView& pair, const EdgeChoice& edges, Axis& best);

/// Nearest points of two segments p0 + t d0 and p1 + u d1, 0 <= t, u <= 1.
struct NearestOnSegments {
  double t = 0, u = 0;
};
NearestOnSegments nearest_on_segments(const Vec3& p0, const Vec3& d0, const Vec3& p1, const Vec3& d1);

}  // namespace nilas
