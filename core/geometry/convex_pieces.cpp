/// Convex partition by CGAL; alone in its file because it compiles slowly.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <CGAL/property_map.h>

#include <list>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"

namespace nilas::geometry {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Partition of the polygon over the vertices `loop` of the outline; works on indices, so that no vertex moves.
std::vector<std::vector<int>> partition(const std::vector<Vec2>& outline, const std::vector<int>& loop) {
  std::vector<Kernel::Point_2> points;
  for (const int i : loop) points.emplace_back(outline[i].x(), outline[i].y());
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::type;
  using Traits = CGAL::Partition_traits_2<Kernel, Map>;
  const Traits traits(CGAL::make_property_map(points));
  std::list<std::size_t> places(points.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::list<Traits::Polygon_2> pieces;
  try {
    // The fewest pieces cost O(n^4): under half a millisecond up to here.
    constexpr std::size_t k_optimal_corners = 24;
    if (places.size() <= k_optimal_corners)
      CGAL::optimal_convex_partition_2(places.begin(), places.end(), std::back_inserter(pieces), traits);
    else
      CGAL::approx_convex_partition_2(places.begin(), places.end(), std::back_inserter(pieces), traits);
  } catch (const CGAL::Failure_exception& e) {
    throw InputError(std::string("a floe outline could not be cut into convex pieces: ") + e.what());
  }
  std::vector<std::vector<int>> found;
  for (const auto& piece : pieces) {
    auto& indices = found.emplace_back();
    for (const std::size_t place : piece.container()) indices.push_back(loop[place]);
  }
  return found;
}

/// Puts the outline's straight vertices back on the edges of the pieces they lie on.
std::vector<int> with_straight_vertices(const std::vector<int>& piece, const std::vector<int>& corner_after, int n) {
  std::vector<int> full;
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const int from = piece[k], to = piece[(k + 1) % piece.size()];
    full.push_back(from);
    if (corner_after[from] != to) continue;  // a cut through the inside
    for (int i = (from + 1) % n; i != to; i = (i + 1) % n) full.push_back(i);
  }
  return full;
}

}  // namespace

std::vector<std::vector<int>> convex_piece_indices(const std::vector<Vec2>& outline) {
  if (!is_simple(outline)) throw InputError("a floe outline crosses itself or repeats a point");
  if (is_clockwise(outline)) throw InputError("a floe outline must run counter-clockwise");
  const int n = static_cast<int>(outline.size());
  std::vector<int> all(outline.size());
  std::iota(all.begin(), all.end(), 0);
  if (is_convex(outline)) return {all};

  // Cut between true corners only: a straight vertex that rounding bent inwards is no reason for a cut.
  std::vector<int> loop = corners(outline);
  std::vector<Vec2> reduced;
  for (const int i : loop) reduced.push_back(outline[i]);
  if (!is_simple(reduced)) loop = all;
  std::vector<int> corner_after(outline.size(), -1);
  for (std::size_t k = 0; k < loop.size(); ++k) corner_after[loop[k]] = loop[(k + 1) % loop.size()];

  std::vector<std::vector<int>> pieces;
  for (const auto& piece : partition(outline, loop)) pieces.push_back(with_straight_vertices(piece, corner_after, n));
  return pieces;
}

std::vector<std::vector<Vec2>> convex_pieces(const std::vector<Vec2>& outline) {
  std::vector<std::vector<Vec2>> pieces;
  for (const auto& indices : convex_piece_indices(outline)) {
    auto& piece = pieces.emplace_back();
    for (const int i : indices) piece.push_back(outline[i]);
  }
  return pieces;
}

}  // namespace nilas::geometry
