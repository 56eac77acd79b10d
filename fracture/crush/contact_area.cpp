#include "fracture/crush/contact_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace nilas::fracture {

namespace {

using Loop = std::vector<Vec3>;

/// Heights above a plane below this share of the size are rounding [-].
constexpr double k_rounding = 1e-13;
/// Areas below this share of the square of the piece's radius are rounding [-].
constexpr double k_least_area = 1e-20;

/// Area, centroid and second moments of a convex loop with normal n.
struct Moments {
  double area = 0;
  Vec3 centroid = Vec3::Zero();
  Mat3 spread = Mat3::Zero();
};

Moments moments(const Loop& loop, const Vec3& n) {
  Vec3 origin = Vec3::Zero();
  for (const Vec3& x : loop) origin += x;
  origin /= static_cast<double>(loop.size());
  Moments m;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 p = loop[k] - origin, q = loop[(k + 1) % loop.size()] - origin;
    const double area = 0.5 * n.dot(p.cross(q));
    m.area += area;
    first += area / 3 * (p + q);
    second += area / 12 * ((p + q) * (p + q).transpose() + p * p.transpose() + q * q.transpose());
  }
  if (!(m.area > 0)) return {};
  const Vec3 offset = first / m.area;
  m.centroid = origin + offset;
  m.spread = second / m.area - offset * offset.transpose();
  return m;
}

/// Cuts off the part of a convex loop above the plane n . x = offset.
void clip(const Vec3& n, double offset, Loop& loop, Loop& room) {
  room.clear();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 &p = loop[k], &q = loop[(k + 1) % loop.size()];
    const double at_p = n.dot(p) - offset, at_q = n.dot(q) - offset;
    if (at_p <= 0) room.push_back(p);
    if ((at_p <= 0) != (at_q <= 0)) room.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  loop.swap(room);
}

/// Whether a loop lies in the plane and has the same normal. Then no part of the solid below the plane is in front of
/// it.
bool lies_in(const Loop& loop, const Vec3& normal, const Vec3& n, double offset, double rounding) {
  return n.dot(normal) > 0 &&
         std::all_of(loop.begin(), loop.end(), [&](const Vec3& x) { return std::abs(n.dot(x) - offset) <= rounding; });
}

/// Cuts the loop, given in the solid's frame with its normal, down to its part inside the solid.
void clip_by(const geometry::ConvexPolytope& solid, const Vec3& normal, double rounding, Loop& loop, Loop& room) {
  for (std::size_t f = 0; f < solid.normals.size() && loop.size() >= 3; ++f) {
    if (lies_in(loop, normal, solid.normals[f], solid.offsets[f], rounding)) loop.clear();
    clip(solid.normals[f], solid.offsets[f], loop, room);
  }
}

}  // namespace

HullFace make_hull_face(int part, std::vector<Vec3> loop) {
  NILAS_DEMAND(loop.size() >= 3);
  HullFace face;
  face.part = part;
  for (const Vec3& x : loop) face.centre += x / static_cast<double>(loop.size());
  Vec3 twice = Vec3::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k)
    twice += (loop[k] - face.centre).cross(loop[(k + 1) % loop.size()] - face.centre);
  face.normal = twice.normalized();
  for (const Vec3& x : loop) face.radius = std::max(face.radius, (x - face.centre).norm());
  face.loop = std::move(loop);
  return face;
}

/// Whether a ball lies outside one of the solid's planes.
static bool misses(const geometry::ConvexPolytope& solid, const Vec3& centre, double radius) {
  for (std::size_t f = 0; f < solid.normals.size(); ++f)
    if (solid.normals[f].dot(centre) - solid.offsets[f] > radius) return true;
  return false;
}

std::optional<FaceInIce> face_in_ice(const HullFace& face, const Placement& hull_in_floe,
                                     const geometry::ConvexPolytope& piece) {
  const Vec3 centre = hull_in_floe.point(face.centre);
  const double reach = face.radius + piece.radius;
  const Vec3 apart = centre - piece.centre;
  if (apart.squaredNorm() > reach * reach || misses(piece, centre, face.radius)) return std::nullopt;
  const Vec3 normal = hull_in_floe.R * face.normal;
  if (std::abs(normal.dot(apart)) > piece.radius) return std::nullopt;  // its plane misses the piece
  Loop loop, room;
  for (const Vec3& x : face.loop) loop.push_back(hull_in_floe.point(x));
  clip_by(piece, normal, k_rounding * (reach + centre.norm()), loop, room);
  if (loop.size() < 3) return std::nullopt;
  const Moments m = moments(loop, normal);
  if (m.area <= k_least_area * piece.radius * piece.radius) return std::nullopt;
  return FaceInIce{0, 0, normal, m.area, m.centroid, m.spread};
}

std::vector<FaceInIce> faces_in_ice(const std::vector<HullFace>& hull, const Placement& hull_in_floe,
                                    const std::vector<geometry::ConvexPolytope>& floe) {
  std::vector<FaceInIce> found;
  for (std::size_t f = 0; f < hull.size(); ++f)
    for (std::size_t k = 0; k < floe.size(); ++k) {
      const std::optional<FaceInIce> one = face_in_ice(hull[f], hull_in_floe, floe[k]);
      if (!one) continue;
      found.push_back(*one);
      found.back().face = static_cast<int>(f);
      found.back().piece = static_cast<int>(k);
    }
  return found;
}

double total_area(const std::vector<FaceInIce>& faces) {
  double sum = 0;
  for (const FaceInIce& face : faces) sum += face.area;
  return sum;
}

PressurePoints pressure_points(const FaceInIce& face, double least) {
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(face.spread);  // in ascending order; the first belongs to the normal
  const double wide = std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
  const double narrow = std::sqrt(std::max(0.0, axes.eigenvalues()[1]));
  PressurePoints out;
  out.points[0] = face.centroid;
  if (wide < least) return out;
  const auto put = [&](const Vec3& arm) {
    out.points[out.count++] = face.centroid + arm;
    out.points[out.count++] = face.centroid - arm;
  };
  out.count = 0;
  const double share = narrow < least ? 1 : std::sqrt(2.0);
  put(share * wide * axes.eigenvectors().col(2));
  if (narrow >= least) put(share * narrow * axes.eigenvectors().col(1));
  return out;
}

}  // namespace nilas::fracture
