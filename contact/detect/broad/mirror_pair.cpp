#include "contact/detect/broad/mirror_pair.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace nilas::detect {

namespace {

using Vertices = std::vector<std::tuple<double, double, double>>;

/// Returns the vertices with y times `sign`, sorted by coordinates.
Vertices sorted_vertices(const Part& part, double sign) {
  Vertices out;
  for (const Vec3& x : part.facets->polytope->vertices) out.emplace_back(x.x(), sign * x.y() + 0.0, x.z());
  std::sort(out.begin(), out.end());
  return out;
}

/// Share of the smaller part's size, and angle, within which poses count as images [-, rad]. Rounding and the solver's
/// tolerance change a mirrored scene by far less. Such a turn of the normal is too small to matter.
constexpr double k_same = 1e-6;

bool poses_are_images(const bodies::Bodies& bodies, const Part& a, const Part& b) {
  const auto i = static_cast<std::size_t>(a.body), k = static_cast<std::size_t>(b.body);
  const Vec3 signs(1, -1, 1);
  const double length = k_same * std::min(a.bounding_radius, b.bounding_radius);
  if ((bodies.p_GB[i] - signs.cwiseProduct(bodies.p_GB[k])).cwiseAbs().maxCoeff() > length) return false;
  const Mat3 image = signs.asDiagonal() * bodies.R_GB[k] * signs.asDiagonal();
  return (bodies.R_GB[i] - image).cwiseAbs().maxCoeff() <= k_same;
}

}  // namespace

bool are_images(const bodies::Bodies& bodies, const Part& a, const Part& b) {
  if (!a.facets || !b.facets || a.cover || b.cover || !poses_are_images(bodies, a, b)) return false;
  const auto count = [](const Part& part) { return part.facets->polytope->vertices.size(); };
  return count(a) == count(b) && sorted_vertices(a, 1) == sorted_vertices(b, -1);
}

Axis axis_across(const bodies::Bodies& bodies, const PairView& pair) {
  const double toward_b = bodies.p_GB[pair.b.body].y() < 0 ? -1 : 1;
  Axis axis;
  axis.n = bodies.R_GB[pair.a.body].transpose() * Vec3(0, toward_b, 0);
  axis.s = separation(pair, axis.n);
  return axis;
}

double middle_plane(const bodies::Bodies& bodies, const Part& a, const Part& b) {
  return 0.5 * (bodies.p_GB[a.body].y() + bodies.p_GB[b.body].y());
}

bool serves_instead(const Axis& across, const Axis& best) {
  constexpr double k_most_overlap = 2;  // multiple of the least overlap
  return across.s >= k_most_overlap * std::min(best.s, 0.0);
}

}  // namespace nilas::detect
