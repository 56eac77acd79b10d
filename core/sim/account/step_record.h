#pragma once
/// The record of one step, for the outputs, and the facts about a run that hold from its start.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact/detect/detector_counts.h"
#include "contact/measure/measure.h"
#include "contact/solved_problem.h"
#include "core/base/error.h"
#include "core/base/math.h"
#include "core/bodies/drawn_sea.h"
#include "core/vessel/model/vessel_model.h"
#include "fracture/model/fracture_event.h"

namespace nilas::sim {

/// Phases of a step, in the order in which they run.
enum class Phase { hydro, detection, assembly, solver, integration, fracture, output };
constexpr int k_num_phases = 7;
const char* to_string(Phase phase);

/// Current energies, and works and losses as sums since the start [J]. Definitions: docs/reference/outputs.md.
struct Ledger {
  double kinetic = 0, potential = 0;
  std::vector<double> works;  ///< one per entry of RunInfo::work_names
  double friction = 0, impact = 0, stabilisation = 0, fracture = 0, crushing = 0, integrator = 0, imbalance = 0;
  double elastic = 0, damping = 0;  ///< energy that elastic contacts store now, and have lost
};

/// The loads on a part of the vessel over the step, frame G. The joint's fields are those of PartState.
struct PartRecord {
  Wrench joint;
  Wrench contact;  ///< contact load about the part's centre of mass, other bodies of the vessel included
  VecX coordinates, rates;
  double unbalanced_force = 0, unbalanced_torque = 0;
};

/// Loads on the vessel over the step (impulse / length), frame G, torques about the centre of mass unless stated. A
/// vessel with parts counts as a whole: loads on hull and parts together, about the hull's centre of mass.
struct VesselRecord {
  Wrench contact;
  Vec3 contact_port = Vec3::Zero(), contact_starboard = Vec3::Zero();  ///< contact force by side of the hull [N]
  std::optional<vessel::CarriageLoads> carriage;
  bool has_cells = false;
  /// The residuals of its contacts as loads (docs/theory/load-error.md): `solver_residual` for the chosen law, as a sum
  /// of absolute values; `law_residual` for exact Coulomb beyond that law, as a signed sum.
  Wrench solver_residual, law_residual;
  std::optional<Wrench> hydro;
  std::vector<Wrench> module_loads;  ///< one per entry of RunInfo::vessel_loads
  vessel::VesselState state;         ///< state at the step's end
  /// Unit vector along the course, horizontal; docs/reference/conventions.md says which way it points.
  Vec2 course = Vec2::UnitX();
  bool touches_ice = false;  ///< true if a floe pressed on it during the step
  Vec3 ice = Vec3::Zero();   ///< the contact force that floes exert, frame G [N]
  std::vector<PartRecord> parts;
  VecX rods;  ///< tension of each rod, positive where it pulls [N]
};

/// Horizontal unit vector to port of the horizontal unit vector `ahead`.
inline Vec2 to_port(const Vec2& ahead) { return {-ahead.y(), ahead.x()}; }

/// Loads over the step on a body that the scene holds fixed, frame G, torques about its centre of mass.
struct StructureRecord {
  Wrench contact;
  bool touches_ice = false;
  Vec3 ice = Vec3::Zero();  ///< the contact force that floes exert [N]
};

/// The ice load of a step, beside that of a second solution of the same contact problems to a strict tolerance, with
/// exact friction cones for pyramids: the force of floes on the vessel, or without one on each structure, frame G [N].
struct LoadCheck {
  std::vector<Vec3> load, strict;
  bool is_strict = true;  ///< true if the second solution reached its tolerance
};

/// A change at a contact at one instant; integrator "reference" only. The first contact of a pair of bodies may stand
/// for several at once.
enum class ContactEventKind { impact, rest, release, stick, slip };
struct ContactEvent {
  double t = 0;  ///< [s]
  ContactEventKind kind = ContactEventKind::impact;
  int a = -1, b = -1;  ///< bodies
  double speed = 0;    ///< speed of approach at an impact [m/s]
};

struct StepRecord {
  long step = 0;  ///< number of the step; the first is 1
  double t = 0;   ///< time at the step's end [s]
  double h = 0;   ///< [s]
  int parts = 0;  ///< number of substeps; counts below are the largest of any substep, iterations the sum
  int floes = 0, contacts = 0, islands = 0, iterations = 0;
  contact::SolveStatus status = contact::SolveStatus::converged;
  bool solver_short = false;        ///< true if the solver missed the scene's tolerance
  std::string solver_message;       ///< the solver's message where it did not converge
  bool positions_corrected = true;  ///< true if the position correction reached its tolerance
  detect::DetectorCounts
      detection;  ///< how pairs were settled, summed over the substeps; not filled by integrator "reference"
  contact::Residuals residuals;
  double penetration_max = 0, penetration_mean = 0;  ///< largest and mean, of gaps < 0 at the step's start [m]
  Ledger ledger;
  double momentum_imbalance = 0, momentum_scale = 0;                  ///< [N s]
  double angular_momentum_imbalance = 0, angular_momentum_scale = 0;  ///< [N m s]
  std::array<double, k_num_phases> ms{};
  std::uint64_t state_hash = 0;
  std::optional<VesselRecord> vessel;
  std::vector<StructureRecord> structures;  ///< same order as RunInfo::structures
  std::optional<LoadCheck> load_check;      ///< in steps whose load is checked and in which ice touches
  std::vector<double> module_values;        ///< same order as RunInfo::module_columns
  std::vector<ContactEvent> events;         ///< sorted by time
  std::vector<fracture::FractureEvent> broken;
};

/// How the course of the vessel is determined. The ice load is reported along and across the course.
enum class CourseKind { carriage, drift, heading };

/// A body that the scene holds fixed.
struct StructureInfo {
  std::string name;
  double length = 0;  ///< largest horizontal extent [m]
};

/// A part of the vessel.
struct PartInfo {
  std::string name;
  JointKind joint = JointKind::hinge;
};

/// The facts about a run that are known when it begins.
struct RunInfo {
  std::string scene_name;
  std::vector<std::string> work_names;                       ///< names of the ledger's columns work_<name>_J
  std::vector<std::pair<std::string, std::string>> modules;  ///< name of each module that was built, and why
  std::vector<std::string> not_built;
  std::vector<std::string> vessel_loads;    ///< modules with columns of their own for their load on the vessel
  std::vector<std::string> module_columns;  ///< columns of steps.csv, in the order of the modules
  std::vector<Fault> warnings;              ///< implausible settings of the scene, with their places
  int floes = 0, bodies = 0;
  double ice_mass = 0;       ///< mass of the free floes [kg]
  double concentration = 0;  ///< ice concentration; 0 without a field
  bool has_vessel = false, has_carriage = false, has_cells = false, has_hydro = false;
  geometry::MassProperties vessel_mass;  ///< centre of mass and inertia in frame V
  /// The carriage's load from the vessel at rest, without current. Empty where no rest was found.
  std::optional<vessel::CarriageLoads> tare;
  double ice_thickness = 0;  ///< [m]
  double vessel_length = 0;  ///< extent along x of V [m]
  CourseKind course = CourseKind::heading;
  Vec2 drift_course = Vec2::UnitX();  ///< direction against the drift around something fixed
  std::optional<double> ramp_end;     ///< time at which the carriage's ramp ends, if it has one [s]
  bool elastic_contacts = false;      ///< true if some pair of materials is elastic
  bool rigid_contacts = true;         ///< true if some ice meets the hull as a rigid body
  std::vector<StructureInfo> structures;
  std::vector<PartInfo> parts;                      ///< the vessel's parts
  std::vector<bodies::DrawnSea> seas;               ///< the waves, for viewers
  std::vector<std::string> rods;                    ///< names of the rods that hold the vessel
  std::optional<std::array<double, 2>> statistics;  ///< the scene's window for statistics: from, to [s]
  long check_every = 0;                             ///< one of so many steps has its load checked; 0: none
  double check_tolerance = 0;                       ///< tolerance of the second solution there [m/s]
  std::optional<double> peak_filter;                ///< the scene's peak filter [s]
};

/// "file:line:column: <element attribute>: message" of each warning.
std::vector<std::string> warning_texts(const RunInfo& info);

}  // namespace nilas::sim
