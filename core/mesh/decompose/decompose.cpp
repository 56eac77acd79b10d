#include "core/mesh/decompose/decompose.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/geometry/mesh_box.h"
#include "core/mesh/decompose/pieces.h"
#include "core/mesh/decompose/surface_distance.h"
#include "core/mesh/mend/surface_mesh.h"

namespace nilas::mesh {

namespace {

/// Convex hull of a piece, or of several.
struct Part {
  geometry::TriangleMesh hull;
  double deviation = 0;  ///< largest distance found of the hull outside the whole mesh [m]
};

/// A piece of the solid with its convex hull.
struct Piece : Part {
  geometry::TriangleMesh solid;
  bool whole = false;  ///< true if no plane was found that cuts it
};

/// Grid spacing [m], finer than float32 except for the smallest coordinates. Without the grid, those and remainders of
/// zeros would make corners that are not exactly in line.
double grid_for(const geometry::TriangleMesh& mesh) {
  const auto box = geometry::box_of(mesh);
  constexpr int k_bits = 26;
  const double reach = std::max(box.max().cwiseAbs().maxCoeff(), box.min().cwiseAbs().maxCoeff());
  return std::exp2(std::ceil(std::log2(reach)) - k_bits);
}

Part mirrored(Part part) {
  for (auto& p : part.hull.vertices) p.y() = 0.0 - p.y();
  for (auto& t : part.hull.triangles) std::swap(t[1], t[2]);
  return part;
}

std::vector<geometry::TriangleMesh> hulls_of(std::vector<Part> parts) {
  std::vector<geometry::TriangleMesh> hulls;
  for (auto& part : parts) hulls.push_back(std::move(part.hull));
  return hulls;
}

double twice_area(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm(); }

/// Vertices furthest along each axis, both ways.
std::array<Vec3, 6> extremes(const geometry::TriangleMesh& hull) {
  std::array<Vec3, 6> found;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto axis = static_cast<Eigen::Index>(k % 3);
    const double sign = k < 3 ? 1 : -1;
    found[k] = *std::max_element(hull.vertices.begin(), hull.vertices.end(),
                                 [&](const Vec3& p, const Vec3& q) { return sign * p[axis] < sign * q[axis]; });
  }
  return found;
}

/// Adds a row and removes rows that are no better in both count and deviation.
void add_count(const PartCount& row, std::vector<PartCount>& table) {
  std::erase_if(table, [&](const PartCount& old) { return old.parts >= row.parts && old.deviation >= row.deviation; });
  table.push_back(row);
}

class Decomposition {
 public:
  Decomposition(const geometry::TriangleMesh& mesh, const PartSettings& settings)
      : settings_(settings), mesh_(corners_of(mesh)) {
    const auto box = geometry::box_of(mesh);
    grid_ = grid_for(mesh);
    skin_ = k_skin * box.sizes().maxCoeff();
    diagonal_ = box.diagonal().norm();
    target_ = settings.tolerance / (1 + k_slack + k_precision);
    pieces_.push_back(made(mesh));
  }

  /// Splits the worst piece until all are good or there are too many of them.
  void split() {
    note_count();
    if (settings_.symmetric && !port_only_ && worst() > target_) keep_port_half();
    std::size_t next_note = 2 * count();
    while (count() < k_pieces_per_part * settings_.most && worst() > target_) {
      const std::size_t k = worst_piece();
      if (k == pieces_.size()) break;
      split_piece(k);
      if (count() >= next_note) {
        note_count();
        while (next_note <= count()) next_note *= 2;
      }
    }
  }

  /// Reduces the target, at most three times, until there is a piece to cut. False if there is none, or if there are as
  /// many pieces as allowed.
  bool tighten() {
    constexpr double k_share = 0.6;
    constexpr int k_tightened = 3;
    for (int n = 0; n < k_tightened && count() < settings_.most; ++n) {
      target_ *= k_share;
      for (auto& piece : pieces_)
        if (piece.deviation <= target_ && !piece.hull.triangles.empty()) piece.deviation = deviation(piece, target_);
      if (worst_piece() < pieces_.size()) return true;
    }
    return false;
  }

  /// The result, with at most the allowed number of convex pieces, whatever their deviation.
  ConvexParts result() const {
    constexpr double k_more = 1.5;
    double allowed = std::max(worst(), target_);
    // joining neighbours is not enough where there are more separate groups than allowed pieces
    const bool apart = groups() > settings_.most;
    const auto joined_within = [&] {
      return joined(allowed, apart ? std::max(allowed, settings_.tolerance) : settings_.tolerance);
    };
    std::vector<Part> parts = joined_within();
    // no hull exceeds the mesh by more than its diagonal: then all are one
    while (parts.size() > settings_.most && allowed < diagonal_) {
      allowed *= k_more;
      parts = joined_within();
    }
    if (parts.size() > settings_.most)
      throw InputError(fmt::format("{} convex parts could not be joined; allowed: {}", parts.size(), settings_.most));
    return {hulls_of(std::move(parts)), {}, table_};
  }

 private:
  static constexpr double k_slack = 0.1, k_precision = 0.1;  // share of the found deviation, and of the allowed one
  static constexpr std::size_t k_pieces_per_part = 4;        // largest number before joining
  static constexpr double k_skin = 1e-6;                     // share of the size that rounding moves

  /// Deviation of a hull outside the mesh. A found value up to `allowed` means a true one of at most (1 + k_slack +
  /// k_precision) allowed. The search stops above `ceiling`.
  double deviation(const Part& part, double allowed, double ceiling = std::numeric_limits<double>::infinity()) const {
    std::vector<Corners> faces = corners_of(part.hull);
    DistanceSearch search{.precision = k_precision * allowed,
                          .outside_only = true,
                          .floor = (1 + k_slack) * allowed,
                          .slack = k_slack,
                          .ceiling = ceiling};
    // Large faces come first: a face that bridges a hollow is large, and most common hulls are rejected for it.
    constexpr std::size_t k_large = 16;
    const auto large = faces.begin() + static_cast<std::ptrdiff_t>(std::min(k_large, faces.size()));
    std::partial_sort(faces.begin(), large, faces.end(),
                      [](const Corners& f, const Corners& g) { return twice_area(f) > twice_area(g); });
    const double bridged = mesh_.largest(mesh_.without_shared_faces({faces.begin(), large}, skin_), search).largest;
    if (bridged > ceiling) return bridged;
    search.floor = std::max(search.floor, (1 + k_slack) * bridged);
    return std::max(bridged, mesh_.largest(mesh_.without_shared_faces({large, faces.end()}, skin_), search).largest);
  }
  /// Convex hull of the corners in stored precision, so that the written piece is exactly convex.
  geometry::TriangleMesh stored_hull(std::vector<Vec3> points) const {
    for (auto& p : points) p = grid_ * (p / grid_).array().round();
    return convex_hull(geometry::rounded_to_float({std::move(points), {}}).vertices);
  }
  Piece made(geometry::TriangleMesh solid, double ceiling = std::numeric_limits<double>::infinity()) const {
    Piece piece;
    piece.hull = stored_hull(solid.vertices);
    piece.deviation = piece.hull.triangles.empty() ? 0 : deviation(piece, target_, ceiling);
    piece.solid = std::move(solid);
    return piece;
  }
  std::size_t count() const { return (port_only_ ? 2 : 1) * pieces_.size(); }
  double worst() const {
    double largest = 0;
    for (const auto& piece : pieces_) largest = std::max(largest, piece.deviation);
    return largest;
  }
  /// Index of the worst piece that can be cut; pieces_.size() if there is none.
  std::size_t worst_piece() const {
    std::size_t found = pieces_.size();
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (!pieces_[k].whole && pieces_[k].deviation > target_ &&
          (found == pieces_.size() || pieces_[k].deviation > pieces_[found].deviation))
        found = k;
    return found;
  }

  void keep_port_half() {
    auto half = below(pieces_.front().solid, {-Vec3::UnitY(), 0});
    if (half.empty()) return;
    pieces_.clear();
    for (auto& solid : half) pieces_.push_back(made(std::move(solid)));
    port_only_ = true;
  }

  /// Both sides of a cut, and its quality: the worst side's deviation, then the sum.
  struct Cut {
    std::vector<Piece> sides;
    std::pair<double, double> merit{std::numeric_limits<double>::infinity(), 0};
  };

  /// Tries a cut. The result has no sides where the plane cuts nothing off. Deviations above `ceiling` are not exact.
  Cut tried(const geometry::TriangleMesh& solid, const HalfSpace& plane, double ceiling) const {
    Cut found;
    std::pair<double, double> merit{0, 0};
    for (auto& side : cut(solid, plane)) {
      found.sides.push_back(made(std::move(side), ceiling));
      merit.first = std::max(merit.first, found.sides.back().deviation);
      merit.second += found.sides.back().deviation;
    }
    if (found.sides.size() > 1) found.merit = merit;
    return found;
  }

  /// Splits a piece by the cut with the smallest worst deviation, among those that leave the least volume.
  void split_piece(std::size_t k) {
    constexpr std::size_t k_tried = 4, k_at_once = 2;  // not as many as threads, which must not change the result
    const auto planes = promising_cuts(pieces_[k].solid, k_tried, settings_.threads);
    Cut best;
    for (std::size_t first = 0; first < planes.size(); first += k_at_once) {
      std::vector<Cut> cuts(std::min(k_at_once, planes.size() - first));
      parallel_pieces(std::ssize(cuts), settings_.threads, [&](std::ptrdiff_t n) {
        const auto c = static_cast<std::size_t>(n);
        cuts[c] = tried(pieces_[k].solid, planes[first + c], best.merit.first);
      });
      for (auto& one : cuts)
        if (one.merit < best.merit) best = std::move(one);
    }
    if (best.sides.empty()) {
      pieces_[k].whole = true;
      return;
    }
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
    for (auto& side : best.sides) pieces_.push_back(std::move(side));
  }

  void note_count() { add_count({count(), (1 + k_slack) * worst() + k_precision * target_}, table_); }

  /// Whether points between two hulls already deviate by more than the search tolerates. This rejects most pairs at a
  /// hundredth of the cost of their common hull.
  bool bridge(const Part& a, const Part& b, double allowed) const {
    const double off = (1 + k_slack + k_precision) * allowed;
    for (const Vec3& p : extremes(a.hull))
      for (const Vec3& q : extremes(b.hull))
        for (const double share : {0.5, 0.25, 0.75})
          if (mesh_.outside(p + share * (q - p)) > off) return true;
    return false;
  }
  /// The common hull of two pieces. Deviations above `allowed` are not exact; there is no hull where bridge() rejects
  /// the pair.
  Part common_hull(const Part& a, const Part& b, double allowed) const {
    if (bridge(a, b, allowed)) return {{}, std::numeric_limits<double>::infinity()};
    std::vector<Vec3> points = a.hull.vertices;
    points.insert(points.end(), b.hull.vertices.begin(), b.hull.vertices.end());
    Part both{stored_hull(std::move(points))};
    both.deviation = deviation(both, allowed, allowed);
    return both;
  }

  /// Joins pairs within `reach`, the least deviating first, while their hull stays within `allowed`. Then returns both
  /// halves.
  std::vector<Part> joined(double allowed, double reach) const {
    std::vector<Part> parts;
    for (const auto& piece : pieces_)
      if (!piece.hull.triangles.empty()) parts.push_back(piece);
    join_pairs(parts, allowed, reach);
    if (!port_only_) return parts;
    std::vector<Part> both;
    for (auto& part : parts) {
      Part image = mirrored(part);
      Part across;
      if (near(part, image, reach)) across = common_hull(part, image, allowed);
      if (!across.hull.triangles.empty() && across.deviation <= allowed) {
        both.push_back(std::move(across));
      } else {
        both.push_back(std::move(part));
        both.push_back(std::move(image));
      }
    }
    return both;
  }

  /// Number of groups of touching pieces and their images.
  std::size_t groups() const {
    std::vector<std::vector<Part>> found;
    const auto add = [&](const Part& part) {
      std::vector<Part> group{part};
      std::erase_if(found, [&](std::vector<Part>& other) {
        const bool touches =
            std::any_of(other.begin(), other.end(), [&](const Part& p) { return near(p, part, settings_.tolerance); });
        if (touches) group.insert(group.end(), other.begin(), other.end());
        return touches;
      });
      found.push_back(std::move(group));
    };
    for (const auto& piece : pieces_) {
      if (piece.hull.triangles.empty()) continue;
      add(piece);
      if (port_only_) add(mirrored(piece));
    }
    return found.size();
  }

  static bool near(const Part& a, const Part& b, double reach) {
    return geometry::box_of(a.hull).exteriorDistance(geometry::box_of(b.hull)) <= reach;
  }

  struct Pair {
    std::size_t a, b;
    Part part;
  };

  void join_pairs(std::vector<Part>& parts, double allowed, double reach) const {
    std::vector<bool> gone(parts.size(), false);
    std::vector<Pair> pairs;
    const auto add_pairs = [&](const std::vector<std::pair<std::size_t, std::size_t>>& places) {
      std::vector<Part> made(places.size());
      parallel_pieces(std::ssize(places), settings_.threads, [&](std::ptrdiff_t n) {
        const auto k = static_cast<std::size_t>(n);
        made[k] = common_hull(parts[places[k].first], parts[places[k].second], allowed);
      });
      for (std::size_t k = 0; k < places.size(); ++k)
        if (made[k].deviation <= allowed) pairs.push_back({places[k].first, places[k].second, std::move(made[k])});
    };
    const auto neighbours = [&](std::size_t first, std::size_t last) {
      std::vector<std::pair<std::size_t, std::size_t>> places;
      for (std::size_t b = first; b < last; ++b)
        for (std::size_t a = 0; a < b; ++a)
          if (!gone[a] && near(parts[a], parts[b], reach)) places.emplace_back(a, b);
      return places;
    };
    add_pairs(neighbours(1, parts.size()));
    while (!pairs.empty()) {
      const auto best = std::min_element(
          pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.part.deviation < q.part.deviation; });
      const std::size_t a = best->a, b = best->b;
      parts.push_back(std::move(best->part));
      gone[a] = gone[b] = true;
      gone.push_back(false);
      std::erase_if(pairs, [&](const Pair& p) { return p.a == a || p.b == a || p.a == b || p.b == b; });
      add_pairs(neighbours(parts.size() - 1, parts.size()));
    }
    std::size_t k = 0;
    std::erase_if(parts, [&](const Part&) { return static_cast<bool>(gone[k++]); });
  }

  PartSettings settings_;
  SurfaceDistance mesh_;
  double skin_ = 0;
  double grid_ = 0;
  double diagonal_ = 0;  ///< diagonal of the box around the mesh [m]
  double target_ = 0;    ///< a found deviation up to this is within the tolerance [m]
  std::vector<Piece> pieces_;
  std::vector<PartCount> table_;
  bool port_only_ = false;
};

constexpr double k_measured = 0.05;  // share of the tolerance: precision of the measured result

}  // namespace

ConvexParts decompose(const geometry::TriangleMesh& mesh, const PartSettings& settings) {
  NILAS_DEMAND(settings.tolerance > 0 && settings.most > 0);
  return by_cgal("the mesh could not be cut into convex parts", [&] {
    Decomposition decomposition(mesh, settings);
    ConvexParts best;
    // The cutting only considers deviations outside the mesh: a narrow hollow may lie deeper below the pieces.
    constexpr int k_rounds = 3;
    for (int round = 0; round < k_rounds; ++round) {
      decomposition.split();
      ConvexParts found = decomposition.result();
      found.deviation = deviation_of(found.parts, mesh, k_measured * settings.tolerance);
      const bool good = found.deviation.largest <= settings.tolerance;
      if (round == 0 || found.deviation.largest < best.deviation.largest) best = std::move(found);
      if (good || !decomposition.tighten()) break;
    }
    add_count({best.parts.size(), best.deviation.largest}, best.table);
    return best;
  });
}

}  // namespace nilas::mesh
