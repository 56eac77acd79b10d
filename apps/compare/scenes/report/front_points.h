#pragma once
/// The places of settings in a picture of computing time against error.
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/report/log_axis.h"

namespace nilas::compare {

/// The place of a setting: at its error, or at its floor if the error may be chance. It points into the findings.
struct FrontPoint {
  const Merit* merit;
  double error, spread;

  bool time_scatters() const { return merit->time_spread > 0; }  // false where the scatter was not measured
  double shortest() const;                                       ///< [s/s], above 0
  double longest() const { return merit->time + merit->time_spread; }
  double lowest() const;  ///< error less its spread, above 0
  double highest() const { return error + spread; }
};

/// A front: its points with their axes.
struct Front {
  std::vector<FrontPoint> points;
  LogAxis time, error;
  std::optional<double> reference_moves;  ///< change of the reference with its step, where it lies on the axis
};

/// The front of the error that ranks the settings; nothing if no setting has a place in it.
std::optional<Front> front_of(const Findings& found);

/// Findings whose error is the distance from the reference's motion; nothing where a load does not rank the settings or
/// motions cannot be predicted.
std::optional<Findings> judged_by_motion(Findings found);

/// Whether a setting is named next to the picture.
bool in_key(const Merit& merit, const Findings& found);

/// What the error is of: "mean ice load".
std::string quantity_of(const Measure& measure);

}  // namespace nilas::compare
