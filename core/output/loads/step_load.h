#pragma once
/// How far the ice load of one step is off, by the steps that were solved a second time: docs/theory/load-error.md.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/output/loads/load_window.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// Errors of the ice load of one step, as shares of the mean load of the checked steps.
struct StepLoadError {
  long every = 0;              ///< one of so many steps was checked; 0: none
  double tolerance = 0;        ///< tolerance of the second solution [m/s]
  long checked = 0;            ///< steps with ice whose second solution reached its tolerance
  long unsolved = 0;           ///< steps with ice whose second solution did not; they do not count
  double mean = 0;             ///< mean size of the load in the checked steps [N]
  double median = 0, p95 = 0;  ///< median and 95th percentile of the errors; without a checked step 0

  bool has_any() const { return checked + unsolved > 0; }
  /// Whether most single steps have the load that the contact law asks for, as far as most second solutions can tell.
  bool is_trusted() const {
    return checked > 0 && p95 <= k_trusted &&
           static_cast<double>(unsolved) <= k_unknown * static_cast<double>(checked + unsolved);
  }
  /// Whether steps were checked, and are not to be trusted.
  bool is_doubted() const { return has_any() && !is_trusted(); }
  static constexpr double k_trusted = 0.1, k_unknown = 0.1;
};

/// Collects the checked steps of a run.
class StepLoads {
 public:
  void add(const sim::StepRecord& record);
  /// The errors over a window. Median and percentile are linear between neighbours. Steps without load in both
  /// solutions do not count.
  StepLoadError error(const sim::RunInfo& info, const LoadWindow& window) const;

  void save(StateWriter out) const;
  void restore(const StateReader& in);

 private:
  std::vector<long> checked_, unsolved_;  ///< numbers of steps, by whether the second solution reached its tolerance
  std::vector<double> size_, error_;      ///< of the checked steps: |load| by the second solution, and its error [N]
};

/// The errors in whole sentences, with advice where single steps are not to be trusted; empty where none was checked.
std::string step_load_text(const StepLoadError& error);
/// The same as lines of the closing account.
std::string step_load_lines(const StepLoadError& error);
nlohmann::ordered_json step_load_json(const StepLoadError& error);
/// The errors of a summary; none checked where it has no such entry.
StepLoadError step_load_error_of(const nlohmann::ordered_json& summary);

}  // namespace nilas::output
