#include "contact/law/contact_frame.h"

#include <cmath>

namespace nilas::contact {

/// Cosines closer than this count as a tie; see the header.
constexpr double k_tie = 0.1;

static int least_parallel_axis(const Vec3& n, const Mat3& R_GA) {
  const Vec3 cosines = (R_GA.transpose() * n).cwiseAbs();
  const double enough = cosines.minCoeff() + k_tie;
  for (int axis = 2; axis > 0; --axis)
    if (cosines[axis] < enough) return axis;
  return 0;
}

Mat3 contact_frame(const Vec3& n, const Mat3& R_GA, double axes) {
  const Vec3 axis = R_GA.col(least_parallel_axis(n, R_GA));
  const Vec3 t1 = (axis - axis.dot(n) * n).normalized();
  const Vec3 t2 = n.cross(t1);
  Mat3 frame;
  frame.col(0) = n;
  if (axes == 0) {
    frame.col(1) = t1;
    frame.col(2) = t2;
  } else {
    frame.col(1) = std::cos(axes) * t1 + std::sin(axes) * t2;
    frame.col(2) = std::cos(axes) * t2 - std::sin(axes) * t1;
  }
  return frame;
}

}  // namespace nilas::contact
