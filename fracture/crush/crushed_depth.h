#pragma once
/// How deep each face of a hull has been in each floe: crushed ice is gone, and does not push back.
#include <compare>
#include <cstdint>
#include <map>

#include "core/base/math.h"
#include "core/base/state.h"

namespace nilas {

/// One face of a hull against one convex piece of a floe, by the ids of the bodies.
struct CrushedFace {
  std::int64_t hull = 0, floe = 0;
  int face = 0, piece = 0;
  friend auto operator<=>(const CrushedFace&, const CrushedFace&) = default;
};

/// normal . x = offset in the floe's frame; the ice below it is crushed.
struct CrushedPlane {
  Vec3 normal = Vec3::UnitX();  ///< that the hull's face had, into the ice
  double offset = 0;            ///< [m]
  Vec3 place = Vec3::Zero();    ///< where the face was then, its centroid [m]

  /// Of a point of the floe's frame below it, 0 at or above it [m].
  double gap(const Vec3& x) const;
};

/// A face's deepest plane is kept for as long as the face stays in that ice and there.
class CrushedDepth {
 public:
  /// The face is at `centroid` now, with this normal, in the floe's frame. Returns the plane that it crushed up to,
  /// which is its present one where it is at least as deep there, or has gone along it by more than `reach` [m].
  CrushedPlane advance(const CrushedFace& face, const Vec3& normal, const Vec3& centroid, double reach);
  /// Forgets the faces that were not named since the last call.
  void forget_others();

  /// A piece takes the floe's place, its frame moved to `place` [m]: in each of its `parts` every face of a hull has
  /// been as deep as in the deepest of the floe's.
  void hand_on(std::int64_t floe, std::int64_t piece, const Vec2& place, int parts);

  void save(StateWriter out) const;
  /// Throws InputError for a state that is not whole.
  void restore(const StateReader& in);

 private:
  std::map<CrushedFace, CrushedPlane> known_, named_;
};

}  // namespace nilas
