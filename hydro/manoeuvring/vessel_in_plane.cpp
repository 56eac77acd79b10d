#include "hydro/manoeuvring/vessel_in_plane.h"

#include <cmath>

namespace nilas::hydro {

double VesselInPlane::speed() const { return std::hypot(motion.u, motion.v); }

double VesselInPlane::drift() const { return std::atan2(-motion.v, motion.u); }

VesselInPlane vessel_in_plane(const bodies::Bodies& bodies, int vessel, double midship, const Vec3& current) {
  const auto b = static_cast<std::size_t>(vessel);
  const Vec3 axis = bodies.R_GB[b].col(0);
  VesselInPlane seen;
  seen.yaw = std::atan2(axis.y(), axis.x());
  seen.ahead = axis.head<2>().normalized();
  seen.arm = midship * axis;
  seen.midship = (bodies.p_GB[b] + seen.arm).head<2>();
  const Vec3& w = bodies.w_GB[b];
  const Vec2 through_water = (bodies.v_GB[b] + w.cross(seen.arm) - current).head<2>();
  seen.motion = {through_water.dot(seen.ahead), through_water.dot(seen.starboard()), -w.z()};
  return seen;
}

}  // namespace nilas::hydro
