#pragma once
/// Axes made by an edge of one polytope and an edge of the other: crossing edges, and the nearest points of edges and
/// vertices when the parts are apart.
#include <vector>

#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// An edge in A's frame.
struct EdgeInA {
  int edge = -1;  ///< index in its part
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

/// A point of each part, in A's frame. The nearer it is to the other part, the fewer edges face it.
struct NearPoints {
  Vec3 on_a = Vec3::Zero(), on_b = Vec3::Zero();
};

/// Chooses all edges that may make an axis better than `at_least` [m], or hold a nearest point of parts that are apart.
/// These have a face that looks at the other part's near point. For an `at_least` below zero, where only crossings
/// count, the face must also look at the other part's centre. For all other edges, no direction between the normals of
/// their faces separates more than that point's height over these faces.
void choose_facing_edges(const PairView& pair, double at_least, const NearPoints& near, EdgeChoice& edges);

/// Chooses the edges at the supports along n: those at the supporting vertices, and those around the face there whose
/// normal is nearest to n.
void choose_edges_along(const PairView& pair, const Vec3& n, EdgeChoice& edges);

/// Chooses only the edges with these indices.
void choose_two_edges(const PairView& pair, int edge_a, int edge_b, EdgeChoice& edges);

/// Replaces `best` where crossing edges do better: a pair of edges is a face of the Minkowski difference where their
/// normal arcs cross [Gregorius 2013, The separating axis test between convex polyhedra], and then s is exact without a
/// search. `room`: storage.
void try_crossing_edges(const PairView& pair, const EdgeChoice& edges, std::vector<Axis>& room, Axis& best);
/// Lists all crossings with a separation above `least` [m], as axes.
void list_crossing_edges(const EdgeChoice& edges, double least, std::vector<Axis>& out);
/// Replaces `best` where the nearest points of two edges give a larger separation; needs parts that are apart.
void try_nearest_edges(const PairView& pair, const EdgeChoice& edges, Axis& best);

/// The nearest points of two segments p0 + t d0 and p1 + u d1, 0 <= t, u <= 1.
struct NearestOnSegments {
  double t = 0, u = 0;
};
NearestOnSegments nearest_on_segments(const Vec3& p0, const Vec3& d0, const Vec3& p1, const Vec3& d1);

}  // namespace nilas::detect
