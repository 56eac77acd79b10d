#pragma once
/// The scene's settings for assembling, solving and correcting contacts.
#include <memory>
#include <optional>

#include "contact/assemble.h"
#include "contact/position_correction.h"
#include "contact/solvers/solver.h"
#include "contact/static_friction.h"
#include "core/choices/contact_choices.h"
#include "core/scene/scene.h"

namespace nilas::sim {

/// The correction of the poses after the step's own motion.
enum class PositionStep { none, split_impulse, projection };

struct ContactModel {
  contact::AssemblySettings assembly;
  contact::CorrectionSettings correction;
  std::unique_ptr<solvers::ContactSolver> solver;  ///< solver "auto" runs after it with on_failure="retry"
  std::optional<contact::StaticFriction>
      static_friction;  ///< if some pair's static coefficient exceeds its kinetic one
  /// One more sweep where the guess already meets the tolerance, if some pair is elastic. Elastic contacts then come to
  /// rest however loose the tolerance is.
  std::unique_ptr<solvers::ContactSolver> sweep_at_rest;
  PositionStep position_step = PositionStep::none;
  double theta = 1;           ///< share of the step's motion that follows the impulses
  bool hit_when_met = false;  ///< true if a contact that would bounce gets no impulse before it touches
  bool warm_start = true;
  bool stop_on_failure = false;
  double tolerance = 0;       ///< tolerance of the solver on law_map_m_s [m/s]
  bool fixed_sweeps = false;  ///< tolerance 0: exactly the scene's number of iterations
  Detection detection = Detection::continuous;
  int most_substeps = 1;  ///< largest number of substeps into which impacts cut a step
  double margin = 0;      ///< detection margin [m]; 0: follows from the speeds

  /// Settings for a substep of length h [s].
  contact::AssemblySettings assembly_over(double h) const;
  contact::CorrectionSettings correction_over(double h) const;
  /// Solves with the contacts that slipped in the last step. Writes the coefficient of each contact to `problem.mu`.
  /// `prepared` is of this `problem`.
  contact::StaticFrictionSolution solve(contact::ContactProblem& problem, const contact::PreparedProblem& prepared,
                                        const VecX& guess, const contact::SlippingContacts& slipped) const;
};

/// Whether some pair of materials has more static than kinetic friction, under a law with friction.
bool has_static_friction(const scene::ContactScene& contact);

/// `speed_scale` multiplies the small speeds that the program sets itself, such as that of an inelastic impact. It is 1
/// at the scale for which they were chosen.
ContactModel build_contact_model(const scene::ContactScene& contact, int threads, double speed_scale = 1);

}  // namespace nilas::sim
