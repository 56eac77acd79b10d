#pragma once
/// What a comparison could show with more time.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/run/scene_study.h"

namespace nilas {

/// More runs of a comparison, and what they would show.
struct MoreTime {
  int missing_runs = 0;  ///< 0: all that was planned is done
  int realisations = 0;  ///< of all settings, then
  double seconds = 0;    ///< wall time
  std::optional<double>
      smallest_difference;  ///< of mean ice loads that would then be significant; nothing: not known [N]
  std::string command;      ///< that continues the comparison
};

struct Outlook {
  std::optional<MoreTime> next;  ///< nothing: more runs would show nothing new, or no time is known
  /// Realisations for differences of k_target of the load, and their wall time; beyond what `next` has.
  std::optional<int> for_target;
  double for_target_s = 0;  ///< [s]
  double least_s = 0;  ///< budget of a new comparison that compares two settings; 0: not known, or two are compared [s]
  double whole_s = 0;  ///< budget of a new comparison that leaves nothing out; 0: nothing was left out [s]
};

/// Smallest difference from the reference that would be significant with so many realisations [N]: the variance of
/// chance stays, its degrees of freedom grow. Nothing where chance was not measured.
std::optional<double> smallest_difference(const Findings& found, int realisations);

/// `left_s`: wall time of the planned runs that are missing; `realisation_s`: of one realisation of all settings.
Outlook outlook(const SceneStudy& study, const Findings& found, const std::filesystem::path& folder, double left_s,
                double realisation_s);

/// In sentences; the command stands in a line of its own.
std::vector<std::string> outlook_lines(const Outlook& outlook, const SceneStudy& study, const Findings& found);
nlohmann::ordered_json outlook_json(const Outlook& outlook);

}  // namespace nilas
