#pragma once
/// The frame of one contact, which turns with the bodies.
#include "core/base/math.h"

namespace nilas::contact {

/// C with columns n, t1, t2 in G: t1 is the axis of body A's frame least parallel to the unit normal, projected on the
/// contact plane; t2 = n x t1; both then turned by `axes` about n [rad].
///
/// Axes count as equally good when the magnitudes of their cosines with n differ by less than 0.1 (about 6 degrees):
/// then z goes before y before x. So all side contacts of floating plates have t1 upward whatever their direction and
/// small tilt, the choice does not flicker while bodies rock, and mirrored scenes choose mirrored axes.
Mat3 contact_frame(const Vec3& n, const Mat3& R_GA, double axes);

}  // namespace nilas::contact
