#pragma once
/// Finds the contacts of all bodies at their present poses: broad phase, narrow phase, manifolds.
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "contact/detect/broad/contact_point.h"
#include "contact/detect/broad/fast_pairs.h"
#include "contact/detect/detector_counts.h"
#include "contact/detect/swept.h"
#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/choices/contact_choices.h"

namespace nilas::detect {

/// Two convex parts of different bodies, followed along their paths through a step.
struct SweptPair {
  int a = 0, b = 0;  ///< bodies, a < b
  int part_a = 0, part_b = 0;
  TimeOfImpact first;
  std::vector<ContactPoint>
      points;  ///< the points where they meet, with both bodies at their poses of that moment; empty at t = 0
};

/// A predicate of two bodies, a < b. It is called from several threads and for each pair of their parts, and must
/// always give the same answer.
using PairFilter = std::function<bool(int, int)>;

/// Finds contacts with the narrow phase given to its constructor. Keeps geometry and coherence caches between calls.
/// The results depend on the poses, and in two cases on the last call. Where two axes of a pair tie within its
/// tolerance, the pair keeps the one it had. Where several sets of corners of one common area are nearly as good
/// (k_kept_area, k_kept_depth), it keeps the set it had; the deepest point is always included. The points come in the
/// order of (a, b, part_a, part_b, key).
class ContactDetector {
 public:
  explicit ContactDetector(int threads = 1, NarrowPhase narrow = NarrowPhase::nilas);
  ~ContactDetector();
  ContactDetector(ContactDetector&&) noexcept;
  ContactDetector& operator=(ContactDetector&&) noexcept;

  /// Returns all points with gap < margin [m]. Pairs of two immovable bodies are left out. The call detects bodies that
  /// came or went since the last call. A body whose shape changed must be added again under a new id. Pairs for which
  /// `left` is true are left to the caller: see pairs_left().
  std::vector<ContactPoint> detect(const bodies::Bodies& bodies, double margin, const PairFilter& left = {});
  /// Returns the points whose gap the bodies' own reach may close (contact/detect/broad/reach.h, one length per body
  /// [m]). All points with gap < margin enter as well.
  std::vector<ContactPoint> detect(const bodies::Bodies& bodies, const std::vector<double>& own_reach,
                                   double margin = 0, const PairFilter& left = {});
  /// The pairs for which the filter of the last detect() was true, among those whose boxes overlap, in rising order.
  const std::vector<std::pair<int, int>>& pairs_left() const;
  /// Finds when the parts of these pairs first touch along the paths of their bodies, and the points that the rest of
  /// the paths may close. `motions` has one entry per body, and only those of the pairs are read. With `overlap` it
  /// finds when the parts overlap that deep; its lengths are then shares of the width that made the pair a fast one.
  /// Parts too far apart to meet are left out. Changes no cache. The result is in the order of (a, b, part_a, part_b).
  std::vector<SweptPair> sweep(const bodies::Bodies& bodies, const std::vector<BodyMotion>& motions,
                               const std::vector<FastPair>& pairs, const SoughtOverlap& overlap = {});
  /// Measures points of the last detect() anew at the bodies' present poses where a part is a sphere or a cylinder
  /// (contact/detect/round_pair.h). `points` were carried along with the bodies, in the order of detect(). The other
  /// points, and those where ice crushes, stay as they are. Changes no cache.
  void measure_round(const bodies::Bodies& bodies, std::vector<ContactPoint>& points);
  /// Registers bodies that came or went, as the calls above do. The memories of all other pairs are kept. Needed only
  /// before save().
  void follow(const bodies::Bodies& bodies);
  const DetectorCounts& counts() const;  ///< counts of the last detect() and of the sweeps since then

  /// Saves the coherence caches: the boxes of the broad phase and the memories of the pairs.
  void save(StateWriter out) const;
  /// Restores the state of a detector that was saved after a call with these bodies, at any poses. Throws InputError
  /// when the state belongs to other bodies.
  void restore(const bodies::Bodies& bodies, const StateReader& in);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas::detect
