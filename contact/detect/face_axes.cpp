#include "contact/detect/face_axes.h"

#include "contact/detect/axis_choice.h"

namespace nilas {

namespace {

/// Point of y, in y's frame, where n . x is largest.
Vec3 support_point(const Part& y, const Vec3& n) {
  if (y.facets) return y.facets->polytope->vertices[support_vertex(*y.facets, n)];
  return cylinder_support(y, n, 0).points[0];
}

/// The faces of x against y, x being A or B of the pair.
struct FaceSearch {
  const PairView& pair;
  AxisKind kind;

  bool of_a() const { return kind == AxisKind::face_a; }
  const Part& x() const { return of_a() ? pair.a : pair.b; }
  const Part& y() const { return of_a() ? pair.b : pair.a; }
  const RelativePose& y_in_x() const { return of_a() ? pair.b_in_a : pair.a_in_b; }
  Axis axis(int face, double s) const {
    const Vec3& n = x().facets->polytope->normals[face];
    if (of_a()) return {n, s, kind, face, -1};
    return {-(pair.b_in_a.R * n), s, kind, -1, face};
  }
};

/// Cutting planes: every point of y bounds the separation along each face normal of x from above, so most faces are never
/// tried. The bounds start from the ball inside y; each face that is tried adds the point of y nearest to its plane.
template <class Bounds>
void search_faces(const FaceSearch& search, double enough, Axis& best) {
  const FacetedGeometry& facets = *search.x().facets;
  const RelativePose& y_in_x = search.y_in_x();
  const auto heights = [&facets](const Vec3& p) {
    return facets.normals.col(0) * p.x() + facets.normals.col(1) * p.y() + facets.normals.col(2) * p.z() -
           facets.offsets;
  };
  Bounds bound = heights(y_in_x.point(search.y().centre)) - search.y().inner_radius;
  for (;;) {
    Eigen::Index f = 0;
    if (bound.maxCoeff(&f) < best.s - search.pair.tolerance) return;
    const Vec3& n = facets.polytope->normals[f];
    const Vec3 nearest = y_in_x.point(support_point(search.y(), -(y_in_x.R.transpose() * n)));
    const Axis axis = search.axis(static_cast<int>(f), n.dot(nearest) - facets.offsets[f]);
    if (beats(search.pair, axis.n, axis.s, best)) best = axis;
    if (best.s > enough) return;
    bound = bound.min(heights(nearest));
    bound[f] = -std::numeric_limits<double>::infinity();
  }
}

void search_faces_of(const PairView& pair, AxisKind kind, double enough, Axis& best) {
  constexpr int k_on_stack = 32;
  using Few = Eigen::Array<double, Eigen::Dynamic, 1, 0, k_on_stack, 1>;
  const FaceSearch search{pair, kind};
  if (!search.x().facets) return;
  if (search.x().facets->normals.rows() <= k_on_stack)
    search_faces<Few>(search, enough, best);
  else
    search_faces<Eigen::ArrayXd>(search, enough, best);
}

}  // namespace

Axis best_face_axis(const PairView& pair, double enough) {
  Axis best;
  search_faces_of(pair, AxisKind::face_a, enough, best);
  if (best.s <= enough) search_faces_of(pair, AxisKind::face_b, enough, best);
  return best;
}

}  // namespace nilas
