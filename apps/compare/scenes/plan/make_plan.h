#pragma once
/// Which runs a comparison makes within its budget, and what it leaves out.
#include "apps/compare/scenes/plan/cost.h"
#include "apps/compare/scenes/plan/plan.h"

namespace nilas {

struct PlanRequest {
  double budget_s = 1200;  ///< wall time of what is planned; 0: no limit
  int jobs = 2;            ///< at a time
  int realisations = 3;
  bool fixed_realisations = false;  ///< the user's own number
  bool fixed_length = false;        ///< the simulated time is not cut
  double stated_budget_s = 0;       ///< as the user gave it, for what is said
  bool reference = true;            ///< runs of a reference setting are needed
  bool check = true;                ///< one with double its step tells how far it still moves
  bool fixed_tolerances = false;    ///< no setting that solves tighter than the first is given up for that alone
  bool fixed_reference = false;     ///< its tolerance is not loosened
  double start = 0, end = 10;       ///< of the scene [s]
};

/// What a plan is made of.
struct PlanInput {
  std::vector<CompareSetting> settings;
  std::size_t core = 0;  ///< settings that come before all others
  CompareSetting reference;
  CostModel cost;
  PlanRequest request;
};

/// The longest simulated time, most realisations and most settings that fit. Settings beyond `core` (those that differ
/// from the first on one axis) go first, the last first; then the reference is loosened to a tenth of the tightest
/// tolerance that is compared, and where it still takes three tenths of the time those that solve tighter than the
/// first go and it is loosened on; then the third realisation goes, the simulated time is cut, and in the end whole
/// settings. Where the first setting judges, settings go before less than a quarter of the load's window is left.
Plan make_plan(const PlanInput& input);

}  // namespace nilas
