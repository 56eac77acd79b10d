#pragma once
/// Finds the face normal along which two parts are farthest apart, or overlap least.
#include <vector>

#include "contact/detect/broad/pair_view.h"

namespace nilas::detect {

/// Returns the best axis over all face normals of both polytopes, exactly. s is -infinity when there are none, as for a
/// cylinder or sphere. Stops at the first axis with s > `enough` [m]. Some face is known to separate by at least
/// `least` [m], so faces bounded below that are not tried.
/// `room`: storage.
Axis best_face_axis(const PairView& pair, double enough, std::vector<Axis>& room,
                    double least = -std::numeric_limits<double>::infinity());
/// Returns whether the part is a polytope of so few faces that a search over all of them is quicker than any guess.
bool has_few_faces(const Part& part);
/// The axis of one face: of A for kind face_a, of B for face_b.
Axis face_axis(const PairView& pair, AxisKind kind, int face);

}  // namespace nilas::detect
