#pragma once
/// The vessel with its carriage and force balance as one Simbody tree, behind plain matrices.
#include <memory>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas {

/// One step is: move_before_impulses() (theta only), begin(), solve contacts, finish(). At a step's end the momenta
/// obey, to rounding,
///   m (v+ - v-) = h (carriage + free) + contact impulse,
///   L+ - L- = h (torques) + contact angular impulse,  L = R I R^T w with each instant's own R.
/// The exception is a free vessel with gyroscopic = false: its angular velocity is kept while it turns, so L is not.
/// On a carriage these equations define the carriage's load, which has no part along the joint's free axes; the
/// gyroscopic term is always kept there. One system belongs to one thread.
class VesselSystem {
 public:
  /// On a carriage, motion.at(before it moves) must be the place of pose_V * joint_V. Throws InputError for a mass,
  /// inertia or force balance that cannot be.
  VesselSystem(const VesselModel& model, double t0);
  ~VesselSystem();
  VesselSystem(VesselSystem&&) noexcept;
  VesselSystem& operator=(VesselSystem&&) noexcept;

  const VesselState& state() const;
  double time() const;
  bool fixed() const;  ///< neither hull nor parts can move
  bool on_carriage() const;
  /// Names of what was built: "vessel", "carriage", "force balance six-cells" ...
  std::vector<std::string> built() const;

  /// On a carriage, before the first step: the static equilibrium of the cells' deflections and of the free axes that
  /// water balances; other free axes stay. So do the joints of parts whose springs, weight or water bring them back.
  /// There is no rest where a free axis carries more than 1 % of the weight unbalanced, as a vessel that falls, where a
  /// part moves as the scene starts it, and without a carriage. `start_there`: moves the vessel to its rest. Throws
  /// InputError when no equilibrium is found.
  VesselRest settle(const RestModel& rest, bool start_there);

  /// The first part of a step of length h [s], up to the pose where loads and contacts act: (1 - theta) h with the
  /// velocities that the vessel has. state() is then that of the middle pose, the carriage's velocity that of its
  /// instant. Nothing moves with semi-implicit Euler. Throws SimulationError as finish() does.
  void move_before_impulses(double h);
  /// Starts a step of length h [s], with theta its impulses, under `free`: weight, hydrodynamic and other loads about
  /// the centre of mass in G, constant over the step. A fixed vessel (or one with no free coordinate) has a block of
  /// size 0 and a prescribed mean twist.
  /// `on_parts`: the same for the parts, as many as there are.
  VesselBlock begin(const Wrench& free, double h, const std::vector<Wrench>& on_parts = {});
  /// Ends it with the contact impulse about the centre of mass where begin() was called, in G [N s, N m s]. Throws
  /// SimulationError when the vessel leaves finite numbers or the joint its range.
  void finish(const Wrench& contact_impulse, const std::vector<Wrench>& on_parts = {});
  /// Takes a step back that move_before_impulses() or begin() has begun, so that another may begin, of another length.
  void abandon_step();
  /// Twist (v; w) of the centre of mass just after the velocity step, before the pose moved: for energy accounts. On a
  /// carriage, where the momenta balance between both poses, the twist at the step's end.
  Vec6 velocity_after_impulses() const;
  /// The same of each part; of a vessel with parts always just after the velocity step.
  std::vector<Vec6> part_velocities_after_impulses() const;
  /// The parts where the vessel is, and their joint loads in the last step.
  const std::vector<PartState>& parts() const;
  /// Of the last step of a vessel with parts or rods.
  const JointAccount& joint_account() const;
  /// Moves a free vessel by a pseudo twist (v; w) over h: position stabilisation. Keeps the velocity and, when
  /// gyroscopic, the angular momentum. No effect on carriage or fixed.
  void displace(const Vec6& pseudo_twist, double h);
  const CarriageLoads& carriage_loads() const;  ///< of the last step
  /// Energy stored in the cells [J].
  double spring_energy() const;
  /// All coordinates and speeds, for the state hash.
  VecX coordinates() const;

  /// Takes over, between two steps, a motion that another integrator found; its next own step is undefined.
  void follow(double t, const VesselState& hull, std::vector<PartState> parts);

  /// Between two steps only.
  void save(StateWriter out) const;
  /// Goes on as the system of the same model that was saved. Throws InputError when the state is one of another.
  void restore(const StateReader& in);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas
