#include "contact/detect/surface/face_axes.h"

#include <algorithm>
#include <vector>

#include "contact/detect/surface/axis_choice.h"

namespace nilas::detect {

namespace {

/// Returns the point of y, in y's frame, where n . x is largest.
Vec3 support_point(const Part& y, const Vec3& n) {
  // the columns of all vertices have just been read, unlike the list of points
  if (y.facets) return y.facets->vertex(support_vertex(*y.facets, n));
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
    const Vec3 n = x().facets->normal(face);
    if (of_a()) return {n, s, kind, face, -1};
    return {-(pair.b_in_a.R * n), s, kind, -1, face};
  }
};

/// Returns the heights of a point over all faces.
auto heights_of(const FacetedGeometry& facets, const Vec3& p) {
  return facets.normals.col(0) * p.x() + facets.normals.col(1) * p.y() + facets.normals.col(2) * p.z() - facets.offsets;
}

/// A face's axis, and the point of y nearest to its plane, in x's frame.
struct FaceTry {
  Axis axis;
  Vec3 nearest;
};

FaceTry try_face(const FaceSearch& search, int f) {
  const FacetedGeometry& facets = *search.x().facets;
  const RelativePose& y_in_x = search.y_in_x();
  const Vec3 n = facets.normal(f);
  const Vec3 nearest = y_in_x.point(support_point(search.y(), -(y_in_x.R.transpose() * n)));
  return {search.axis(f, n.dot(nearest) - facets.offsets[f]), nearest};
}

Vec3 enter_face(const FaceSearch& search, int f, AxisContest& contest) {
  const FaceTry tried = try_face(search, f);
  contest.enter(tried.axis);
  return tried.nearest;
}

// Cutting planes: every point of y bounds the separation along each face normal of x from above, so most faces are
// never tried. The bounds start from the ball inside y; each face that is tried adds the point of y nearest to its
// plane.

constexpr int k_few_faces = 32;

/// Bounds that a search stops at.
struct Bounds {
  double enough;  ///< no better axis is needed [m]
  double least;   ///< some face of either part separates by as much [m]
};

void search_few_faces(const FaceSearch& search, const Bounds& bounds, AxisContest& contest) {
  const FacetedGeometry& facets = *search.x().facets;
  Eigen::Array<double, Eigen::Dynamic, 1, 0, k_few_faces, 1> bound =
      heights_of(facets, search.y_in_x().point(search.y().centre)) - search.y().inner_radius;
  for (;;) {
    Eigen::Index f = 0;
    if (!(bound.maxCoeff(&f) >= std::max(contest.highest(), bounds.least) - search.pair.tolerance)) return;
    const Vec3 nearest = enter_face(search, static_cast<int>(f), contest);
    if (contest.highest() > bounds.enough) return;
    bound = bound.min(heights_of(facets, nearest));
    bound[f] = -std::numeric_limits<double>::infinity();
  }
}

/// Searches many faces like search_few_faces, with a list of the faces still in question.
void search_many_faces(const FaceSearch& search, const Bounds& bounds, AxisContest& contest) {
  const FacetedGeometry& facets = *search.x().facets;
  Eigen::ArrayXd bound = heights_of(facets, search.y_in_x().point(search.y().centre)) - search.y().inner_radius;
  Eigen::Index first = 0;
  if (!(bound.maxCoeff(&first) >= std::max(contest.highest(), bounds.least) - search.pair.tolerance)) return;
  bound = bound.min(heights_of(facets, enter_face(search, static_cast<int>(first), contest)));
  std::vector<int> open;
  const auto in_question = [&](int f) {
    return bound[f] >= std::max(contest.highest(), bounds.least) - search.pair.tolerance;
  };
  for (int f = 0; f < static_cast<int>(bound.size()); ++f)
    if (f != first && in_question(f)) open.push_back(f);
  while (!open.empty() && contest.highest() <= bounds.enough) {
    const auto highest = std::max_element(open.begin(), open.end(), [&](int f, int g) { return bound[f] < bound[g]; });
    const int f = *highest;
    open.erase(highest);
    const Vec3 nearest = enter_face(search, f, contest);
    std::erase_if(open, [&](int g) {
      bound[g] = std::min(bound[g], facets.normal(g).dot(nearest) - facets.offsets[g]);
      return !in_question(g);
    });
  }
}

void search_faces(const PairView& pair, AxisKind kind, const Bounds& bounds, AxisContest& contest) {
  const FaceSearch search{pair, kind};
  if (!search.x().facets || contest.highest() > bounds.enough) return;
  if (has_few_faces(search.x()))
    search_few_faces(search, bounds, contest);
  else
    search_many_faces(search, bounds, contest);
}

}  // namespace

bool has_few_faces(const Part& part) { return part.facets && part.facets->normals.rows() <= k_few_faces; }

Axis face_axis(const PairView& pair, AxisKind kind, int face) { return try_face({pair, kind}, face).axis; }

Axis best_face_axis(const PairView& pair, double enough, std::vector<Axis>& room, double least) {
  AxisContest contest(pair, room);
  // The fewer faces first: they leave few of the many in question.
  const auto count = [](const Part& part) { return part.facets ? part.facets->normals.rows() : Eigen::Index{0}; };
  const bool a_first = count(pair.a) <= count(pair.b);
  search_faces(pair, a_first ? AxisKind::face_a : AxisKind::face_b, {enough, least}, contest);
  search_faces(pair, a_first ? AxisKind::face_b : AxisKind::face_a, {enough, least}, contest);
  return contest.winner();
}

}  // namespace nilas::detect
