#pragma once
/// The integrator of the vessel: one class per kind of support, each with the step of vessel_system.h.
#include <memory>

#include "core/base/state.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

class VesselMotion {
 public:
  VesselMotion(const VesselModel& model, double t0);
  virtual ~VesselMotion() = default;

  void move_before_impulses(double h);
  VesselBlock begin(const Wrench& free, double h, const std::vector<Wrench>& on_parts);
  void finish(const Wrench& contact_impulse, const std::vector<Wrench>& on_parts);
  void abandon_step();

  virtual Vec6 velocity_after_impulses() const = 0;
  virtual void displace(const Vec6& pseudo_twist, double h) = 0;
  virtual double spring_energy() const { return 0; }
  /// The counterpart of VesselSystem::settle(); does nothing without a carriage.
  virtual VesselRest settle(const RestModel&, bool /*start_there*/) { return {}; }
  virtual VecX coordinates() const = 0;
  virtual bool can_move() const { return true; }
  virtual std::vector<Vec6> part_velocities_after_impulses() const { return {}; }

  const VesselState& state() const { return state_; }
  const CarriageLoads& loads() const { return loads_; }
  const std::vector<PartState>& parts() const { return parts_; }
  const JointAccount& joint_account() const { return joint_account_; }
  double time() const { return time_; }

  void follow(double t, const VesselState& hull, std::vector<PartState> parts);

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 protected:
  virtual void move_before_step(double /*h*/) {
  }                                 ///< motion over a step of length h [s]; nothing with semi-implicit Euler
  virtual void abandon_motion() {}  ///< returns to the start of the step
  virtual VesselBlock begin_step() = 0;
  virtual void finish_step(const Wrench& contact_impulse) = 0;
  /// Saves everything beyond state and time that the next step depends on.
  virtual void save_motion(StateWriter& out) const = 0;
  virtual void restore_motion(const StateReader& in) = 0;

  Mat3 inertia_G() const;                            ///< R I R^T at the present pose
  Vec3 turning(const Vec3& angular_momentum) const;  ///< angular velocity for this angular momentum at the present pose

  geometry::MassProperties mass_;  ///< inertia about the centre of mass, axes of V
  Eigen::LLT<Mat3> inertia_factor_;
  VesselState state_;
  CarriageLoads loads_;
  std::vector<PartState> parts_;
  JointAccount joint_account_;
  double time_;                                           ///< end of the last step [s]
  Wrench free_;                                           ///< loads of the present step
  std::vector<Wrench> free_on_parts_, contact_on_parts_;  ///< loads of the present step
  double h_ = 0;                                          ///< length of the present step [s]; 0 between steps

 private:
  double moved_for_ = 0;  ///< length of a step whose first motion is done [s]; 0 between steps
  bool moves_before_;
};

std::unique_ptr<VesselMotion> make_free_vessel(const VesselModel& model, double t0);
/// Throws InputError when the force balance cannot hold the vessel.
std::unique_ptr<VesselMotion> make_carried_vessel(const VesselModel& model, double t0);
/// A hull with parts or rods, for every kind of support. Throws InputError for an impossible part, rod or carriage.
std::unique_ptr<VesselMotion> make_jointed_vessel(const VesselModel& model, double t0);

}  // namespace nilas::vessel
