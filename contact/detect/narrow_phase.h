#pragma once
/// Contact points of one candidate pair of parts.
#include <array>

#include "contact/detect/axis_search.h"
#include "contact/detect/contact_point.h"
#include "contact/detect/point_reduction.h"

namespace nilas {

/// What a pair keeps from call to call.
struct PairMemory {
  Vec3 axis = Vec3::Zero();  ///< separated the pair by more than the margin, in G; zero: none known
};

struct PairContacts {
  int count = 0;
  std::array<ContactPoint, k_most_points> points;  ///< in rising order of key
  bool separated_by_memory = false;
  AxisSearchCounts search;
};

/// Points of parts a and b (body a < body b) with gap < margin [m].
void find_pair_contacts(const Bodies& bodies, const Part& a, const Part& b, double margin, FclShapes& fcl,
                        AxisSearchRoom& room, PairMemory& memory, PairContacts& out);

}  // namespace nilas
