#pragma once
/// Differences of loads that are taken realisation by realisation, and whether chance alone can make them.
#include <optional>
#include <vector>

namespace nilas {

/// How far a difference is sure (95 %).
enum class Certainty {
  unknown,          ///< one realisation, and what chance does there was not measured
  none,             ///< chance alone can make it
  in_realisations,  ///< beyond chance in some of the realisations that were run; of others nothing is known
  everywhere        ///< the mean over realisations is not zero, by Student's t
};

/// Of one setting from another, or from the reference, over the realisations in which both are done.
struct PairedDifference {
  std::vector<int> realisations;
  std::vector<double> values;  ///< one per realisation [N]
  std::vector<double> limits;  ///< what chance makes of two runs of it, 95 %; infinite: not measured [N]
  double mean = 0;             ///< NaN of none [N]
  double half_width = 0;       ///< of the mean, 95 %; NaN of fewer than two realisations [N]
  int beyond_chance = 0;       ///< realisations whose difference lies above its limit
  Certainty certainty = Certainty::unknown;
};

/// Beyond chance everywhere, or at least in realisations that were run.
bool is_sure(const PairedDifference& difference);

/// `one_for_all`: all realisations are set against the same run, whose chance does not average out; the variance of the
/// mean is then s^2 (1 + 1/n) in place of s^2/n. `rounding`: below which differences are none [N]. The three lists have
/// the same length.
PairedDifference paired_difference(std::vector<int> realisations, std::vector<double> values,
                                   std::vector<double> limits, double rounding, bool one_for_all = false);

/// 95 % limit of the difference of two runs of one realisation that chance alone sets apart [N]; infinite where nothing
/// tells. By the larger variance of two: the squared difference of the twins of that realisation (one degree of
/// freedom), and twice the variance of runs that solve the same law with the same steps at least as tightly and differ
/// in what should not matter. Twins begin 1e-12 m apart and part late; solvers differ by more from the first contact
/// on.
double chance_limit(std::optional<double> twin_difference, const std::vector<double>& alike);

}  // namespace nilas
