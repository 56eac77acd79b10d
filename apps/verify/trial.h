#pragma once
/// One run of a scene as a formula looks at it.
#include <memory>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/sim/simulation.h"

namespace nilas {

/// A body at the end of the last step.
struct BodyState {
  Vec3 p, v, w;  ///< centre of mass [m], its velocity [m/s], angular velocity in G [rad/s]
  Quat q;
  double mass;   ///< [kg]
  Mat3 inertia;  ///< about the centre of mass in G [kg m^2]
};

/// A contact of the last step.
struct Touch {
  std::string a, b;
  Vec3 point, normal;  ///< where it was found; from a to b
  double gap;          ///< [m]
  Vec3 force;          ///< on b, impulse / step [N]
};

class Trial {
 public:
  explicit Trial(const Scene& scene, int threads = 1);

  const StepRecord& step();
  void run(long steps);
  double h() const { return h_; }
  const StepRecord& last() const { return last_; }
  const Ledger& initial_ledger() const { return initial_; }
  const SolvedProblem& problem() const { return simulation_->last_problem(); }

  /// Throws ContractError for a name that the scene has not.
  BodyState body(const std::string& name) const;
  std::vector<Touch> touches() const;
  /// Sum of the contact forces of the last step on a body [N].
  Vec3 contact_force_on(const std::string& name) const;
  /// Sum of the forces that `by` put on `on` in the last step [N].
  Vec3 force_between(const std::string& by, const std::string& on) const;

 private:
  std::unique_ptr<WarningCounts> warnings_;
  std::unique_ptr<Simulation> simulation_;
  double h_;
  Ledger initial_;
  StepRecord last_;
};

}  // namespace nilas
