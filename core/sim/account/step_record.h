#pragma once
/// What one step leaves for the outputs.
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
#include "core/vessel/model/vessel_model.h"
#include "fracture/model/fracture_event.h"

namespace nilas {

/// Phases of a step, in the order they run.
enum class Phase { hydro, detection, assembly, solver, integration, fracture, output };
constexpr int k_num_phases = 7;
const char* to_string(Phase phase);

/// Energies now and works and losses as sums since the start [J]. Definitions: docs/reference/outputs.md.
struct Ledger {
  double kinetic = 0, potential = 0;
  std::vector<double> works;  ///< one per entry of RunInfo::work_names
  double friction = 0, impact = 0, stabilisation = 0, fracture = 0, crushing = 0, integrator = 0, imbalance = 0;
};

/// A part of the vessel over the step, in G. The joint's fields are those of PartState.
struct PartRecord {
  Wrench joint;
  Wrench contact;  ///< about the part's centre of mass, other bodies of the vessel included
  VecX coordinates, rates;
  double unbalanced_force = 0, unbalanced_torque = 0;
};

/// Loads on the vessel over the step (impulse / length), in G, torques about the centre of mass unless said. With
/// parts: on hull and parts together, about the hull's centre of mass.
struct VesselRecord {
  Wrench contact;
  Vec3 contact_port = Vec3::Zero(), contact_starboard = Vec3::Zero();  ///< its force by side of the hull [N]
  std::optional<CarriageLoads> carriage;
  bool has_cells = false;
  /// What its contacts' residuals amount to (docs/theory/load-error.md): of the law that was asked, the sum of their
  /// absolute values; of exact Coulomb beyond that law, the signed sum.
  Wrench solver_residual, law_residual;
  std::optional<Wrench> hydro;
  VesselState state;  ///< at the step's end
  /// Unit vector along the course, horizontal; docs/reference/conventions.md says which way it points.
  Vec2 course = Vec2::UnitX();
  bool touches_ice = false;  ///< a floe pressed on it during the step
  Vec3 ice = Vec3::Zero();   ///< the part of the contact force that floes exert, in G [N]
  std::vector<PartRecord> parts;
  VecX rods;  ///< tension of each rod, positive where it pulls [N]
};

/// Horizontal unit vector to port of a horizontal one.
inline Vec2 to_port(const Vec2& ahead) { return {-ahead.y(), ahead.x()}; }

/// Loads over the step on a body that the scene holds fixed, in G, torques about its centre.
struct StructureRecord {
  Wrench contact;
  bool touches_ice = false;
  Vec3 ice = Vec3::Zero();  ///< the part of the contact force that floes exert [N]
};

/// What changed at a contact at one instant; integrator "reference" only. The first contact of a pair of bodies may
/// stand for several at once.
enum class ContactEventKind { impact, rest, release, stick, slip };
struct ContactEvent {
  double t = 0;  ///< [s]
  ContactEventKind kind = ContactEventKind::impact;
  int a = -1, b = -1;  ///< bodies
  double speed = 0;    ///< of approach at an impact [m/s]
};

struct StepRecord {
  long step = 0;  ///< 1 for the first
  double t = 0;   ///< at the step's end [s]
  double h = 0;   ///< [s]
  int parts = 0;  ///< that the step was cut into at impacts; the counts are the largest of them, iterations their sum
  int floes = 0, contacts = 0, islands = 0, iterations = 0;
  SolveStatus status = SolveStatus::converged;
  bool solver_short = false;        ///< the solver missed the tolerance that the scene asks for
  std::string solver_message;       ///< what the solver says where it did not converge
  bool positions_corrected = true;  ///< the split impulse reached its tolerance
  DetectorCounts detection;         ///< how pairs were settled, summed over the parts; none by the reference
  Residuals residuals;
  double penetration_max = 0, penetration_mean = 0;  ///< over contact points with gap < 0 at the step's start [m]
  Ledger ledger;
  double momentum_imbalance = 0, momentum_scale = 0;                  ///< [N s]
  double angular_momentum_imbalance = 0, angular_momentum_scale = 0;  ///< [N m s]
  std::array<double, k_num_phases> ms{};
  std::uint64_t state_hash = 0;
  std::optional<VesselRecord> vessel;
  std::vector<StructureRecord> structures;  ///< in the order of RunInfo::structures
  std::vector<double> module_values;        ///< in the order of RunInfo::module_columns
  std::vector<ContactEvent> events;         ///< in the order of time
  std::vector<FractureEvent> broken;
};

/// How the course of the vessel is found, the axis along which its ice load is told.
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

/// What is known when a run begins.
struct RunInfo {
  std::string scene_name;
  std::vector<std::string> work_names;                       ///< ledger columns work_<name>_J
  std::vector<std::pair<std::string, std::string>> modules;  ///< what was built and why
  std::vector<std::string> not_built;
  std::vector<std::string> module_columns;  ///< of steps.csv, in the order of the modules
  std::vector<Fault> warnings;              ///< what the scene can hardly mean, with places
  int floes = 0, bodies = 0;
  double ice_mass = 0;       ///< of free floes [kg]
  double concentration = 0;  ///< 0 when there is no field
  bool has_vessel = false, has_carriage = false, has_cells = false, has_hydro = false;
  MassProperties vessel_mass;  ///< com, inertia in V
  /// What the carriage carries of the vessel at rest, without current; nothing where no rest was found.
  std::optional<CarriageLoads> tare;
  double ice_thickness = 0;  ///< [m]
  double vessel_length = 0;  ///< along x of V [m]
  CourseKind course = CourseKind::heading;
  Vec2 drift_course = Vec2::UnitX();  ///< against the drift of ice or water where a vessel or structure is fixed
  std::optional<double> ramp_end;     ///< of a carriage with a ramp [s]
  bool rigid_contacts = true;         ///< some ice meets the hull as a rigid body
  std::vector<StructureInfo> structures;
  std::vector<PartInfo> parts;                      ///< of the vessel
  std::vector<std::string> rods;                    ///< names of those that hold the vessel
  std::optional<std::array<double, 2>> statistics;  ///< window that the scene asks for: from, to [s]
  std::optional<double> peak_filter;                ///< that the scene asks for [s]
};

/// "file:line:column: <element attribute>: message" of each warning.
std::vector<std::string> warning_texts(const RunInfo& info);

}  // namespace nilas
