#pragma once
/// A database with made-up coefficients for tests of excitation and drift.
#include <cmath>
#include <complex>

#include "hydro/database/database.h"

namespace nilas::test {

/// Frequencies 0.5, 1.0 and 1.5 rad/s; headings from 0 to `last` in equal steps. Excitations are smooth in both; sway,
/// roll and yaw vanish for headings 0 and pi. Drift is positive in surge and grows with the frequency.
inline hydro::Database synthetic_database(double last = k_pi, int headings = 7) {
  hydro::Database database;
  database.source = "made-up";
  database.density = 1000;
  database.gravity = 9.81;
  database.frequency = {0.5, 1.0, 1.5};
  for (int k = 0; k < headings; ++k) database.heading.push_back(last * k / (headings - 1));
  for (const double w : database.frequency) {
    database.added_mass.push_back(Mat6::Identity());  // of a body with equal sides
    auto& excitation = database.excitation.emplace_back();
    auto& drift = database.drift.emplace_back();
    for (const double b : database.heading) {
      const double c = std::cos(b), s = std::sin(b);
      hydro::ComplexVec6 x;
      x << std::complex(20 * c, 100 * w * c), std::complex(15 * s, 80 * w * s), std::complex(500 - 100 * w, 30 * c),
          std::complex(5 * s, -40 * w * s), std::complex(-60 * w * c, 10 * c), std::complex(7 * s * c, 9 * w * s * c);
      excitation.push_back(x);
      Vec6 d;
      d << 4 * w * c, 3 * w * s, -w, 0.1 * s, 0.2 * c, 0.3 * w * s * c;
      drift.push_back(d);
    }
  }
  return database;
}

}  // namespace nilas::test
