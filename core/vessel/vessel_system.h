#pragma once
/// The vessel with its carriage and force balance as one Simbody tree, behind plain matrices.
#include <memory>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

/// One step is: move_before_impulses() (theta only), begin(), solve contacts, finish(). At a step's end the momenta
/// obey, to rounding,
///   m (v+ - v-) = h (carriage + free) + contact impulse,
///   L+ - L- = h (torques) + contact angular impulse,  L = R I R^T w with each instant's own R.
/// The exception is a free vessel with gyroscopic = false: its angular velocity is kept while it turns, so L is not.
/// On a carriage these equations define the carriage's load, which has no part along the joint's free axes; the
/// gyroscopic term is always kept there. One system belongs to one thread.
class VesselSystem {
 public:
  /// Builds the vessel at t0 [s]. On a carriage, motion.at() before it moves must give the place of pose_V * joint_V.
  /// Throws InputError for an impossible mass, inertia or force balance.
  VesselSystem(const VesselModel& model, double t0);
  ~VesselSystem();
  VesselSystem(VesselSystem&&) noexcept;
  VesselSystem& operator=(VesselSystem&&) noexcept;

  const VesselState& state() const;
  double time() const;
  bool fixed() const;  ///< true if neither hull nor parts can move
  bool on_carriage() const;
  /// Names of what was built: "vessel", "carriage", "force balance six-cells" ...
  std::vector<std::string> built() const;

  /// Searches the rest on a carriage, before the first step: the static equilibrium of the cells' deflections, of free
  /// axes that water balances, and of joints that springs, weight or water restore. Other free axes stay. There is no
  /// rest where a free axis carries more than 1 % of the weight unbalanced (a falling vessel), where a part has an
  /// initial rate, and without a carriage. `start_there`: moves the vessel to its rest. Throws InputError when no
  /// equilibrium is found.
  VesselRest settle(const RestModel& rest, bool start_there);

  /// First motion of a step of length h [s], up to the pose where loads and contacts act: (1 - theta) h with the
  /// present velocities. Afterwards state() is that of the middle pose, and the carriage's velocity that of its
  /// instant. Nothing moves with semi-implicit Euler. Throws SimulationError as finish() does.
  void move_before_impulses(double h);
  /// Starts a step of length h [s] (with theta: its impulses) under `free`: weight, hydrodynamic and other loads about
  /// the centre of mass in G, constant over the step. `on_parts`: the same for each part. A fixed vessel, or one
  /// without a free coordinate, has a block of size 0 and a prescribed mean twist.
  VesselBlock begin(const Wrench& free, double h, const std::vector<Wrench>& on_parts = {});
  /// Ends the step with the contact impulse about the centre of mass where begin() was called, frame G [N s, N m s].
  /// Throws SimulationError when a value is not finite or the joint leaves its range.
  void finish(const Wrench& contact_impulse, const std::vector<Wrench>& on_parts = {});
  /// Undoes a step that move_before_impulses() or begin() has begun, so that a step of another length can begin.
  void abandon_step();
  /// Twist (v; w) of the centre of mass just after the velocity step, before the pose moves, for energy accounts. On a
  /// carriage it is the twist at the step's end, because the momenta are balanced between both poses.
  Vec6 velocity_after_impulses() const;
  /// The same for each part; in a vessel with parts always just after the velocity step.
  std::vector<Vec6> part_velocities_after_impulses() const;
  /// The parts in their present state, with their joint loads in the last step.
  const std::vector<PartState>& parts() const;
  /// Account of the last step of a vessel with parts or rods.
  const JointAccount& joint_account() const;
  /// Moves a free vessel by a pseudo twist (v; w) over h, for position stabilisation. Keeps the velocity and, when
  /// gyroscopic, the angular momentum. Has no effect on a carriage or a fixed vessel.
  void displace(const Vec6& pseudo_twist, double h);
  const CarriageLoads& carriage_loads() const;  ///< loads of the last step
  /// Energy stored in the cells [J].
  double spring_energy() const;
  /// All coordinates and speeds, for the state hash.
  VecX coordinates() const;

  /// Adopts a motion that another integrator found, between two steps. The next own step is undefined.
  void follow(double t, const VesselState& hull, std::vector<PartState> parts);

  /// Saves the state; only between two steps.
  void save(StateWriter out) const;
  /// Continues as the saved system of the same model. Throws InputError when the state belongs to another model.
  void restore(const StateReader& in);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas::vessel
