#include "core/output/tables/steps_csv.h"

#include "contact/measure/measure.h"
#include "core/base/error.h"

namespace nilas::output {

namespace {

std::vector<std::string> column_names(const sim::RunInfo& info) {
  std::vector<std::string> names{"time_s", "floes", "contacts", "islands", "iterations", "status"};
  for (const auto& residual : contact::residual_columns()) names.emplace_back(residual.name);
  for (const char* name : {"penetration_max_m", "penetration_mean_m"}) names.emplace_back(name);
  names.insert(names.end(), info.module_columns.begin(), info.module_columns.end());
  for (const char* name : {"kinetic_J", "potential_J"}) names.emplace_back(name);
  if (info.elastic_contacts) names.emplace_back("elastic_J");
  for (const auto& work : info.work_names) names.push_back("work_" + work + "_J");
  if (info.elastic_contacts) names.emplace_back("damping_J");
  for (const char* name :
       {"friction_J", "impact_J", "stabilisation_J", "fracture_J", "crushing_J", "integrator_J", "imbalance_J",
        "momentum_imbalance_Ns", "angular_momentum_imbalance_Nms", "momentum_scale_Ns", "angular_momentum_scale_Nms"})
    names.emplace_back(name);
  for (int phase = 0; phase < sim::k_num_phases; ++phase)
    names.push_back(std::string("ms_") + sim::to_string(static_cast<sim::Phase>(phase)));
  names.emplace_back("state_hash");
  return names;
}

}  // namespace

StepsCsv::StepsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep)
    : file_(path, "", keep),
      num_works_(info.work_names.size()),
      elastic_(info.elastic_contacts),
      num_module_values_(info.module_columns.size()) {
  if (!keep) file_.append(csv_header(column_names(info)));
}

void StepsCsv::row(const sim::StepRecord& record) {
  row_.clear();
  row_.shortest(record.t).integer(record.floes).integer(record.contacts).integer(record.islands);
  row_.integer(record.iterations).text(contact::to_string(record.status));
  for (const auto& residual : contact::residual_columns()) row_.shortest(record.residuals.*residual.member);
  row_.shortest(record.penetration_max).shortest(record.penetration_mean);
  NILAS_DEMAND(record.module_values.size() == num_module_values_);
  for (const double value : record.module_values) row_.shortest(value);
  add_ledger(record.ledger);
  row_.shortest(record.momentum_imbalance).shortest(record.angular_momentum_imbalance);
  row_.shortest(record.momentum_scale).shortest(record.angular_momentum_scale);
  for (const double ms : record.ms) row_.shortest(ms);
  row_.hexadecimal(record.state_hash);
  file_.append(row_.line());
}

void StepsCsv::add_ledger(const sim::Ledger& ledger) {
  NILAS_DEMAND(ledger.works.size() == num_works_);
  row_.shortest(ledger.kinetic).shortest(ledger.potential);
  if (elastic_) row_.shortest(ledger.elastic);
  for (const double work : ledger.works) row_.shortest(work);
  if (elastic_) row_.shortest(ledger.damping);
  for (const double loss : {ledger.friction, ledger.impact, ledger.stabilisation, ledger.fracture, ledger.crushing,
                            ledger.integrator, ledger.imbalance})
    row_.shortest(loss);
}

}  // namespace nilas::output
