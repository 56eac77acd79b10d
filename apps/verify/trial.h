#pragma once
/// A run of a scene, with the quantities that formulas of cases predict.
#include <memory>
#include <string>
#include <vector>

#include "core/base/log.h"
#include "core/sim/simulation.h"

namespace nilas::verify {

/// The state of a body at the end of the last step.
struct BodyState {
  Vec3 p, v, w;  ///< centre of mass [m], its velocity [m/s] and the angular velocity [rad/s], all in G
  Quat q;
  double mass;   ///< [kg]
  Mat3 inertia;  ///< about the centre of mass in G [kg m^2]
};

/// A contact point of the last step.
struct Touch {
  std::string a, b;
  Vec3 point, normal;  ///< where the contact was found [m]; unit normal from a to b
  double gap;          ///< [m]
  Vec3 force;          ///< force on b: impulse over step [N]
};

/// A run that takes its steps on request and logs nothing.
class Trial {
 public:
  explicit Trial(const scene::Scene& scene, int threads = 1);

  const sim::StepRecord& step();
  void run(long steps);
  double h() const { return h_; }
  const sim::StepRecord& last() const { return last_; }
  const sim::Ledger& initial_ledger() const { return initial_; }
  const contact::SolvedProblem& problem() const { return simulation_->last_problem(); }

  /// Returns the state of a body. Throws ContractError if the scene has no body of this name.
  BodyState body(const std::string& name) const;
  std::vector<Touch> touches() const;
  /// Returns the sum of the contact forces of the last step on a body [N].
  Vec3 contact_force_on(const std::string& name) const;
  /// Returns the sum of the contact forces of body `by` on body `on` in the last step [N].
  Vec3 force_between(const std::string& by, const std::string& on) const;

 private:
  std::unique_ptr<WarningCounts> warnings_;
  std::unique_ptr<sim::Simulation> simulation_;
  double h_;
  sim::Ledger initial_;
  sim::StepRecord last_;
};

}  // namespace nilas::verify
