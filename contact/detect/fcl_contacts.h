#pragma once
/// The narrow phase "fcl": contacts of a pair as FCL gives them, completed to a manifold.
#include <vector>

#include "contact/detect/narrow_phase.h"

namespace nilas::detect {

/// Appends the points of parts a and b with gap < margin [m]. FCL's points, normals and depths are taken unchanged. FCL
/// may give one point of two surfaces that meet along an edge or a face. The other points then come from the two
/// surfaces laid over each other along FCL's normal, and none is deeper than FCL's. Points that other parts of the same
/// body hide are left out. Pairs without an answer from FCL are left to the caller: PairContacts::search then counts a
/// fallback.
PairContacts find_fcl_contacts(const bodies::Bodies& bodies, const Part& a, const Part& b, double margin,
                               FclShapes& fcl, AxisSearchRoom& room, PairMemory& memory,
                               std::vector<ContactPoint>& points);

}  // namespace nilas::detect
