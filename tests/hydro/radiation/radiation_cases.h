#pragma once
/// Databases for tests of radiation: one whose retardation function has a closed form, and the sphere of HydroChrono.
#include <array>
#include <complex>
#include <filesystem>

#include "hydro/database/read_database.h"

namespace nilas::hydro::radiation_cases {

/// H(s) = s (s^2 + 4 s + 4) / ((s^2 + s + 1)(s^2 + 3 s + 4)).
/// The denominator is s^4 + 4 s^3 + 8 s^2 + 7 s + 4, so
///   Re H(i w) = w^2 (9 w^2 + 12) / |D(i w)|^2 >= 0,
/// which falls as 9 w^-4, and H(0) = 0. Its poles are s = -1/2 +- i sqrt(3)/2 and -3/2 +- i sqrt(7)/2.
inline std::complex<double> closed_transform(std::complex<double> s) {
  return s * (s * s + 4.0 * s + 4.0) / ((s * s + s + 1.0) * (s * s + 3.0 * s + 4.0));
}
inline std::array<std::complex<double>, 2> closed_poles() {
  return {std::complex<double>(-0.5, 0.5 * std::sqrt(3)), std::complex<double>(-1.5, 0.5 * std::sqrt(7))};
}
/// Its retardation function: twice the real part of residue times exponential, summed over the two upper poles p. The
/// residue is N(p) / D'(p).
inline double closed_retardation(double t) {
  double sum = 0;
  for (const auto& p : closed_poles()) {
    const std::complex<double> slope = 4.0 * p * p * p + 12.0 * p * p + 16.0 * p + 7.0;
    sum += 2 * (p * (p * p + 4.0 * p + 4.0) / slope * std::exp(p * t)).real();
  }
  return sum;
}

/// Heave with 1000 H; surge and pitch with [400 600; 600 2500] H, which is positive definite. A_inf is 5000 times the
/// identity.
inline Mat6 closed_matrix() {
  Mat6 m = Mat6::Zero();
  m(2, 2) = 1000;
  m(0, 0) = 400;
  m(0, 4) = m(4, 0) = 600;
  m(4, 4) = 2500;
  return m;
}
inline Database closed_database() {
  Database database;
  database.source = "closed form";
  database.density = 1000;
  database.gravity = 9.81;
  database.added_mass_infinite = 5000 * Mat6::Identity();
  for (int k = 1; k <= 400; ++k) {
    const double w = 0.05 * k;
    const std::complex<double> H = closed_transform({0, w});
    database.frequency.push_back(w);
    database.damping.emplace_back(H.real() * closed_matrix());
    database.added_mass.emplace_back(*database.added_mass_infinite + H.imag() / w * closed_matrix());
  }
  return database;
}

/// The sphere of IEA OES Task 10, about the point of its centre line in the still water.
inline Database sphere_database() {
  return read_database(std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/hydro/hydrochrono/sphere.h5");
}

}  // namespace nilas::hydro::radiation_cases
