#pragma once
/// One physical model of a scene, as the time step calls it. A module implements the phases that it needs; all others
/// do nothing. core/sim/build/module_list.h lists the modules that a scene can name.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/state.h"
#include "core/bodies/bodies.h"
#include "core/bodies/drawn_line.h"

namespace nilas::contact {
struct StepMotion;
}  // namespace nilas::contact

namespace nilas::detect {
struct ContactPoint;
}  // namespace nilas::detect

namespace nilas::fracture {
struct NewPiece;
struct StepEnd;
}  // namespace nilas::fracture

namespace nilas::bodies {

/// One wrench per body, about its centre of mass, in G.
using Wrenches = std::vector<Wrench>;

/// Pairs of bodies a < b, by their indices.
using BodyPairs = std::vector<std::pair<int, int>>;

/// The length of a substep as a module needs it.
struct SubstepLength {
  double h = 0;      ///< the impulses act over this time [s]
  double ahead = 0;  ///< the share of it in which bodies move after the impulses [s]
};

/// How the outputs show the loads of a module on the vessel: not at all, since it never acts on one; within hydro_*, as
/// loads of the water; or in columns of its own, <name>_f* and <name>_m*.
enum class VesselLoad { none, water, own };

/// The names of the sums over a run that outputs ask for, whichever modules a scene has.
inline constexpr std::string_view k_crushed_mass = "crushed_mass";    ///< ice that vessel and bodies crushed [kg]
inline constexpr std::string_view k_brash_mass = "brash_mass";        ///< pieces too small to be bodies [kg]
inline constexpr std::string_view k_extruded_mass = "extruded_mass";  ///< crushed ice cut out of its floes [kg]
inline constexpr std::array k_run_sums{k_crushed_mass, k_brash_mass, k_extruded_mass};
/// A figure of the whole run that a module gives at its end, for summary.json and the closing account.
struct RunFigure {
  std::string name;   ///< key with its unit, such as advance_m
  double value = 0;   ///< in that unit
  std::string label;  ///< at most 20 characters: advance; empty: the closing account leaves it out
  std::string text;   ///< the value in words, with what it is compared with
};
/// The name of the value of one body that outputs ask for: the largest damage at any place of a floe [-].
inline constexpr std::string_view k_damage = "damage";

class Module {
 public:
  virtual ~Module() = default;
  /// Name in the list of built modules, in the ledger's column work_<name>_J and in checkpoints.
  virtual std::string name() const = 0;

  // Loads other than contact.

  /// True when the phases of this group are called; the work of such a module has a column unless it is conservative.
  virtual bool exerts_loads() const { return false; }
  /// True when the loads derive from potential_energy().
  virtual bool conservative() const { return false; }
  virtual VesselLoad load_on_vessel() const { return VesselLoad::own; }
  /// The velocity to which the loads bring free ice [m/s]; zero where they set bodies in motion but at no one velocity;
  /// nothing where they set none in motion, or where the scene states that motion elsewhere (a <current>). Load axes
  /// and the checks of a scene depend on it.
  virtual std::optional<Vec3> drift() const { return std::nullopt; }
  /// Adds this module's wrenches at time t [s] for the present poses and velocities. `out` has one entry per body.
  virtual void add_forces(const Bodies& /*bodies*/, double /*t*/, Wrenches& /*out*/) {}
  /// Reduces its own wrenches (`out` holds no others) to those that are stable in an explicit step of length h [s]. By
  /// default keeps all.
  virtual void limit(const Bodies& /*bodies*/, double /*h*/, Wrenches& /*out*/) const {}
  /// Potential energy of the present poses [J]; zero for a module that is not conservative.
  virtual double potential_energy(const Bodies& /*bodies*/) { return 0; }

  // Water that moves with bodies.

  /// The added mass of the hull about its centre of mass, in body axes, as in Bodies::added_mass_B; nothing where this
  /// module gives none. One module of a scene may give it. Its reaction on the hull, with the terms of Kirchhoff's
  /// equations that are quadratic in the velocities, counts as a load of this module, which must exert loads.
  virtual std::optional<Mat6> vessel_added_mass() const { return std::nullopt; }
  /// The added mass of free bodies; empty where this module gives none. One module of a scene may give it.
  virtual AddedMassOf added_mass_of_bodies() const { return {}; }

  // Contacts.

  /// True when owns_pair() may be true of some pair.
  virtual bool owns_pairs() const { return false; }
  /// True when the contact of two bodies is this module's: detection finds no rigid contact between them. Called from
  /// several threads.
  virtual bool owns_pair(int /*a*/, int /*b*/) const { return false; }
  /// Appends contact points of its own at the present poses. `near`: the pairs that it owns and that may touch within
  /// the substep. A second call at the same poses must remember the same as the first.
  virtual void add_contacts(const Bodies& /*bodies*/, const BodyPairs& /*near*/, const SubstepLength& /*length*/,
                            std::vector<detect::ContactPoint>& /*points*/) {}
  /// Adds to the first guess of the impulses (3 per contact, in the contacts' frames; points first), once [N s].
  virtual void add_to_guess(const Bodies& /*bodies*/, const std::vector<detect::ContactPoint>& /*points*/,
                            const std::vector<Mat3>& /*frames*/, VecX& /*guess*/) {}
  /// The impulses of the substep are found: a guess that was not asked for is of no more use.
  virtual void end_guess() {}

  // State over the step.

  /// A step begins.
  virtual void begin_step() {}
  /// Remembers what add_contacts() changes, and goes back to it where the substep is taken back. Called only where a
  /// substep moves bodies before contacts are searched: with theta < 1 and continuous detection.
  virtual void remember() {}
  virtual void go_back() {}
  /// A substep was taken: its velocities, impulses and points.
  virtual void note_motion(const Bodies& /*bodies*/, const contact::StepMotion& /*motion*/) {}
  /// A substep of length h [s] that ended at t [s] was taken. Bodies are at its end. A module with a state of its own,
  /// such as the memory of waves or a controller, goes on by h here.
  virtual void end_substep(const Bodies& /*bodies*/, double /*t*/, double /*h*/) {}
  /// The step is over: floes may break. See fracture/model/step_end.h.
  virtual void end_step(fracture::StepEnd& /*end*/) {}
  /// Bodies came or went; `pieces`: those that came in the place of a floe.
  virtual void follow(const Bodies& /*bodies*/, const std::vector<fracture::NewPiece>& /*pieces*/) {}

  // Outputs.

  /// Names of this module's columns in steps.csv, with their units.
  virtual std::vector<std::string> columns() const { return {}; }
  /// Appends as many values, of the step that ended.
  virtual void append_values(std::vector<double>& /*values*/) const {}
  /// A sum over the run by its name: one of k_run_sums, or of the module's own. Empty where the module has no such sum.
  virtual std::optional<double> total(std::string_view /*name*/) const { return std::nullopt; }
  /// A value of one body, by its id: k_damage, or one of the module's own. Empty where the module has no such value.
  virtual std::optional<double> of_body(std::string_view /*name*/, std::int64_t /*id*/) const { return std::nullopt; }
  /// What pictures show of this module at the present poses.
  virtual std::vector<DrawnLine> drawn(const Bodies& /*bodies*/) const { return {}; }
  /// Figures of the run so far. Their keys in summary.json stand under the module's name.
  virtual std::vector<RunFigure> figures() const { return {}; }

  // Checkpoints, between two steps. What follows from scene and poses is not in them.

  virtual void save(const Bodies& /*bodies*/, StateWriter /*out*/) const {}
  /// Puts the bodies there that were there when saved, before their poses are read.
  virtual void restore_bodies(const StateReader& /*in*/, Bodies& /*bodies*/) {}
  virtual void restore(const StateReader& /*in*/) {}
};

/// A module that exerts loads.
class ForceModule : public Module {
 public:
  bool exerts_loads() const final { return true; }
  void add_forces(const Bodies& bodies, double t, Wrenches& out) override = 0;
};

}  // namespace nilas::bodies
