#include "core/sim/reference_carriage.h"

#include <algorithm>
#include <limits>

#include "core/vessel/carried_vessel.h"
#include "core/vessel/cells.h"

namespace nilas {

ReferenceCarriage::ReferenceCarriage(const CarriageModel& model) : motion_(model.motion), kinks_(model.motion.kinks()) {
  if (model.balance != BalanceKind::six_cells) return;
  const Mat6 wrenches = cell_wrenches(model.cells);
  cells_.emplace(wrenches);
  stiffness_ = condensed_stiffness(wrenches, model.stiffness, free_axes(model));
  damping_time_ = model.damping / model.stiffness;
}

void ReferenceCarriage::begin_stretch(double t) {
  const auto next = std::upper_bound(kinks_.begin(), kinks_.end(), t);
  const bool last = next == kinks_.end();
  end_ = last ? std::numeric_limits<double>::infinity() : *next;
  within_ = last ? t + 1 : 0.5 * (t + end_);
  go_to(t);
}

void ReferenceCarriage::go_to(double t) { moment_ = motion_.moment(t, within_); }

VecX ReferenceCarriage::cell_force(const VecX& q, const VecX& u) const {
  return -(stiffness_ * (q + damping_time_ * u));
}

CarriageLoads ReferenceCarriage::loads(const Wrench& about_com, const Vec3& com) const {
  CarriageLoads loads{about_com, about_com, {}, {}};
  loads.about_joint.torque += (com - now().p).cross(about_com.force);
  if (!cells_) return loads;
  const Quat to_carriage(Eigen::AngleAxisd(-now().yaw, Vec3::UnitZ()));
  Vec6 transmitted;
  transmitted << to_carriage * loads.about_joint.torque, to_carriage * loads.about_joint.force;
  Eigen::Map<Vec6>(loads.cells.data()) = cells_->solve(transmitted);
  return loads;
}

}  // namespace nilas
