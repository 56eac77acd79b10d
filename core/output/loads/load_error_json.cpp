#include "core/output/loads/load_error_json.h"

#include "core/base/statistics.h"
#include "core/output/loads/mean_error.h"
#include "core/output/loads/or_null.h"

namespace nilas::output {

namespace {

using Json = nlohmann::ordered_json;

constexpr double k_confidence = 0.95, k_perturbation = 1e-12;  // -, [m]

Json channel_json(const ChannelError& error) {
  return {{"mean", error.mean},
          {"estimate", error.total},
          {"solver", error.solver},
          {"law", error.law},
          {"chaos", or_null(error.chaos)}};
}

const char* chaos_method(const LoadError& error) {
  if (error.chaos_from_twins)
    return "Student's t (95 %) times the standard deviation over the run and its perturbed runs, for one further run";
  if (error.from_twins)
    return error.ice_broke ? "the larger of the run's own (8 batches about a straight line) and that of the "
                             "perturbed runs, which diverged too late or not at all"
                           : "the larger of the run's own (second differences of 16 to 64 batches) and that of the "
                             "perturbed runs, which diverged too late or not at all";
  if (error.ice_broke)
    return "Student's t (95 %) times the standard error of the run's own mean, by 8 batches about a straight line: ice "
           "broke";
  return "Student's t (95 %) times the standard error of the run's own mean, by second differences of 16 to 64 batches";
}

Json methods_json(const LoadError& error) {
  return {
      {"solver",
       "mean over the steps of the sum of |residual of the chosen law| over the hull's contacts, and where "
       "the solver missed its tolerance over all contacts of the ice in touch with it"},
      {"law", "|mean| + 2 standard errors of the sum of Coulomb residual minus law residual over the hull's contacts"},
      {"chaos", chaos_method(error)},
      {"step", "not known from one run: run again with half the step"},
      {"estimate", "root of chaos squared and (solver + law) squared"}};
}

}  // namespace

Json load_error_json(const LoadError& error, const TwinStatistics* twins) {
  const ChannelError& headline = error.channels[error.headline];
  Json known = {"solver", "law"}, channels = Json::object();
  if (headline.chaos) known.push_back("chaos");
  for (const ChannelError& c : error.channels) channels[c.channel] = channel_json(c);
  return {{"channel", headline.channel},
          {"mean_N", headline.mean},
          {"estimate_N", headline.total},
          {"solver_N", headline.solver},
          {"solver_at_least", error.solver_at_least},
          {"solver_short_share", error.share_short},
          {"ice_broke", error.ice_broke},
          {"law_N", headline.law},
          {"law_at_least", error.law_at_least},
          {"chaos_N", or_null(headline.chaos)},
          {"step_N", nullptr},
          {"known", known},
          {"confidence", k_confidence},
          {"runs", error.from_twins ? twins->runs() : 1},
          {"methods", methods_json(error)},
          {"channels", channels}};
}

Json twins_json(const TwinStatistics& twins) {
  Json loads = Json::object(), failed = Json::array();
  for (std::size_t c = 0; c < twins.load_names.size(); ++c) {
    const MeanError error = mean_error_of_runs(twins.mean_loads[c]);
    loads[twins.load_names[c]] = {{"mean", mean_of(twins.mean_loads[c])},
                                  {"standard_error", error.freedom > 0 ? Json(error.standard_error) : Json(nullptr)}};
  }
  for (const FailedTwin& f : twins.failed)
    failed.push_back({{"twin", f.twin}, {"time_s", f.time}, {"message", f.message}});
  return {{"count", twins.count},
          {"perturbation_m", k_perturbation},
          {"threshold_m", twins.threshold},
          {"horizon_s", or_null(twins.horizon)},
          {"e_folding_s", or_null(twins.e_folding)},
          {"failed", failed},
          {"loads", loads}};
}

}  // namespace nilas::output
