#pragma once
/// How often a load reaches a level. docs/theory/report.md
#include <vector>

#include "apps/report/figures/curve.h"

namespace nilas::report {

/// The share of the steps whose load is at least each level, in percent. Levels are the loads of steps, at most `most`
/// of them, close together at the largest loads.
Curve step_exceedance(const std::string& name, std::vector<double> loads, double factor, std::size_t most = 400);

/// The largest value of each stretch of steps above the level: one peak between an up-crossing and the down-crossing
/// that follows, in the order of time.
std::vector<double> local_peaks(const std::vector<double>& loads, double level);

/// The share of peaks that reach each, in percent, by the plotting position k / (n + 1) of the k-th largest of n.
Curve peak_exceedance(const std::string& name, std::vector<double> peaks, double factor, std::size_t most = 400);

}  // namespace nilas::report
