#pragma once
/// All that the report of a comparison is made from.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/report/outlook.h"
#include "apps/compare/scenes/run/scene_study.h"

namespace nilas {

/// How the runs shared the machine.
struct StudyTiming {
  int jobs = 1;
  int cores = 1;  ///< that the jobs could use
  double elapsed_s = 0;
  double busy = std::numeric_limits<double>::quiet_NaN();  ///< jobs that were at work, on average
  /// Time of the first setting's first steps beside neighbours over their time alone; NaN: not measured.
  double slowdown = std::numeric_limits<double>::quiet_NaN();

  /// Share of the work of as many cores that was done; NaN where neighbours were not measured.
  double efficiency() const { return busy / jobs / slowdown; }
};

struct SceneReport {
  SceneStudy study;
  Findings found;
  StudyTiming timing;
  std::vector<std::string> late;  ///< runs that the budget left no time to begin
  std::string trouble;            ///< of the probe, where it made no step
  std::string ended_by;           ///< why the comparison did not come to its end; empty: it did
  Outlook outlook;

  std::string label(std::size_t setting) const;
  std::vector<std::string> labels() const;
  /// Whether the error of any setting is known.
  bool compared() const;
  /// There is a vessel, and the ice did not load it.
  bool untouched() const { return !found.measure.is_load() && !found.headline.empty(); }
};

/// "1.23 N", "0.45 mm": a length, force or angle with a readable unit.
std::string quantity_text(double value, const std::string& unit);
/// "3.21 %"
std::string percent_text(double share);

}  // namespace nilas
