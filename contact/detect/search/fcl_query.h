#pragma once
/// The Flexible Collision Library's answers for one pair of parts: its GJK and EPA are those of libccd.
#include <memory>
#include <optional>
#include <vector>

#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// One contact as FCL gives it, in A's frame.
struct FclContact {
  Vec3 p = Vec3::Zero();   ///< midway between the surfaces [m]
  Vec3 n = Vec3::UnitX();  ///< unit normal from A to B
  double gap = 0;          ///< distance of FCL's nearest points, or minus its depth of penetration [m]
};

/// FCL geometry of the parts met so far, made on first use; safe to use from several threads.
/// All queries are made in a frame at the smaller part's centre, scaled by a power of two so that its radius is 1 to 2,
/// since FCL's tolerances are absolute.
class FclShapes {
 public:
  FclShapes();
  ~FclShapes();
  FclShapes(FclShapes&&) noexcept;
  FclShapes& operator=(FclShapes&&) noexcept;

  /// Returns the direction from A to B, in A's frame, that FCL finds for polytopes and cylinders. With `apart` it is
  /// the line between the nearest points, otherwise the normal of the penetration. The other of the two serves where
  /// the first is no direction. Empty when FCL throws or neither is a direction.
  std::optional<Vec3> direction(const PairView& pair, bool apart);

  /// Returns FCL's contacts of two parts, none of them a plane: one between the nearest points of parts that are apart,
  /// otherwise those of its penetration. Empty when FCL throws or gives none.
  std::vector<FclContact> contacts(const PairView& pair);

  /// Returns FCL's contacts of the half space z < 0 and a part, in the half space's frame, for gaps below `margin` [m].
  /// FCL has no distance to a half space, so the plane is raised by the margin. `failed` is set when FCL throws.
  std::vector<FclContact> plane_contacts(const Part& guest, const RelativePose& guest_in_plane, double margin,
                                         bool& failed);

 private:
  struct Store;
  std::unique_ptr<Store> store_;
};

}  // namespace nilas::detect
