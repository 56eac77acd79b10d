#pragma once
/// The depth to which each face of a hull has crushed each floe. Crushed ice does not push back.
#include <compare>
#include <cstdint>
#include <map>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas::fracture {

/// A face of a hull and a convex piece of a floe, named by the ids of the bodies.
struct CrushedFace {
  std::int64_t hull = 0, floe = 0;
  int face = 0, piece = 0;
  friend auto operator<=>(const CrushedFace&, const CrushedFace&) = default;
};

/// The plane normal . x = offset in the floe's frame. The ice below it is crushed.
struct CrushedPlane {
  Vec3 normal = Vec3::UnitX();  ///< Unit normal that the hull's face had, into the ice.
  double offset = 0;            ///< [m]
  Vec3 place = Vec3::Zero();    ///< Centroid that the face had [m].

  /// The distance of a point of the floe's frame below the plane [m]; 0 at or above it.
  double gap(const Vec3& x) const;
};

/// The deepest plane of each face. It is kept for as long as the face stays in that ice and at that place.
class CrushedDepth {
 public:
  /// Notes that the face is at `centroid` with this normal, in the floe's frame. Returns the plane up to which it has
  /// crushed the ice. That is its present plane where the face is at least as deep, or has moved along the old plane by
  /// more than `reach` [m].
  CrushedPlane advance(const CrushedFace& face, const Vec3& normal, const Vec3& centroid, double reach);
  /// Forgets the faces that advance() did not name since the last call.
  void forget_others();

  /// Gives a piece of the floe, whose frame is moved to `place` [m], the memory of the floe. In each of its convex
  /// `parts` every face of a hull has the deepest plane that it had in the floe, at the place of the piece's centre.
  void hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, int parts);

  void save(StateWriter out) const;
  /// Throws InputError for an incomplete state.
  void restore(const StateReader& in);

 private:
  std::map<CrushedFace, CrushedPlane> known_, named_;
};

}  // namespace nilas::fracture
