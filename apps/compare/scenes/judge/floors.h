#pragma once
/// Floors: the size up to which an error may be chance.
#include "apps/compare/scenes/judge/findings.h"

namespace nilas {

/// Limit below which a difference from the reference, averaged over so many realisations, may be chance with 95 % [N];
/// infinite without degrees of freedom. `reference`: the part of the variance that does not average out [N^2].
double floor_of(double variance, double degrees, int realisations, double reference);

/// From the differences of perturbed runs and the scatter of the settings over realisations; zero where loads are not
/// what is measured.
Chance chance_of(const Plan& plan, const RunTable& rows, const Judges& judges, const std::vector<int>& shared,
                 const std::string& headline, const Measure& measure, const std::vector<Merit>& merits);

/// Floor of a setting that scatters as the others do. Of loads by Student's t on what chance gives to two runs; of
/// motions the distance at which the horizon ends, below which they part by less.
double common_floor(const std::vector<Merit>& merits, const Judges& judges, const Measure& measure,
                    const Chance& chance, const Horizon& horizon);

/// Sets Merit::floor and Merit::significant. A setting whose differences scatter significantly more than those of the
/// others is held to its own scatter.
std::vector<Merit> with_floors(std::vector<Merit> merits, const Judges& judges, const Measure& measure,
                               const Chance& chance, double common);

/// How far the reference moves with its step, and whether that is too much.
StepCheck step_check(const RunTable& rows, const Judges& judges, const Measure& measure, const Chance& chance,
                     const std::vector<Merit>& merits);

}  // namespace nilas
