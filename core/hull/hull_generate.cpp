/// Surfaces through the waterlines: the fine fluid mesh and the coarse convex part over the same planes.
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/hull/hull.h"
#include "core/hull/hull_lines.h"

namespace nilas::hull {

namespace {

/// Grid of points port side, one row per height; starboard is its image. Centre-plane points are shared.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(const std::vector<Waterline>& lines, const std::vector<double>& heights) : lines_(lines) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      std::vector<int> port, starboard, centre;
      for (const auto& p : lines[k]) {
        const bool middle = p.y() == 0;
        port.push_back(add({p.x(), p.y(), heights[k]}));
        starboard.push_back(middle ? port.back() : add({p.x(), -p.y(), heights[k]}));
      }
      port_.push_back(port);
      starboard_.push_back(starboard);
    }
    sides();
    cap(0, heights.front(), false);
    cap(lines.size() - 1, heights.back(), true);
  }
  geometry::TriangleMesh take() { return geometry::rounded_to_float(std::move(mesh_)); }

 private:
  int add(const Vec3& p) {
    mesh_.vertices.push_back(p);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }
  /// A triangle on the port side and its image.
  void pair(const std::array<int, 3>& port, const std::array<int, 3>& starboard) {
    mesh_.triangles.push_back(port);
    mesh_.triangles.push_back({starboard[0], starboard[2], starboard[1]});
  }
  void sides() {
    for (std::size_t k = 0; k + 1 < lines_.size(); ++k)
      for (std::size_t i = 0; i + 1 < lines_[k].size(); ++i) {
        const auto &p = port_[k], &q = port_[k + 1], &s = starboard_[k], &t = starboard_[k + 1];
        // the line runs forward with the outside to port
        pair({p[i], q[i], q[i + 1]}, {s[i], t[i], t[i + 1]});
        pair({p[i], q[i + 1], p[i + 1]}, {s[i], t[i + 1], s[i + 1]});
      }
  }
  /// Flat bottom or deck: strips between the side and the centre line, at the side's stations.
  void cap(std::size_t row, double z, bool up) {
    const auto &p = port_[row], &s = starboard_[row];
    const std::size_t n = p.size();
    // the transom's corner stands at the abscissa of its centre, so the centre line starts there
    std::vector<int> centre{p[0], p[0]};
    for (std::size_t i = 2; i + 1 < n; ++i) centre.push_back(add({lines_[row][i].x(), 0, z}));
    centre.push_back(p[n - 1]);
    const auto both = [&](int a, int b, int c, int sa, int sb, int sc) {
      if (up)
        pair({a, b, c}, {sa, sb, sc});
      else
        pair({a, c, b}, {sa, sc, sb});
    };
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const int c0 = centre[i], c1 = centre[i + 1];
      both(c0, c1, p[i], c0, c1, s[i]);
      if (i + 2 < n) both(c1, p[i + 1], p[i], c1, s[i + 1], s[i]);
    }
  }

  const std::vector<Waterline>& lines_;
  std::vector<std::vector<int>> port_, starboard_;
  geometry::TriangleMesh mesh_;
};

geometry::TriangleMesh surface(const HullForm& form, const HullFineness& fineness) {
  const auto heights = waterline_heights(form, fineness);
  std::vector<Waterline> lines;
  for (const double z : heights) lines.push_back(waterline(form, fineness, z));
  return SurfaceBuilder(lines, heights).take();
}

/// Triangles of surface(): four per cell of the sides, and both caps.
struct Count {
  explicit Count(const HullForm& form, const HullFineness& n)
      : rows(n.side + (form.kind == HullKind::wedge ? 0 : n.bilge)),
        points((form.kind == HullKind::wedge ? 2 : n.stern + 2) + n.middle + n.bow) {}
  int rows, points;  ///< bands between waterlines; points of a waterline
  int triangles() const { return 4 * rows * (points - 1) + 4 * (2 * (points - 2) - 1); }
};

/// Bow, run and bilge are cut in proportion to the wanted fineness; then of all numbers of rows the one nearest to that
/// proportion for which some cut of the parallel body meets the wanted count.
HullFineness fineness_for(const HullForm& form) {
  const double scale = std::sqrt(form.triangles / 6000.0);
  constexpr double k_bow = 26, k_stern = 14, k_bilge = 6, k_side = 16;  // of a mesh of about 6000
  constexpr double k_close = 0.02;  // of the wanted count, well within the 5 % promised
  const auto scaled = [&](double x, int least) { return std::max(least, static_cast<int>(std::lround(x * scale))); };
  HullFineness n{scaled(k_bow, 2), 1, scaled(k_stern, 2), scaled(k_bilge, 2), 1};
  HullFineness best = n;
  double best_merit = std::numeric_limits<double>::infinity();
  const int wanted_side = scaled(k_side, 1);
  for (n.side = 1; n.side <= 4 * wanted_side; ++n.side) {
    n.middle = 1;
    const Count least(form, n);
    n.middle += std::max(0, (form.triangles - least.triangles()) / (4 * least.rows + 8));
    for (int more = 0; more < 2; ++more, ++n.middle) {
      const double error = std::abs(Count(form, n).triangles() - form.triangles) / static_cast<double>(form.triangles);
      const double merit =
          std::abs(n.side - wanted_side) / static_cast<double>(wanted_side) + (error > k_close ? 1e3 * error : 0);
      if (merit >= best_merit) continue;
      best_merit = merit;
      best = n;
    }
  }
  return best;
}

}  // namespace

Hull generate_hull(const HullForm& form) {
  demand_sensible(form);
  HullFineness fine = fineness_for(form);
  Hull hull;
  hull.fluid = surface(form, fine);
  // contact needs the planes only: the straight side and the rows above the bilge are one strip each
  HullFineness coarse = fine;
  coarse.middle = 1;
  coarse.side = 1;
  if (form.kind == HullKind::wedge) coarse.bow = 1;
  hull.parts.push_back(surface(form, coarse));
  return hull;
}

}  // namespace nilas::hull
