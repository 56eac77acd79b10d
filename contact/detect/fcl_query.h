#pragma once
/// The Flexible Collision Library's answer for one pair of parts, as a direction only: its depths and its normals on
/// thin plates are not to be trusted, a direction is judged by the separation along it.
#include <memory>
#include <optional>

#include "contact/detect/pair_view.h"

namespace nilas {

/// FCL geometry of the parts met so far, made on first use; safe to use from several threads.
class FclShapes {
 public:
  FclShapes();
  ~FclShapes();
  FclShapes(FclShapes&&) noexcept;
  FclShapes& operator=(FclShapes&&) noexcept;

  /// Direction from A to B in A's frame that FCL finds: between the nearest points when `apart`, else the normal of its
  /// penetration; the other one when FCL sees it the other way. Asked in a frame at the smaller part's centre, scaled
  /// by a power of two so that its radius is about 1, since FCL's tolerances are absolute. Empty when FCL throws or its
  /// answer is not a direction. Polytopes and cylinders.
  std::optional<Vec3> direction(const PairView& pair, bool apart);

 private:
  struct Store;
  std::unique_ptr<Store> store_;
};

}  // namespace nilas
