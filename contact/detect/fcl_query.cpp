#include "contact/detect/fcl_query.h"

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <tuple>

namespace nilas {

namespace {

using Geometry = std::shared_ptr<const fcl::CollisionGeometryd>;

constexpr double k_tolerance = 1e-10;  // [-] of the smaller part's radius, which is 1 to 2 in the query

std::shared_ptr<const fcl::CollisionGeometryd> convex_geometry(const Part& part, double scale) {
  const ConvexPolytope& polytope = *part.facets->polytope;
  auto vertices = std::make_shared<std::vector<Vec3>>();
  for (const Vec3& v : polytope.vertices) vertices->push_back(scale * (v - part.centre));
  auto faces = std::make_shared<std::vector<int>>();
  for (const auto& loop : polytope.faces) {
    faces->push_back(static_cast<int>(loop.size()));
    faces->insert(faces->end(), loop.begin(), loop.end());
  }
  auto convex = std::make_shared<fcl::Convexd>(vertices, static_cast<int>(polytope.faces.size()), faces);
  convex->computeLocalAABB();
  return convex;
}

Geometry make_geometry(const Part& part, double scale) {
  if (part.kind == PartKind::polytope) return convex_geometry(part, scale);
  auto cylinder = std::make_shared<fcl::Cylinderd>(scale * part.radius, 2.0 * scale * part.half_height);
  cylinder->computeLocalAABB();
  return cylinder;
}

struct Query {
  Geometry a, b;
  fcl::Transform3d pose_a = fcl::Transform3d::Identity();
  fcl::Transform3d pose_b = fcl::Transform3d::Identity();
};

Vec3 between_nearest_points(const Query& query) {
  fcl::DistanceRequestd request(true, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = k_tolerance;
  fcl::DistanceResultd result;
  fcl::distance(query.a.get(), query.pose_a, query.b.get(), query.pose_b, request, result);
  return result.nearest_points[1] - result.nearest_points[0];
}

Vec3 penetration_normal(const Query& query) {
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = k_tolerance;
  fcl::CollisionResultd result;
  fcl::collide(query.a.get(), query.pose_a, query.b.get(), query.pose_b, request, result);
  return result.numContacts() > 0 ? Vec3(result.getContact(0).normal) : Vec3(Vec3::Zero());
}

std::optional<Vec3> unit(const Vec3& direction) {
  const double length = direction.norm();
  if (!std::isfinite(length) || !(length > k_tolerance)) return std::nullopt;
  return Vec3(direction / length);
}

}  // namespace

struct FclShapes::Store {
  std::mutex mutex;
  std::map<std::tuple<int, int, int>, Geometry> geometry;  ///< by body, part and exponent of the scale

  Geometry find(const Part& part, int exponent) {
    const std::lock_guard<std::mutex> lock(mutex);
    Geometry& found = geometry[{part.body, part.index, exponent}];
    if (!found) found = make_geometry(part, std::ldexp(1.0, exponent));
    return found;
  }
};

FclShapes::FclShapes() : store_(std::make_unique<Store>()) {}
FclShapes::~FclShapes() = default;
FclShapes::FclShapes(FclShapes&&) noexcept = default;
FclShapes& FclShapes::operator=(FclShapes&&) noexcept = default;

std::optional<Vec3> FclShapes::direction(const PairView& pair, bool apart) {
  const int exponent = -std::ilogb(pair.size);
  const double scale = std::ldexp(1.0, exponent);
  const Vec3 centre_b = pair.b_in_a.point(pair.b.centre);
  const Vec3 origin = pair.b.bounding_radius < pair.a.bounding_radius ? centre_b : pair.a.centre;
  try {
    Query query{store_->find(pair.a, exponent), store_->find(pair.b, exponent)};
    query.pose_a.translation() = scale * (pair.a.centre - origin);
    query.pose_b.linear() = pair.b_in_a.R;
    query.pose_b.translation() = scale * (centre_b - origin);
    const std::optional<Vec3> direction = unit(apart ? between_nearest_points(query) : penetration_normal(query));
    if (direction) return direction;
    return unit(apart ? penetration_normal(query) : between_nearest_points(query));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace nilas
