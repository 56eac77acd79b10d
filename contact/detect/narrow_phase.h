#pragma once
/// Finds the contact points of one candidate pair of parts.
#include <vector>

#include "contact/detect/broad/contact_key.h"
#include "contact/detect/broad/contact_point.h"
#include "contact/detect/search/axis_search.h"
#include "contact/detect/surface/point_reduction.h"
#include "core/choices/contact_choices.h"

namespace nilas::detect {

/// The memory of a pair from call to call.
struct PairMemory {
  Vec3 separating =
      Vec3::Zero();  ///< axis that separated the pair by more than the margin, in G; zero where none is known
  RememberedAxis contact_axis;
  std::vector<Feature>
      kept;  ///< features of the points that spread best, then of deeper points; empty below four points
};

struct PairContacts {
  int count = 0;             ///< number of points added
  bool closed_form = false;  ///< a pair with a plane or a sphere, solved by Nilas in closed form
  bool separated_by_memory = false;
  double left_depth =
      0;  ///< depth of parts that overlap but leave their contact to other parts of the two bodies, else 0 [m]
  AxisSearchCounts search;
};

/// The narrow phase that searches a pair, and FCL's shapes.
struct PairSearch {
  NarrowPhase narrow;
  FclShapes& fcl;
};

/// Appends the points of parts a and b (body a < body b) with gap < margin [m] to `points`, in rising order of key.
/// `alone`: no other parts of the two bodies have a point that overlaps, see find_way_out.
PairContacts find_pair_contacts(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                                const PairSearch& search, AxisSearchRoom& room, PairMemory& memory,
                                std::vector<ContactPoint>& points, bool alone = false);

}  // namespace nilas::detect
