#pragma once
/// A hydrodynamic database at another scale.
#include "hydro/database/database.h"

namespace nilas::hydro {

/// The database of a body that is `lambda` times as large, in the same water, by Froude's law: lengths times lambda,
/// times and velocities times its root, forces times its cube. With a power of 4, every value changes by a power of 2.
Database scaled(Database database, double lambda);

}  // namespace nilas::hydro
