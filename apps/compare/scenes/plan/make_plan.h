#pragma once
/// Plans the runs of a comparison within its budget, and what it leaves out.
#include "apps/compare/scenes/plan/cost.h"
#include "apps/compare/scenes/plan/plan.h"

namespace nilas::compare {

struct PlanRequest {
  double budget_s = 1200;  ///< wall time of what is planned [s]; 0: no limit
  int jobs = 2;            ///< runs at a time
  int realisations = 3;
  bool fixed_realisations = false;  ///< the number is the user's and is not reduced
  bool fixed_length = false;        ///< the simulated time is not cut
  double stated_budget_s = 0;       ///< budget that the user gave, for messages [s]
  bool reference = true;            ///< runs of a reference setting are needed
  bool check = true;                ///< a run with double its step shows how far it still moves
  bool fixed_tolerances = false;    ///< settings that solve tighter than the first are kept
  bool fixed_reference = false;     ///< the tolerance of the reference is not loosened
  double start = 0, end = 10;       ///< simulated time of the scene [s]
};

/// The input of a plan.
struct PlanInput {
  std::vector<CompareSetting> settings;
  std::size_t core = 0;  ///< number of settings that come before all others
  CompareSetting reference;
  CostModel cost;
  PlanRequest request;
};

/// Makes the plan with the longest simulated time, most realisations and most settings that fit. Against a reference,
/// the following is cut in this order until the plan fits:
/// 1. settings beyond `core`, which are those that differ from the first on more than one axis;
/// 2. the tolerance of the reference, up to a tenth of the tightest one compared, while it takes over 30 % of the time;
/// 3. settings that solve tighter than the first, if it still takes so much, and its tolerance further;
/// 4. the realisations beyond two, the simulated time, and whole settings from the end.
/// If the first setting judges, settings are cut before less than a quarter of the load's window is left.
Plan make_plan(const PlanInput& input);

}  // namespace nilas::compare
