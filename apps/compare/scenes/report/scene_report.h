#pragma once
/// The input of the report of a comparison.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/report/outlook.h"
#include "apps/compare/scenes/run/scene_study.h"

namespace nilas::compare {

/// How the runs shared the machine.
struct StudyTiming {
  int jobs = 1;
  int cores = 1;  ///< cores that the jobs could use
  double elapsed_s = 0;
  double busy = std::numeric_limits<double>::quiet_NaN();  ///< mean number of jobs that were at work; NaN: not known
  /// The ratio of the time of the first setting's first steps with other runs to their time alone; NaN: not measured.
  double slowdown = std::numeric_limits<double>::quiet_NaN();

  /// The parallel efficiency: the share of the work of `jobs` free cores that was done; NaN if `slowdown` is not known.
  double efficiency() const { return busy / jobs / slowdown; }
};

struct SceneReport {
  SceneStudy study;
  Findings found;
  StudyTiming timing;
  std::vector<std::string> late;      ///< runs for which the budget had no time
  std::vector<std::string> too_long;  ///< those of them that were expected to take more than was left, and not begun
  std::string trouble;                ///< why the probe made no step; empty: it did
  std::string ended_by;               ///< why the comparison is not complete; empty: it is
  Outlook outlook;

  std::string label(std::size_t setting) const;
  /// The label in double quotes for use in a sentence, or "the scene's own setting".
  std::string quoted_label(std::size_t setting) const;
  std::vector<std::string> labels() const;
  /// Whether the error of any setting is known.
  bool compared() const;
  /// Whether there is a vessel and the ice did not load it.
  bool untouched() const { return !found.measure.is_load() && !found.headline.empty(); }
};

/// A simulated time [s] without its unit. It has five digits, since windows far from 0 may be short: "1234.5".
std::string moment_text(double time);
/// The times over which means are taken: "2.14 to 3.7 s". Where the realisations begin at different times, it adds the
/// latest begin: "2.14 to 3.7 s (other realisations begin at up to 2.5 s)".
std::string window_text(const SceneReport& report);
/// A number with at most three significant digits, without an exponent up to 1e6: "0.123", "1230".
std::string three_digits(double value);
/// A length, force or angle with a readable unit and three digits: "1.23 N", "0.45 mm".
std::string quantity_text(double value, const std::string& unit);
/// A share in percent: "3.21 %".
std::string percent_text(double share);
/// The uncertainty of a value as the text " +- 0.12"; empty below half a unit of the third digit, the last that is
/// shown. `unit`: unit of both; empty: the text has none.
std::string uncertainty_text(double value, double uncertainty, const std::string& unit);

}  // namespace nilas::compare
