#include "core/hull/hull_measures.h"

#include <cmath>
#include <limits>

#include "core/geometry/mesh_box.h"

namespace nilas::hull {

namespace {

constexpr int k_lines = 64;          // along each side of a view
constexpr double k_near_end = 0.05;  // of the length

/// Where lines along an axis enter the solid first and leave it last, from the near side of the box [m].
struct View {
  std::vector<double> first, last;  ///< line i of the axis after, j of the one after that: at i * k_lines + j

  View() : first(k_lines * k_lines, std::numeric_limits<double>::infinity()), last(k_lines * k_lines, -first[0]) {}
  bool hits(int i, int j) const { return first[place(i, j)] <= last[place(i, j)]; }
  static std::size_t place(int i, int j) { return static_cast<std::size_t>(i * k_lines + j); }
  void meet(int i, int j, double at) {
    first[place(i, j)] = std::min(first[place(i, j)], at);
    last[place(i, j)] = std::max(last[place(i, j)], at);
  }
};

/// Numbers of the lines between two coordinates, as shares of the extent.
std::pair<int, int> lines_between(double low, double high) {
  return {std::max(0, static_cast<int>(std::ceil(low * k_lines - 0.5))),
          std::min(k_lines - 1, static_cast<int>(std::floor(high * k_lines - 0.5)))};
}

/// Lines through the middles of the squares of a grid over the box.
View view_along(const geometry::TriangleMesh& mesh, const Eigen::AlignedBox3d& box, int axis) {
  View view;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 x = mesh.vertices[t[k]] - box.min();
      p[k] = {x[u] / box.sizes()[u], x[v] / box.sizes()[v], x[axis]};
    }
    const Vec3 ab = p[1] - p[0], ac = p[2] - p[0];
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0) continue;
    const auto [i0, i1] =
        lines_between(std::min({p[0].x(), p[1].x(), p[2].x()}), std::max({p[0].x(), p[1].x(), p[2].x()}));
    const auto [j0, j1] =
        lines_between(std::min({p[0].y(), p[1].y(), p[2].y()}), std::max({p[0].y(), p[1].y(), p[2].y()}));
    for (int i = i0; i <= i1; ++i)
      for (int j = j0; j <= j1; ++j) {
        const double x = (i + 0.5) / k_lines - p[0].x(), y = (j + 0.5) / k_lines - p[0].y();
        const double b = (x * ac.y() - y * ac.x()) / area, c = (ab.x() * y - ab.y() * x) / area;
        constexpr double k_rim = 1e-9;  // a line through an edge meets both its triangles
        if (b >= -k_rim && c >= -k_rim && b + c <= 1 + k_rim) view.meet(i, j, p[0].z() + b * ab.z() + c * ac.z());
      }
  }
  return view;
}

double lopsided(const View& view, double extent) {
  std::vector<double> middles;
  double mean = 0, off = 0;
  for (std::size_t k = 0; k < view.first.size(); ++k)
    if (view.first[k] <= view.last[k]) middles.push_back(0.5 * (view.first[k] + view.last[k]));
  if (middles.empty()) return 0;
  const auto count = static_cast<double>(middles.size());
  for (const double m : middles) mean += m / count;
  for (const double m : middles) off += std::abs(m - mean) / count;
  return off / extent;
}

/// Breadth in plan at line i, from the outermost hit on one side to that on the other, as a share of the box.
double breadth(const View& plan, int i) {
  int low = k_lines, high = -1;
  for (int j = 0; j < k_lines; ++j)
    if (plan.hits(i, j)) {
      low = std::min(low, j);
      high = j;
    }
  return high < low ? 0 : static_cast<double>(high - low + 1) / k_lines;
}

void measure_plan(const View& plan, HullMeasures& m) {
  constexpr int k_further = static_cast<int>(k_near_end * k_lines);
  m.broad_fore = breadth(plan, k_lines - 1);
  m.broad_aft = breadth(plan, 0);
  const double fore = breadth(plan, k_lines - 1 - k_further), aft = breadth(plan, k_further);
  m.square_fore = fore > 0 ? m.broad_fore / fore : 0;
  m.square_aft = aft > 0 ? m.broad_aft / aft : 0;
}

void measure_end_view(const View& ends, HullMeasures& m) {
  const double near = k_near_end * m.size().x();
  double all = 0, fore = 0, aft = 0;
  for (std::size_t k = 0; k < ends.first.size(); ++k) {
    if (ends.first[k] > ends.last[k]) continue;
    ++all;
    if (m.size().x() - ends.last[k] < near) ++fore;
    if (ends.first[k] < near) ++aft;
  }
  if (all == 0) return;
  m.full_fore = fore / all;
  m.full_aft = aft / all;
}

/// Share of the area seen from one side that meets a condition.
struct SeenShare {
  double all = 0, met = 0;
  void add(double area, bool meets) {
    if (area <= 0) return;
    all += area;
    if (meets) met += area;
  }
  double share() const { return all > 0 ? met / all : 0; }
};

}  // namespace

HullMeasures measure_hull(const geometry::TriangleMesh& mesh) {
  HullMeasures m;
  Eigen::AlignedBox3d box;
  SeenShare top, bottom;
  const double level = std::cos(15 * k_deg);
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) box.extend(p[k] = mesh.vertices[t[k]]);
    const Vec3 area = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]);
    const double size = area.norm();
    top.add(area.z(), area.z() > level * size);
    bottom.add(-area.z(), -area.z() > level * size);
  }
  m.low = box.min();
  m.high = box.max();
  m.flat_top = top.share();
  m.flat_bottom = bottom.share();
  for (int axis = 0; axis < 3; ++axis) {
    const View view = view_along(mesh, box, axis);
    m.lopsided[axis] = lopsided(view, box.sizes()[axis]);
    if (axis == 0) measure_end_view(view, m);
    if (axis == 2) measure_plan(view, m);
  }
  return m;
}

}  // namespace nilas::hull
