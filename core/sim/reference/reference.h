#pragma once
/// Reference motion of free rigid bodies: smooth stretches are integrated with high order. They end at the instants
/// where contacts close, open, stick or slip. Method and limits: docs/theory/dynamics.md.
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "contact/step_motion.h"
#include "core/numerics/event_ode.h"
#include "core/sim/account/step_record.h"
#include "core/sim/reference/reference_contacts.h"
#include "core/sim/reference/reference_state.h"
#include "core/sim/world/contact_model.h"
#include "core/sim/world/world.h"

namespace nilas::sim {

/// The record of one output step.
struct ReferenceStep {
  ReferenceAccount account;
  std::vector<ContactEvent> events;
  int contacts = 0;  ///< number of contacts that stay closed at the end
  int iterations = 0;
  contact::SolveStatus status = contact::SolveStatus::converged;  ///< the worst of all impacts
  std::string message;
  contact::Residuals residuals;           ///< those of the impact with the largest law_map_m_s
  contact::SolvedProblem impact;          ///< problem of the last impact
  std::vector<detect::ContactPoint> met;  ///< contacts that closed in the step or stay closed
};

class ReferenceIntegrator {
 public:
  /// Moves the bodies of `parts`; impacts follow `model`. Throws InputError where too many contacts are closed.
  ReferenceIntegrator(const scene::Scene& scene, int threads, WorldParts& parts, const ContactModel& model);

  /// Advances from t0 to t1 [s]. Throws SimulationError where the motion cannot be followed.
  ReferenceStep advance(double t0, double t1);
  /// Hull and parts in their present state, with the joint loads at the instant `t` [s]. Only for a vessel that moves.
  std::vector<vessel::PartState> parts_now(double t);
  /// Whether a free or towed vessel moves, so that its momenta are in the account.
  bool accounts_for_vessel() const { return vessel_ && vessel_->has_known_loads(); }
  bool has_vessel() const { return vessel_.has_value(); }

 private:
  bodies::Wrenches free_loads(double t);
  ReferenceLoads loads(double t);
  void watch(double t, VecX& g);
  void begin_smooth_motion(double t0, double longest_step);
  numerics::OdeStop follow(double t1, VecX& y);
  void settle(double t, ReferenceStep& step, const std::vector<std::uint64_t>& ended = {});
  std::vector<std::uint64_t> ended_by(const std::vector<int>& events) const;
  bool enter_stretch(double t, ReferenceStep& step);
  void impact(double t, std::vector<detect::ContactPoint> points, ReferenceStep& step);
  void book(const ContactImpulses& impulses, const contact::Velocities& before, ReferenceAccount& account) const;
  void book_carriage(const Wrench& contact, const contact::Velocities& before, ReferenceAccount& account) const;
  std::size_t carriage_work() const;
  void add_to_vessel(const detect::ContactPoint& c, const Vec3& on_b, ReferenceVesselLoads& sum) const;
  void add_module_loads(std::size_t body, ReferenceVesselLoads& sum) const;
  bool moves(int body) const;
  void set_levels(const std::vector<detect::ContactPoint>& points);
  double approach(const detect::ContactPoint& point) const;
  bool sunk();
  void count_standstill(double t);

  WorldParts& parts_;
  const ContactModel& model_;
  contact::SlippingContacts slipped_;  ///< contacts that slipped at the last impact
  Vec3 gravity_;
  std::optional<ReferenceVessel> vessel_;
  ReferenceVesselLoads no_vessel_loads_;
  ReferenceState state_;
  SustainedContacts contacts_;
  SustainedForces sustained_;                   ///< result of the last call to loads()
  std::vector<bodies::Wrenches> module_loads_;  ///< result of the last call to free_loads()
  contact::AssemblySettings impact_settings_;
  double rest_speed_;                      ///< normal speeds below this count as rest [m/s]
  std::map<std::uint64_t, double> level_;  ///< gap at which an open point closes, by key, where it is not zero [m]
  std::optional<numerics::OdeSolution> smooth_;  ///< solution of the motion since the last event
  double smooth_start_ = 0;                      ///< [s]
  VecX accounted_;                               ///< state of `smooth_` when the account was last read
  bool settled_ = false;
  double last_event_ = 0;
  int standstill_ = 0;  ///< number of consecutive events at one instant
};

}  // namespace nilas::sim
