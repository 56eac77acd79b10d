#include "core/mesh/decompose.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/bodies/mesh_box.h"
#include "core/mesh/pieces.h"
#include "core/mesh/surface_distance.h"

namespace nilas {

namespace {

/// Convex hull of a piece, or of several.
struct Part {
  TriangleMesh hull;
  std::vector<Plane> cuts;  ///< planes that bound it
  double deviation = 0;     ///< largest that was found of the hull outside the whole mesh [m]
};

/// A piece of the solid with its convex hull.
struct Piece : Part {
  SurfaceMesh solid;
  bool whole = false;  ///< no plane found that cuts it
};

/// Hull over coordinates as STL stores them, so that what is written is convex exactly.
TriangleMesh stored_hull(const std::vector<Vec3>& points) {
  std::vector<Kernel::Point_3> rounded;
  for (const auto& p : rounded_to_float({points, {}}).vertices) rounded.push_back(to_point(p));
  return triangles_of(convex_hull(rounded));
}

Part mirrored(Part part) {
  for (auto& p : part.hull.vertices) p.y() = 0.0 - p.y();
  for (auto& t : part.hull.triangles) std::swap(t[1], t[2]);
  for (auto& cut : part.cuts) cut = Plane(cut.a(), -cut.b(), cut.c(), cut.d());
  return part;
}

std::vector<TriangleMesh> hulls_of(std::vector<Part> parts) {
  std::vector<TriangleMesh> hulls;
  for (auto& part : parts) hulls.push_back(std::move(part.hull));
  return hulls;
}

double twice_area(const Corners& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm(); }

/// Rows that the new one betters in both go.
void add_count(const PartCount& row, std::vector<PartCount>& table) {
  std::erase_if(table, [&](const PartCount& old) { return old.parts >= row.parts && old.deviation >= row.deviation; });
  table.push_back(row);
}

class Decomposition {
 public:
  Decomposition(const TriangleMesh& mesh, const PartSettings& settings) : settings_(settings), mesh_(corners_of(mesh)) {
    const auto box = box_of(mesh);
    skin_ = k_skin * box.sizes().maxCoeff();
    diagonal_ = box.diagonal().norm();
    target_ = settings.tolerance / (1 + k_slack + k_precision);
    pieces_.push_back(made(surface_of(mesh), {}));
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

  /// Asks for a smaller share of what was asked for before, until there is something to cut; false where there is not.
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

  /// As many as allowed, whatever they then deviate.
  ConvexParts result() const {
    constexpr double k_more = 1.5;
    double allowed = std::max(worst(), target_);
    // neighbours alone will not do where more groups lie apart than parts are allowed
    const bool apart = groups() > settings_.most;
    const auto joined_within = [&] {
      return joined(allowed, apart ? std::max(allowed, settings_.tolerance) : settings_.tolerance);
    };
    std::vector<Part> parts = joined_within();
    // no hull stands further out than the mesh is wide: then all are one
    while (parts.size() > settings_.most && allowed < diagonal_) {
      allowed *= k_more;
      parts = joined_within();
    }
    if (parts.size() > settings_.most)
      throw InputError(fmt::format("{} convex parts could not be joined; allowed: {}", parts.size(), settings_.most));
    return {hulls_of(std::move(parts)), {}, table_};
  }

 private:
  static constexpr double k_slack = 0.1, k_precision = 0.1;  // of what is found, and of what is allowed
  static constexpr std::size_t k_pieces_per_part = 4;        // before they are joined, at most
  static constexpr double k_skin = 1e-6;                     // of the size: what rounding moves

  /// What is found up to `allowed` is at most (1 + k_slack + k_precision) allowed; above `ceiling` nothing more is
  /// sought.
  double deviation(const Part& part, double allowed, double ceiling = std::numeric_limits<double>::infinity()) const {
    std::vector<Corners> faces = corners_of(part.hull);
    const DistanceSearch search{.precision = k_precision * allowed,
                                .outside_only = true,
                                .floor = (1 + k_slack) * allowed,
                                .slack = k_slack,
                                .ceiling = ceiling};
    // what bridges a hollow is large, and most hulls of two parts are turned down for it
    constexpr std::size_t k_large = 16;
    const std::size_t large = std::min(k_large, faces.size());
    std::partial_sort(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(large), faces.end(),
                      [](const Corners& f, const Corners& g) { return twice_area(f) > twice_area(g); });
    const std::vector<Corners> first(faces.begin(), faces.begin() + static_cast<std::ptrdiff_t>(large));
    const double bridged = mesh_.largest(mesh_.without_shared_faces(first, skin_), search).largest;
    if (bridged > ceiling) return bridged;
    return mesh_.largest(mesh_.without_shared_faces(faces, skin_), search).largest;
  }
  Piece made(SurfaceMesh solid, std::vector<Plane> cuts,
             double ceiling = std::numeric_limits<double>::infinity()) const {
    Piece piece;
    std::vector<Vec3> points;
    for (const auto& p : points_of(solid)) points.push_back(to_vec(p));
    piece.hull = stored_hull(points);
    piece.cuts = std::move(cuts);
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
  /// pieces_.size() where none that deviates can be cut.
  std::size_t worst_piece() const {
    std::size_t found = pieces_.size();
    for (std::size_t k = 0; k < pieces_.size(); ++k)
      if (!pieces_[k].whole && pieces_[k].deviation > target_ &&
          (found == pieces_.size() || pieces_[k].deviation > pieces_[found].deviation))
        found = k;
    return found;
  }

  void keep_port_half() {
    const Plane centre(0, -1, 0, 0);
    if (!can_be_cut(pieces_.front().solid)) return;
    auto half = below(pieces_.front().solid, centre);
    if (half.empty()) return;
    pieces_.clear();
    for (auto& solid : half) pieces_.push_back(made(std::move(solid), {centre}));
    port_only_ = true;
  }

  /// Of the cuts that leave least volume the one after which the worst side deviates least.
  void split_piece(std::size_t k) {
    constexpr std::size_t k_tried = 4;
    std::vector<Piece> best;
    std::pair<double, double> best_merit{std::numeric_limits<double>::infinity(), 0};
    std::vector<Plane> planes;
    if (can_be_cut(pieces_[k].solid)) planes = promising_cuts(pieces_[k].solid, k_tried);
    for (const auto& plane : planes) {
      std::vector<Piece> sides;
      std::pair<double, double> merit{0, 0};
      auto cuts = pieces_[k].cuts;
      cuts.push_back(plane);
      for (auto& solid : cut(pieces_[k].solid, plane)) {
        sides.push_back(made(std::move(solid), cuts, best_merit.first));
        merit.first = std::max(merit.first, sides.back().deviation);
        merit.second += sides.back().deviation;
      }
      if (sides.size() < 2 || merit >= best_merit) continue;
      best_merit = merit;
      best = std::move(sides);
    }
    if (best.empty()) {
      pieces_[k].whole = true;
      return;
    }
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(k));
    for (auto& side : best) pieces_.push_back(std::move(side));
  }

  void note_count() { add_count({count(), (1 + k_slack) * worst() + k_precision * target_}, table_); }

  /// Its deviation is known once it is above `allowed`, no further.
  Part common_hull(const Part& a, const Part& b, double allowed) const {
    std::vector<Vec3> points = a.hull.vertices;
    points.insert(points.end(), b.hull.vertices.begin(), b.hull.vertices.end());
    Part both{stored_hull(points), a.cuts, 0};
    both.cuts.insert(both.cuts.end(), b.cuts.begin(), b.cuts.end());
    both.deviation = deviation(both, allowed, allowed);
    return both;
  }

  /// Pairs within `reach` joined, the least deviating first, while their hull stays within `allowed`; then both halves.
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

  /// Groups of pieces and images that touch.
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
    return box_of(a.hull).exteriorDistance(box_of(b.hull)) <= reach;
  }

  struct Pair {
    std::size_t a, b;
    Part part;
  };

  void join_pairs(std::vector<Part>& parts, double allowed, double reach) const {
    std::vector<bool> gone(parts.size(), false);
    std::vector<Pair> pairs;
    const auto add_pairs = [&](std::size_t b) {
      for (std::size_t a = 0; a < b; ++a) {
        if (gone[a] || !near(parts[a], parts[b], reach)) continue;
        Part part = common_hull(parts[a], parts[b], allowed);
        if (part.deviation <= allowed) pairs.push_back({a, b, std::move(part)});
      }
    };
    for (std::size_t b = 1; b < parts.size(); ++b) add_pairs(b);
    while (!pairs.empty()) {
      const auto best = std::min_element(
          pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.part.deviation < q.part.deviation; });
      const std::size_t a = best->a, b = best->b;
      parts.push_back(std::move(best->part));
      gone[a] = gone[b] = true;
      gone.push_back(false);
      std::erase_if(pairs, [&](const Pair& p) { return p.a == a || p.b == a || p.a == b || p.b == b; });
      add_pairs(parts.size() - 1);
    }
    std::size_t k = 0;
    std::erase_if(parts, [&](const Part&) { return static_cast<bool>(gone[k++]); });
  }

  PartSettings settings_;
  SurfaceDistance mesh_;
  double skin_ = 0;
  double diagonal_ = 0;  ///< of the box around the mesh [m]
  double target_ = 0;    ///< what is found to deviate no more is within the tolerance [m]
  std::vector<Piece> pieces_;
  std::vector<PartCount> table_;
  bool port_only_ = false;
};

constexpr double k_measured = 0.05;  // of the tolerance: how exactly the result is measured

}  // namespace

ConvexParts decompose(const TriangleMesh& mesh, const PartSettings& settings) {
  NILAS_DEMAND(settings.tolerance > 0 && settings.most > 0);
  return by_cgal("the mesh could not be cut into convex parts", [&] {
    Decomposition decomposition(mesh, settings);
    ConvexParts best;
    // while cutting, only what stands outside the mesh is looked at: a narrow hollow may lie deeper below the parts
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

}  // namespace nilas
