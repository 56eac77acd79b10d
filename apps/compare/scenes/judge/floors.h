#pragma once
/// Floors: the size up to which an error may be chance.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas::compare {

/// The 95 % limit below which a difference from the reference, averaged over `realisations`, may be chance [N];
/// infinite without degrees of freedom. `reference`: the share of the variance that does not average out [N^2].
double floor_of(double variance, double degrees, int realisations, double reference);

/// The effect of chance on the mean load, from the differences of perturbed runs and the scatter of the settings over
/// realisations. It is zero if the measure is no load.
Chance chance_of(const Plan& plan, const RunTable& rows, const Judges& judges, const std::vector<int>& shared,
                 const std::string& headline, const Measure& measure, const std::vector<Merit>& merits);

/// The floor of a setting that scatters as the others do. For loads it is Student's t limit of the difference of two
/// runs by chance. For motions it is the distance at which the horizon ends.
double common_floor(const std::vector<Merit>& merits, const Judges& judges, const Measure& measure,
                    const Chance& chance, const Horizon& horizon);

/// Sets Merit::floor and Merit::significant. A setting whose differences scatter significantly more than those of the
/// others has a floor from its own scatter.
std::vector<Merit> with_floors(std::vector<Merit> merits, const Judges& judges, const Measure& measure,
                               const Chance& chance, double common);

/// The change of the reference with its step, and whether it is too large.
StepCheck step_check(const RunTable& rows, const Judges& judges, const Measure& measure, const Chance& chance,
                     const std::vector<Merit>& merits);

}  // namespace nilas::compare
