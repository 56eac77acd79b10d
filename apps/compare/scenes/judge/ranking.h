#pragma once
/// Which settings of a comparison are worth their time.
#include "apps/compare/scenes/judge/merits.h"

namespace nilas {

/// Marks the settings that another beats: no slower and no worse, and better in one of both. Errors below the floor are
/// all alike.
void rank(Findings& found);

/// The fastest that is good enough; of those that are as fast by all that times tell, the most accurate, and the
/// scene's own setting where that is one of them.
void choose(Findings& found);

/// The p of errors C h^p, where three steps or more tell an error and the rest is the same; of errors C (h^p - r^p)
/// where the reference is of the same integrator and has a step r itself.
void find_orders(const Plan& plan, Findings& found);

/// Whether any setting has a difference from what judges it.
bool anything_told(const Findings& found);

}  // namespace nilas
