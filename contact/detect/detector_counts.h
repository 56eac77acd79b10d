#pragma once
/// Counts of how a detector settled the pairs of parts whose boxes overlap.
#include <array>

namespace nilas::detect {

/// The counts of one call, or their sums over several. Each candidate pair is in one of the six counts after
/// `candidate_pairs`, unless it was left to the caller.
struct DetectorCounts {
  long candidate_pairs = 0;     ///< pairs of parts whose boxes overlap
  long cached_separations = 0;  ///< dismissed by the axis that separated them at the last call
  long kept_axes = 0;           ///< the contact axis of the last call served again
  long by_fcl = 0;              ///< settled by FCL: its axis separates, or the exact search proved it
  long corrected = 0;           ///< the exact search found a better axis than FCL, or FCL gave none
  long searched = 0;            ///< settled by the exact search alone
  long closed_forms = 0;        ///< pairs with a plane or a sphere, by closed forms
  long fcl_queries = 0;         ///< pairs for which FCL was asked
  long fallbacks = 0;           ///< FCL threw or gave an unusable answer

  DetectorCounts& operator+=(const DetectorCounts& other);
};

/// Pointers to all members, for sums and records.
constexpr std::array k_detector_counts{
    &DetectorCounts::candidate_pairs, &DetectorCounts::cached_separations, &DetectorCounts::kept_axes,
    &DetectorCounts::by_fcl,          &DetectorCounts::corrected,          &DetectorCounts::searched,
    &DetectorCounts::closed_forms,    &DetectorCounts::fcl_queries,        &DetectorCounts::fallbacks};

inline DetectorCounts& DetectorCounts::operator+=(const DetectorCounts& other) {
  for (const auto count : k_detector_counts) this->*count += other.*count;
  return *this;
}

}  // namespace nilas::detect
