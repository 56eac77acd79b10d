#pragma once
/// The carriage in the reference integrator: its motion between kinks, and the readings of its load cells.
#include <optional>
#include <vector>

#include "core/vessel/vessel_system.h"

namespace nilas::sim {

class ReferenceCarriage {
 public:
  explicit ReferenceCarriage(const vessel::CarriageModel& model);

  /// From t [s] on, the motion is that of the smooth stretch that begins there.
  void begin_stretch(double t);
  /// End of the present stretch; infinite where no kink follows [s].
  double stretch_end() const { return end_; }
  void go_to(double t);
  const vessel::CarriageMotion::State& now() const { return moment_.now; }
  const vessel::CarriageMotion::State& acceleration() const { return moment_.acceleration; }

  /// Converts a load on the vessel about its centre of mass `com` (frame G) to the loads at the joint and in the cells.
  vessel::CarriageLoads loads(const Wrench& about_com, const Vec3& com) const;

 private:
  vessel::CarriageMotion motion_;
  std::vector<double> kinks_;
  double within_ = 0, end_ = 0;  ///< a time within the present stretch, and that of its end [s]
  vessel::CarriageMotion::Moment moment_;
  std::optional<Eigen::PartialPivLU<Mat6>> cells_;  ///< factorised matrix whose columns are wrenches of unit tensions
};

}  // namespace nilas::sim
