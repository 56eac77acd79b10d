#pragma once
/// Energy and momentum accounts of a run. Definitions and signs: docs/reference/outputs.md.
#include <string>
#include <vector>

#include "contact/step_motion.h"
#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas::sim {

/// The loads of one step by source; each entry of the lists belongs to one force module.
struct StepLoads {
  const std::vector<Wrench>* gravity = nullptr;
  std::vector<const std::vector<Wrench>*> conservative;
  std::vector<const std::vector<Wrench>*> working;  ///< one entry per work of the ledger, without the carriage
};

/// Data for the accounts of a vessel on a carriage or with parts. A vessel with parts is booked like the free bodies,
/// from velocity step to velocity step.
struct VesselAccount {
  int index = -1;
  bool on_carriage = false;
  Wrench carriage;  ///< mean load on the vessel about its centre of mass, in G [N, N m]
  Mat3 inertia_before = Mat3::Zero(), inertia_after = Mat3::Zero();  ///< in G at both ends of the step [kg m^2]
  const vessel::JointAccount* joints =
      nullptr;  ///< null without parts; else `index` is the hull and its parts follow it
};

class EnergyAccount {
 public:
  EnergyAccount(const std::vector<std::string>& work_names, double kinetic, double potential);

  /// Books the motion before the impulses: `kinetic` is the kinetic energy after it, `works` the works of carriage and
  /// joints in it.
  void motion_before_impulses(double kinetic, const vessel::JointAccount::Motion& works = {});
  /// Books the works and losses of a velocity step.
  void velocity_step(const bodies::Bodies& bodies, const contact::StepMotion& motion, const StepLoads& loads,
                     const VesselAccount& vessel);
  /// Books the position update. `kinetic` and `potential`: the energies at the step's end. `pseudo`: the velocities of
  /// the stabilisation, along which the conservative loads worked (empty: none). `works`: those of carriage and joints
  /// in the update.
  void position_step(double kinetic, double potential, const contact::Velocities& pseudo,
                     const contact::StepMotion& motion, const StepLoads& loads,
                     const vessel::JointAccount::Motion& works = {});
  /// Books a whole step of the reference integrator: energies at its end, works and losses over it. There is no
  /// integrator_J then: errors of the integration show as imbalance.
  void whole_step(double kinetic, double potential, const std::vector<double>& works, double friction, double impact);
  /// Books the breaking of floes. `kinetic` and `potential`: the energies after it. Returns the energy that left the
  /// bodies [J].
  double breaking(double kinetic, double potential);
  const Ledger& ledger() const { return ledger_; }
  /// Initial kinetic energy plus the sum of absolute works: the scale of imbalance_J [J].
  double energy_put_in() const { return put_in_; }

  void save(StateWriter out) const;
  /// Throws InputError when the state was saved with other works.
  void restore(const StateReader& in);

 private:
  void settle_energies(double kinetic, double potential);
  void book_work(std::size_t k, double work);
  void book_works(const vessel::JointAccount::Motion& works);
  void book_springs(const contact::StepMotion& motion);

  Ledger ledger_;
  std::size_t carriage_ = 0, joints_ = 0;  ///< their indices among the works
  double start_ = 0;                       ///< kinetic + potential energy at the start [J]
  double put_in_ = 0;
  double kinetic_after_velocity_ = 0;
  double conservative_work_ = 0;  ///< work of gravity and the conservative modules in this velocity step [J]
  double potential_before_ = 0;
};

/// Kinetic energy of all bodies that move, and of the water that moves with the free ones [J].
double kinetic_energy(const bodies::Bodies& bodies);
/// Potential energy of weight [J].
double weight_energy(const bodies::Bodies& bodies, const Vec3& gravity);

struct MomentumBalance {
  double linear = 0, linear_scale = 0;    ///< [N s]
  double angular = 0, angular_scale = 0;  ///< about G's origin [N m s]
  MomentumBalance& operator+=(const MomentumBalance& other);
};
/// The change of the momenta in a velocity step minus its impulses, in the configuration where the contacts were found.
MomentumBalance momentum_balance(const bodies::Bodies& bodies, const contact::StepMotion& motion,
                                 const StepLoads& loads, const VesselAccount& vessel);

}  // namespace nilas::sim
