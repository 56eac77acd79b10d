#pragma once
/// Differences of loads within the same realisation, and whether they are significant.
#include <optional>
#include <vector>

namespace nilas::compare {

/// Where a difference is significant (95 %).
enum class Certainty {
  unknown,          ///< there is one realisation, and the effect of chance in it was not measured
  none,             ///< it may be chance
  in_realisations,  ///< significant in some of the realisations that were run, not in the mean
  everywhere        ///< the mean over realisations is significant by Student's t
};

/// The difference of one setting from another or from the reference, over the realisations in which both are done.
struct PairedDifference {
  std::vector<int> realisations;
  std::vector<double> values;  ///< differences, one per realisation [N]
  std::vector<double> limits;  ///< 95 % limits of the difference by chance [N]; infinite: not measured
  double mean = 0;             ///< mean of the differences [N]; NaN without any
  double half_width = 0;       ///< 95 % interval of the mean [N]; NaN for fewer than two realisations
  int beyond_chance = 0;       ///< number of realisations whose difference lies above its limit
  Certainty certainty = Certainty::unknown;
};

/// Whether a difference is significant everywhere, or at least in realisations that were run.
bool is_sure(const PairedDifference& difference);

/// Whether a significant difference from the reference is smaller than the change of the reference with its own step
/// [N], so that the reference cannot show it.
bool is_below_change(const PairedDifference& difference, double reference_moves);

/// The paired difference from three lists of the same length. `one_for_all`: all realisations are compared with the
/// same run, whose chance does not average out; the variance of the mean is then s^2 (1 + 1/n) in place of s^2/n.
/// `rounding`: differences below it count as none [N].
PairedDifference paired_difference(std::vector<int> realisations, std::vector<double> values,
                                   std::vector<double> limits, double rounding, bool one_for_all = false);

/// The 95 % limit of the difference by chance of two runs of one realisation [N]; infinite if it was not measured. It
/// takes the larger of two variances. One is the squared difference of the run and its perturbed run (one degree of
/// freedom). The other is twice the variance of `alike`: mean loads [N] of runs that solve the same law with the same
/// steps at least as tightly. Perturbed runs begin 1e-12 m apart and diverge late; solvers differ by more from the
/// first contact on.
double chance_limit(std::optional<double> twin_difference, const std::vector<double>& alike);

}  // namespace nilas::compare
