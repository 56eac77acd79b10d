#pragma once
/// Values of <contact>.
#include <optional>
#include <string>
#include <vector>

#include "core/choices/contact_choices.h"
#include "core/choices/defaults.h"
#include "core/choices/solver_name.h"

namespace nilas::scene {

struct FrictionScene {
  std::string material_a = "*", material_b = "*";
  double static_ = 0, kinetic = 0, rolling = 0, spinning = 0, restitution = 0;
  bool elastic = false;
  std::optional<double> stiffness;         ///< normal stiffness of a patch; empty: that of the ice's edges [N/m]
  double edge_factor = 0.5;                ///< stiffness of an ice edge over Young's modulus times thickness
  std::optional<double> tangential_ratio;  ///< tangential over normal stiffness; empty: by Poisson's ratio
  double damping_ratio = 0.5;              ///< 1 is critical

  bool operator==(const FrictionScene&) const = default;
};

struct ContactScene {
  ParsedLaw law;
  SolverName solver = SolverName::automatic;
  double tolerance = defaults::k_tolerance;  ///< law_map_m_s; 0: always max_iterations sweeps
  int max_iterations = defaults::k_max_iterations;
  int substeps = 0;  ///< largest number of substeps into which impacts cut a step
  OnFailure on_failure = OnFailure::record;
  Integrator integrator = Integrator::moreau;
  double theta = 0.5;
  Stabilisation stabilisation = Stabilisation::projection;
  double erp = 0.2;        ///< share of the penetration removed per step
  double slop = 0;         ///< penetration that is not corrected [m]
  double max_speed = 1.0;  ///< largest speed of the correction [m/s]
  Detection detection = Detection::continuous;
  NarrowPhase narrow_phase = NarrowPhase::nilas;
  double margin = 0;  ///< largest gap of contacts [m]; 0: the distance that bodies can move in the step
  bool gyroscopic = true;
  double axes_deg = 0;  ///< turns the contact tangents about the normal
  bool warm_start = true;
  std::optional<ContactPreset> preset;
  std::vector<FrictionScene> friction;

  bool operator==(const ContactScene&) const = default;
};

}  // namespace nilas::scene
