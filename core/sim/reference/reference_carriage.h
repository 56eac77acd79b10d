#pragma once
/// The carriage as the reference integrator moves it: its motion from kink to kink, and what its load cells read.
#include <optional>
#include <vector>

#include "core/vessel/vessel_system.h"

namespace nilas {

class ReferenceCarriage {
 public:
  explicit ReferenceCarriage(const CarriageModel& model);

  /// From t [s] on the motion is that of the smooth stretch which begins there.
  void begin_stretch(double t);
  /// End of the stretch under way, infinite where no kink follows [s].
  double stretch_end() const { return end_; }
  void go_to(double t);
  const CarriageMotion::State& now() const { return moment_.now; }
  const CarriageMotion::State& acceleration() const { return moment_.acceleration; }

  /// What a load on the vessel about its centre of mass `com`, in G, is at the joint and in the cells.
  CarriageLoads loads(const Wrench& about_com, const Vec3& com) const;

 private:
  CarriageMotion motion_;
  std::vector<double> kinks_;
  double within_ = 0, end_ = 0;  ///< the stretch under way [s]
  CarriageMotion::Moment moment_;
  std::optional<Eigen::PartialPivLU<Mat6>> cells_;  ///< wrench of unit tensions
};

}  // namespace nilas
