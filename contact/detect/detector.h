#pragma once
/// Contacts of all bodies at their present poses: broad phase, narrow phase, manifolds.
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

namespace nilas {

/// Two parts of different bodies on their way through a step.
struct SweptPair {
  int a = 0, b = 0;  ///< bodies, a < b
  int part_a = 0, part_b = 0;
  TimeOfImpact first;
  std::vector<ContactPoint> points;  ///< where they meet, as found with both bodies where they are then; none at t = 0
};

/// Of two bodies, a < b. Called from several threads, for each pair of their parts: the answer must be the same.
using PairFilter = std::function<bool(int, int)>;

/// Finds the contacts of pairs with the narrow phase of its constructor. Keeps geometry and coherence caches between
/// calls. Results depend on the poses; where two axes of a pair lie within its tolerance of each other, on the one it
/// had at the last call; and where several sets of corners of one common area are nearly as good (k_kept_area,
/// k_kept_depth), on the set it had; the deepest is always among them. They come in an order of (a, b, part_a, part_b,
/// key).
class ContactDetector {
 public:
  explicit ContactDetector(int threads = 1, NarrowPhase narrow = NarrowPhase::nilas);
  ~ContactDetector();
  ContactDetector(ContactDetector&&) noexcept;
  ContactDetector& operator=(ContactDetector&&) noexcept;

  /// All points with gap < margin [m]. Pairs of two bodies that cannot move are left out. Bodies that came or went
  /// since the last call are noticed; a body whose shape changed must be re-added under a new id. Pairs that `left`
  /// names are left to the caller: see pairs_left().
  std::vector<ContactPoint> detect(const Bodies& bodies, double margin, const PairFilter& left = {});
  /// The points whose gap the bodies' own reach (contact/detect/broad/reach.h, one length per body [m]) may close.
  /// All points with gap < margin enter beside them.
  std::vector<ContactPoint> detect(const Bodies& bodies, const std::vector<double>& own_reach, double margin = 0,
                                   const PairFilter& left = {});
  /// Of the last detect(): those that its filter named, among the pairs whose boxes overlap; in rising order.
  const std::vector<std::pair<int, int>>& pairs_left() const;
  /// When the parts of these pairs first touch on the bodies' ways (one motion per body; only those of the pairs are
  /// read), and the points that the rest of their ways may close; with `overlap`, when they overlap so deep, its
  /// lengths being shares of the width that made the pair a fast one. Parts too far apart to meet are left out. Keeps
  /// nothing; in an order of (a, b, part_a, part_b).
  std::vector<SweptPair> sweep(const Bodies& bodies, const std::vector<BodyMotion>& motions,
                               const std::vector<FastPair>& pairs, const SoughtOverlap& overlap = {});
  /// Takes notice of bodies that came or went, as the calls above do; what is remembered of pairs of others stays.
  /// Needed before save() alone.
  void follow(const Bodies& bodies);
  const DetectorCounts& counts() const;  ///< of the last detect() and of the sweeps since then

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
