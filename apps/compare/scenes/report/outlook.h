#pragma once
/// What a comparison could tell with more time.
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/compare/scenes/judge/merits.h"
#include "apps/compare/scenes/run/study_folder.h"

namespace nilas {

/// More runs of a comparison, and what they would be good for.
struct MoreTime {
  int missing_runs = 0;                       ///< 0: all that was planned is done
  int realisations = 0;                       ///< of all settings, then
  double seconds = 0;                         ///< wall time
  std::optional<double> smallest_difference;  ///< of mean ice loads that could then be told; nothing: not known [N]
  std::string command;                        ///< that goes on with it
};

struct Outlook {
  std::optional<MoreTime> next;  ///< nothing: there is nothing left to tell, or no time is known
  /// Realisations for differences of k_target of the load, and their wall time; beyond what `next` has.
  std::optional<int> for_target;
  double for_target_s = 0;  ///< [s]
  double least_s = 0;       ///< budget of a new comparison that tells one difference; 0: not known, or one is told [s]
  double whole_s = 0;       ///< budget of a new comparison that leaves nothing out; 0: nothing was left out [s]
};

/// Smallest difference from the reference that could be told with so many realisations [N], with what is known of
/// chance: its variance stays, its degrees of freedom grow. Nothing where chance was not measured.
std::optional<double> smallest_difference(const Findings& found, int realisations);

/// `left_s`: wall time of the planned runs that are missing; `realisation_s`: of one realisation of all settings.
Outlook outlook(const Study& study, const Findings& found, const std::filesystem::path& folder, double left_s,
                double realisation_s);

/// In sentences; the command stands in a line of its own.
std::vector<std::string> outlook_lines(const Outlook& outlook, const Study& study, const Findings& found);
nlohmann::ordered_json outlook_json(const Outlook& outlook);

}  // namespace nilas
