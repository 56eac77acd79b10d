#pragma once
/// One sweep of projected Gauss-Seidel over an island.
#include "contact/solvers/shared/pgs_rows.h"

namespace nilas::solvers {

/// Visits the island's contacts in order (or backwards). Returns the largest |dr_i| W_ii [m/s], or 0 if `track` was
/// off.
using PgsSweep = double (*)(PgsRows& rows, const PgsIsland& island, bool backward);

/// The sweep for a law; `track`: whether the largest change is wanted.
PgsSweep pgs_sweep(Law law, bool track);

/// Visits one contact. Returns its largest |dr_i| W_ii [m/s], or 0 if `track` was off.
using PgsVisit = double (*)(PgsContact& contact, const double* coefficients, double* velocities);

/// The visit that a law's sweep makes.
PgsVisit pgs_visit(Law law, bool track);

/// Adds M^-1 J^T r of the contact's present impulse to the velocities.
void apply_impulse(const PgsContact& contact, PgsRows& rows);

}  // namespace nilas::solvers
