#pragma once
/// Contacts of all bodies at their present poses: broad phase, narrow phase, manifolds.
#include <memory>
#include <string>
#include <vector>

#include "contact/detect/contact_point.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"

namespace nilas {

struct DetectorCounts {
  long candidate_pairs = 0;     ///< pairs of parts whose boxes overlap
  long cached_separations = 0;  ///< pairs set aside by last step's separating axis
  long kept_axes = 0;           ///< pairs whose axis of the last call served again
  long fcl_queries = 0;
  long fallbacks = 0;  ///< times the library threw or gave an unusable answer and the face axes decided alone
};

/// Keeps geometry and coherence caches between calls. Results depend on the poses; where two axes of a pair lie within
/// its tolerance of each other, on the one it had at the last call; and where several sets of corners of one common
/// area are nearly as good (k_kept_area, k_kept_depth), on the set it had. They come in an order of (a, b, part_a,
/// part_b, key).
class ContactDetector {
 public:
  explicit ContactDetector(int threads = 1);
  ~ContactDetector();
  ContactDetector(ContactDetector&&) noexcept;
  ContactDetector& operator=(ContactDetector&&) noexcept;

  /// All points with gap < margin [m]. Pairs of two bodies that cannot move are left out. Bodies appended since the
  /// last call are picked up; a body whose shape changed must be re-added under a new id.
  std::vector<ContactPoint> detect(const Bodies& bodies, double margin);
  /// The points whose gap the bodies' own reach (contact/detect/reach.h, one length per body [m]) may close.
  std::vector<ContactPoint> detect(const Bodies& bodies, const std::vector<double>& own_reach);
  const DetectorCounts& counts() const;  ///< of the last call

  /// The coherence caches: the boxes of the broad phase, and what each pair remembers.
  void save(StateWriter out) const;
  /// Goes on as the detector that was saved after a call with these bodies, wherever they were. Throws InputError when
  /// the state is one of other bodies.
  void restore(const Bodies& bodies, const StateReader& in);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas
