#pragma once
/// How a scene wants its contacts assembled, solved and corrected.
#include <memory>
#include <optional>

#include "contact/assemble.h"
#include "contact/position_correction.h"
#include "contact/solvers/solver.h"
#include "contact/static_friction.h"
#include "core/choices/contact_choices.h"
#include "core/scene/scene.h"

namespace nilas {

/// What moves the poses after the step's own motion.
enum class PositionStep { none, split_impulse, projection };

struct ContactModel {
  AssemblySettings assembly;
  CorrectionSettings correction;
  std::unique_ptr<ContactSolver> solver;          ///< with on_failure="retry" followed by auto
  std::optional<StaticFriction> static_friction;  ///< where some pair's static coefficient is above its kinetic one
  PositionStep position_step = PositionStep::none;
  double theta = 1;           ///< share of the step's motion that follows the impulses
  bool hit_when_met = false;  ///< what can bounce is no contact before it touches
  bool warm_start = true;
  bool stop_on_failure = false;
  double tolerance = 0;       ///< of the solver, on law_map_m_s [m/s]
  bool fixed_sweeps = false;  ///< tolerance 0: as many iterations as the scene says, whatever they reach
  Detection detection = Detection::continuous;
  int most_substeps = 1;  ///< parts that a step is cut into at impacts
  double margin = 0;      ///< [m]; 0: from the speeds

  /// Of a substep of length h [s].
  AssemblySettings assembly_over(double h) const;
  CorrectionSettings correction_over(double h) const;
  /// Solves from the contacts that slipped in the last step. Leaves in `problem.mu` the coefficient that each contact
  /// had.
  StaticFrictionSolution solve(ContactProblem& problem, const VecX& guess, const SlippingContacts& slipped) const;
};

/// Whether some pair of materials has more static than kinetic friction, and the law any friction.
bool has_static_friction(const ContactScene& contact);

ContactModel build_contact_model(const ContactScene& contact, int threads);

}  // namespace nilas
