#pragma once
/// The area of a hull's surface inside ice: its faces clipped by a floe.
#include <array>
#include <optional>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/shape.h"

namespace nilas::fracture {

/// The placement of one frame in another: x_to = R x_from + p.
struct Placement {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();

  Vec3 point(const Vec3& x) const { return R * x + p; }
};

/// A convex planar piece of a hull's outer surface, in the hull's frame.
struct HullFace {
  int part = 0;                ///< Convex part of the hull that the piece belongs to.
  std::vector<Vec3> loop;      ///< counter-clockwise from outside [m]
  Vec3 normal = Vec3::Zero();  ///< outward, unit
  Vec3 centre = Vec3::Zero();  ///< mean of the corners [m]
  double radius = 0;           ///< Largest distance of a corner from `centre` [m].
};
/// Makes a face with its normal, centre and radius. Throws ContractError for fewer than three corners.
HullFace make_hull_face(int part, std::vector<Vec3> loop);

/// The part of a hull's face that lies inside one convex piece of a floe, in the floe's frame.
struct FaceInIce {
  int face = 0;                  ///< index of the hull's face
  int piece = 0;                 ///< index of the floe's convex piece
  Vec3 normal = Vec3::Zero();    ///< Unit normal of the hull's face, into the ice.
  double area = 0;               ///< [m^2]
  Vec3 centroid = Vec3::Zero();  ///< [m]
  Mat3 spread = Mat3::Zero();    ///< second moment of area about the centroid over the area [m^2]
};

/// One face clipped by one piece, or nothing where no area is left. `face` and `piece` of the result are 0.
std::optional<FaceInIce> face_in_ice(const HullFace& face, const Placement& hull_in_floe,
                                     const geometry::ConvexPolytope& piece);

/// The hull's faces clipped by the pieces, in the order of the faces, then of the pieces. The area is exact but for
/// rounding. A face that is inclined by beta to the horizontal, over a width w through a thickness h, has the area
/// w h / sin(beta). A face that lies in a piece's surface counts where the ice is in front of it, not where it is
/// behind.
std::vector<FaceInIce> faces_in_ice(const std::vector<HullFace>& hull, const Placement& hull_in_floe,
                                    const std::vector<geometry::ConvexPolytope>& floe);

/// The sum of the areas [m^2].
double total_area(const std::vector<FaceInIce>& faces);

/// Points that represent a uniform pressure on a face, each with an equal share of its force.
struct PressurePoints {
  std::array<Vec3, 4> points;
  int count = 1;
};
/// The pressure points of a face. They reproduce force and moment, since they are centred. Four points
/// c +- sqrt(2 I_k/A) e_k on the principal axes reproduce the second moments of the area too. An axis along which the
/// area's radius of gyration is below `least` [m] has none: two points c +- sqrt(I_1/A) e_1 remain, or the centroid.
/// The points depend on the area alone, not on the first corner of its outline.
PressurePoints pressure_points(const FaceInIce& face, double least);

}  // namespace nilas::fracture
