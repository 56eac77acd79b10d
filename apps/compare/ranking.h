#pragma once
/// Which settings of a comparison are worth their time.
#include "apps/compare/merits.h"

namespace nilas {

/// Marks the settings that another beats: no slower and no worse, and better in one of both. Errors below the floor are
/// all alike.
void rank(Findings& found);

/// The fastest that is good enough; of those that are as fast by all that times tell, the most accurate, and the
/// scene's own setting where that is one of them.
void choose(Findings& found);

/// Slopes of log error over log step, where three steps or more tell an error and the rest is the same.
void find_orders(const Plan& plan, Findings& found);

}  // namespace nilas
