#pragma once
/// The results that a comparison could have with more time.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/run/scene_study.h"

namespace nilas::compare {

/// More runs of a comparison, and what they would show.
struct MoreTime {
  int missing_runs = 0;  ///< planned runs that are not done; 0: none
  int realisations = 0;  ///< realisations that all settings would then have
  double seconds = 0;    ///< wall time [s]
  std::optional<double>
      smallest_difference;  ///< smallest difference of mean ice loads that would be significant [N]; nothing: not known
  std::string command;      ///< the command that continues the comparison
};

struct Outlook {
  std::optional<MoreTime> next;  ///< nothing: more runs would show nothing new
  /// The realisations that make differences of k_target of the load significant, if `next` does not have enough.
  std::optional<int> for_target;
  double for_target_s = 0;  ///< their wall time [s]
  double least_s = 0;       ///< budget of a new comparison of two settings [s]; 0: not known, or two are compared
  double whole_s = 0;       ///< budget of a new comparison that leaves nothing out [s]; 0: nothing was left out
};

/// The smallest difference from the reference that would be significant with so many realisations [N]. The variance by
/// chance is taken as measured, and its degrees of freedom grow. Nothing if chance was not measured.
std::optional<double> smallest_difference(const Findings& found, int realisations);

/// The outlook, without `least_s`. `left_s`: expected wall time of the planned runs that are missing [s].
/// `realisation_s`: expected wall time of one realisation of all settings [s].
Outlook outlook(const SceneStudy& study, const Findings& found, const std::filesystem::path& folder, double left_s,
                double realisation_s);

/// The outlook in sentences. The command has a line of its own.
std::vector<std::string> outlook_lines(const Outlook& outlook, const SceneStudy& study, const Findings& found);
nlohmann::ordered_json outlook_json(const Outlook& outlook);

}  // namespace nilas::compare
