#include "contact/detect/search/fcl_query.h"

#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <exception>
#include <map>
#include <mutex>
#include <new>
#include <tuple>

namespace nilas::detect {

namespace {

using Geometry = std::shared_ptr<const fcl::CollisionGeometryd>;

constexpr double k_tolerance = 1e-10;  // [-] of the smaller part's radius, which is 1 to 2 in the query

std::shared_ptr<const fcl::CollisionGeometryd> convex_geometry(const Part& part, double scale) {
  const geometry::ConvexPolytope& polytope = *part.facets->polytope;
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
  if (part.kind == PartKind::sphere) {
    auto sphere = std::make_shared<fcl::Sphered>(scale * part.radius);
    sphere->computeLocalAABB();
    return sphere;
  }
  auto cylinder = std::make_shared<fcl::Cylinderd>(scale * part.radius, 2.0 * scale * part.half_height);
  cylinder->computeLocalAABB();
  return cylinder;
}

struct Query {
  Geometry a, b;
  fcl::Transform3d pose_a = fcl::Transform3d::Identity();
  fcl::Transform3d pose_b = fcl::Transform3d::Identity();
};

/// Returns FCL's nearest points. Parts that overlap have a distance below zero.
fcl::DistanceResultd nearest_points(const Query& query) {
  fcl::DistanceRequestd request(true, false);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = k_tolerance;
  fcl::DistanceResultd result;
  fcl::distance(query.a.get(), query.pose_a, query.b.get(), query.pose_b, request, result);
  return result;
}

fcl::CollisionResultd penetration(const Query& query, std::size_t most_contacts) {
  fcl::CollisionRequestd request(most_contacts, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = k_tolerance;
  fcl::CollisionResultd result;
  fcl::collide(query.a.get(), query.pose_a, query.b.get(), query.pose_b, request, result);
  return result;
}

Vec3 between_nearest_points(const Query& query) {
  const fcl::DistanceResultd result = nearest_points(query);
  return result.nearest_points[1] - result.nearest_points[0];
}

Vec3 penetration_normal(const Query& query) {
  const fcl::CollisionResultd result = penetration(query, 1);
  return result.numContacts() > 0 ? Vec3(result.getContact(0).normal) : Vec3(Vec3::Zero());
}

/// Largest number of contacts that FCL can give for one pair; for convex parts it gives one.
constexpr std::size_t k_most_contacts = 8;

std::optional<Vec3> unit(const Vec3& direction) {
  const double length = direction.norm();
  if (!std::isfinite(length) || !(length > k_tolerance)) return std::nullopt;
  return Vec3(direction / length);
}

}  // namespace

struct FclShapes::Store {
  std::mutex mutex;
  std::map<std::tuple<int, int, int>, Geometry> geometry;  ///< keys: body, part and exponent of the scale

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

namespace {

/// A pair in FCL's scaled frame, and the transformation back.
struct ScaledQuery {
  Query query;
  double scale = 1;
  Vec3 origin = Vec3::Zero();  ///< origin of FCL's frame in A's [m]

  Vec3 in_a(const Vec3& x) const { return x / scale + origin; }
};

template <class FindGeometry>
ScaledQuery scaled_query(const PairView& pair, const FindGeometry& find) {
  const int exponent = -std::ilogb(pair.size);
  ScaledQuery scaled{{find(pair.a, exponent), find(pair.b, exponent)}, std::ldexp(1.0, exponent)};
  const Vec3 centre_b = pair.b_in_a.point(pair.b.centre);
  scaled.origin = pair.b.bounding_radius < pair.a.bounding_radius ? centre_b : pair.a.centre;
  scaled.query.pose_a.translation() = scaled.scale * (pair.a.centre - scaled.origin);
  scaled.query.pose_b.linear() = pair.b_in_a.R;
  scaled.query.pose_b.translation() = scaled.scale * (centre_b - scaled.origin);
  return scaled;
}

}  // namespace

std::optional<Vec3> FclShapes::direction(const PairView& pair, bool apart) {
  try {
    const Query query =
        scaled_query(pair, [&](const Part& part, int exponent) { return store_->find(part, exponent); }).query;
    const std::optional<Vec3> direction = unit(apart ? between_nearest_points(query) : penetration_normal(query));
    if (direction) return direction;
    return unit(apart ? penetration_normal(query) : between_nearest_points(query));
  } catch (const std::bad_alloc&) {
    throw;  // the search would go on with fewer contacts
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::vector<FclContact> FclShapes::contacts(const PairView& pair) {
  std::vector<FclContact> contacts;
  try {
    const ScaledQuery scaled =
        scaled_query(pair, [&](const Part& part, int exponent) { return store_->find(part, exponent); });
    const fcl::DistanceResultd near = nearest_points(scaled.query);
    const Vec3 on_a = near.nearest_points[0], on_b = near.nearest_points[1];
    if (near.min_distance > 0) {
      if (const std::optional<Vec3> n = unit(on_b - on_a))
        contacts.push_back({scaled.in_a(0.5 * (on_a + on_b)), *n, near.min_distance / scaled.scale});
      if (!contacts.empty()) return contacts;
    }
    const fcl::CollisionResultd found = penetration(scaled.query, k_most_contacts);
    for (std::size_t k = 0; k < found.numContacts(); ++k) {
      const fcl::Contactd& contact = found.getContact(k);
      if (const std::optional<Vec3> n = unit(contact.normal); n && std::isfinite(contact.penetration_depth))
        contacts.push_back({scaled.in_a(contact.pos), *n, -contact.penetration_depth / scaled.scale});
    }
  } catch (const std::bad_alloc&) {
    throw;  // the search would go on with fewer contacts
  } catch (const std::exception&) {
    contacts.clear();
  }
  return contacts;
}

std::vector<FclContact> FclShapes::plane_contacts(const Part& guest, const RelativePose& guest_in_plane, double margin,
                                                  bool& failed) {
  std::vector<FclContact> contacts;
  failed = false;
  const int exponent = -std::ilogb(guest.bounding_radius);
  const double scale = std::ldexp(1.0, exponent);
  const Vec3 origin = guest_in_plane.point(guest.centre);  // the guest's height is the half space's place
  try {
    Query query{std::make_shared<fcl::Halfspaced>(Vec3::UnitZ(), scale * (margin - origin.z())),
                store_->find(guest, exponent)};
    query.pose_b.linear() = guest_in_plane.R;
    const fcl::CollisionResultd found = penetration(query, k_most_contacts);
    for (std::size_t k = 0; k < found.numContacts(); ++k) {
      const fcl::Contactd& contact = found.getContact(k);
      if (!std::isfinite(contact.penetration_depth)) continue;
      // FCL's point is midway between the raised plane and the part.
      const double gap = margin - contact.penetration_depth / scale;
      const Vec3 p = contact.pos / scale + origin - 0.5 * margin * Vec3::UnitZ();
      if (gap < margin) contacts.push_back({p, Vec3::UnitZ(), gap});
    }
  } catch (const std::bad_alloc&) {
    throw;  // the search would go on with fewer contacts
  } catch (const std::exception&) {
    failed = true;
    contacts.clear();
  }
  return contacts;
}

}  // namespace nilas::detect
