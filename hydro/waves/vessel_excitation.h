#pragma once
/// First-order excitation and drift of a vessel in waves, from a database.
#include <string>
#include <vector>

#include "core/choices/wave_choices.h"
#include "hydro/database/database.h"
#include "hydro/waves/heading_range.h"
#include "hydro/waves/wave_field.h"

namespace nilas::hydro {

/// What the waves of a field do to the vessel of a database, prepared for every component.
///
/// Excitation: F(t) = sum_i Re(X(w_i, b_i) a_i exp(i t_i)), with the phase t_i of the wave at the present horizontal
/// position of the origin of frame D and its heading b_i relative to the present yaw of D. X is interpolated linearly
/// in real and imaginary part over frequency and heading; it is exact at the values of the database. So a vessel under
/// way meets waves at the frequency of encounter, but with the coefficients of one at rest.
///
/// Mean drift: F = sum_i a_i^2 D(w_i, b_i). Newman's approximation (1974) with the arithmetic mean of both waves,
/// D_ij = (D_i + D_j) / 2, adds the slow part: F(t) = sum_ij a_i a_j D_ij cos(t_i - t_j) [Faltinsen 1990, 5.42]. It is
/// summed as Re(conj(sum a exp(i t)) sum D a exp(i t)), in time proportional to the number of waves. For one wave both
/// give a^2 D.
class VesselExcitation {
 public:
  /// Loads are those of the density and gravity of the database. Throws InputError where the database has no
  /// excitation, or no drift though `drift` asks for it; where a wave's period is outside the database; and where
  /// gravity or depth of database and waves differ so that their wave lengths differ by more than 2 %.
  VesselExcitation(const Database& database, const WaveField& field, WaveDrift drift);

  /// Takes a linear load away, such as Froude-Krylov: part(i, b) belongs to component i at the relative heading b.
  template <class Part>
  void subtract(const Part& part) {
    for (std::size_t i = 0; i < waves_.size(); ++i)
      for (std::size_t k = 0; k < headings_.size(); ++k) waves_[i].excitation[k] -= part(i, headings_[k]);
  }

  /// The load in the horizontal axes of D, turned by its yaw [rad] only, about the origin of D: forces, then moments.
  /// `waves` stand over that origin. Throws SimulationError where a heading is outside the database.
  Vec6 load(const WaveField& field, const WaveColumn& waves, double yaw, double t) const;
  /// Throws InputError naming the first wave whose heading relative to this yaw [rad] is outside the database.
  void check_headings(const WaveField& field, double yaw) const;

 private:
  struct Wave {
    std::vector<ComplexVec6> excitation;  ///< one per heading
    std::vector<Vec6> drift;              ///< one per heading; empty without drift
  };
  std::vector<Wave> waves_;
  std::vector<double> headings_;
  HeadingRange range_;
  WaveDrift drift_;
};

}  // namespace nilas::hydro
