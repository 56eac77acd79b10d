#include "core/sim/reference/reference_carriage.h"

#include <algorithm>
#include <limits>

#include "core/vessel/model/cells.h"

namespace nilas::sim {

ReferenceCarriage::ReferenceCarriage(const vessel::CarriageModel& model)
    : motion_(model.motion), kinks_(model.motion.kinks()) {
  if (model.balance == BalanceKind::six_cells) cells_.emplace(vessel::cell_wrenches(model.cells));
}

void ReferenceCarriage::begin_stretch(double t) {
  const auto next = std::upper_bound(kinks_.begin(), kinks_.end(), t);
  const bool last = next == kinks_.end();
  end_ = last ? std::numeric_limits<double>::infinity() : *next;
  within_ = last ? t + 1 : 0.5 * (t + end_);
  go_to(t);
}

void ReferenceCarriage::go_to(double t) { moment_ = motion_.moment(t, within_); }

vessel::CarriageLoads ReferenceCarriage::loads(const Wrench& about_com, const Vec3& com) const {
  vessel::CarriageLoads loads{about_com, about_com, {}, {}};
  loads.about_joint.torque += (com - now().p).cross(about_com.force);
  if (cells_) loads.cells = vessel::cell_readings(*cells_, loads.about_joint, now().yaw);
  return loads;
}

}  // namespace nilas::sim
