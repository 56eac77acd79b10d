#pragma once
/// Contact points of round parts after a motion.
#include <span>

#include "contact/detect/narrow_phase.h"

namespace nilas::detect {

/// Returns whether the shape is a sphere or a cylinder. Its surface touches elsewhere once it has turned.
bool is_round(const geometry::Shape& shape);

/// Measures the points of one pair of parts anew at the bodies' present poses. One of the parts must be round.
/// `points` were carried along with the bodies as if their material touched on. Each takes place, normal and gap of the
/// contact that is found next to it. It keeps its own where there is none within a quarter of the radius.
void measure_round_pair(const bodies::Bodies& bodies, const Part& a, const Part& b, const PairSearch& search,
                        AxisSearchRoom& room, PairMemory memory, std::span<ContactPoint> points);

}  // namespace nilas::detect
