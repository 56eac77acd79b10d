#include "core/field/sizes/floe_texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/geometry/polygon.h"

namespace nilas::field {

namespace {

struct Triangle {
  Vec2 a, b, c;
};

double area_of(const Triangle& t) {
  const Vec2 u = t.b - t.a, v = t.c - t.a;
  return 0.5 * (u.x() * v.y() - u.y() * v.x());
}

/// Mean of `value` over a triangle, by Radon's seven points.
template <class Value>
double mean_over_triangle(const Triangle& t, const Value& value) {
  struct Orbit {
    double weight, corner;  ///< weight of each of three points, and barycentric coordinate of its corner
  };
  static const double root = std::sqrt(15.0);
  static const std::array<Orbit, 2> orbits{
      {{(155 - root) / 1200, (9 + 2 * root) / 21}, {(155 + root) / 1200, (9 - 2 * root) / 21}}};
  constexpr double k_centre_weight = 9.0 / 40;
  double sum = k_centre_weight * value((t.a + t.b + t.c) / 3);
  for (const auto& [weight, corner] : orbits) {
    const double other = 0.5 * (1 - corner);
    const Vec2 all = other * (t.a + t.b + t.c);
    for (const Vec2& p : {t.a, t.b, t.c}) sum += weight * value(all + (corner - other) * p);
  }
  return sum;
}

/// Calls visit(triangle) for the count^2 equal triangles into which lines parallel to its sides cut `t`.
template <class Visit>
void visit_parts(const Triangle& t, int count, const Visit& visit) {
  const Vec2 u = (t.b - t.a) / count, v = (t.c - t.a) / count;
  for (int i = 0; i < count; ++i)
    for (int j = 0; i + j < count; ++j) {
      const Vec2 p = t.a + i * u + j * v;
      visit(Triangle{p, p + u, p + v});
      if (i + j + 1 < count) visit(Triangle{p + u + v, p + v, p + u});
    }
}

}  // namespace

double PropertyPlane::at(const Vec2& x_G) const {
  double score = 0;
  for (std::size_t k = 0; k < fields.size(); ++k) score += weights[k] * fields[k]->at(x_G);
  return distribution.at_score(score);
}

double PropertyPlane::shortest_length() const {
  double shortest = fields.front()->length();
  for (const auto& field : fields) shortest = std::min(shortest, field->length());
  return shortest;
}

double FloeTexture::mean_over(const std::vector<Vec2>& outline) const {
  constexpr double k_side = 1.5;  // correlation lengths
  const double side = k_side * plane_->shortest_length();
  double area = 0, sum = 0;
  const auto value = [&](const Vec2& x) { return at(x.x(), x.y()); };
  for (const auto& piece : geometry::convex_pieces(outline))
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
      const Triangle t{piece[0], piece[k], piece[k + 1]};
      const double longest = std::max({(t.b - t.a).norm(), (t.c - t.b).norm(), (t.a - t.c).norm()});
      const int count = static_cast<int>(std::ceil(longest / side));
      const double part = area_of(t) / (count * count);
      visit_parts(t, std::max(count, 1),
                  [&](const Triangle& small) { sum += part * mean_over_triangle(small, value); });
      area += area_of(t);
    }
  return sum / area;
}

}  // namespace nilas::field
