#include "core/output/tables/steps_csv.h"

#include <cmath>

#include "contact/measure/measure.h"
#include "core/base/error.h"

namespace nilas::output {

std::vector<std::string> step_columns(const sim::RunInfo& info) {
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

/// The status stands behind the time and as many counts, which are written without an exponent.
constexpr std::size_t k_counts_before_status = 4;

static void add_ledger(const sim::RunInfo& info, const sim::Ledger& ledger, std::vector<double>& numbers) {
  NILAS_DEMAND(ledger.works.size() == info.work_names.size());
  numbers.insert(numbers.end(), {ledger.kinetic, ledger.potential});
  if (info.elastic_contacts) numbers.push_back(ledger.elastic);
  numbers.insert(numbers.end(), ledger.works.begin(), ledger.works.end());
  if (info.elastic_contacts) numbers.push_back(ledger.damping);
  numbers.insert(numbers.end(), {ledger.friction, ledger.impact, ledger.stabilisation, ledger.fracture, ledger.crushing,
                                 ledger.integrator, ledger.imbalance});
}

std::vector<double> step_numbers(const sim::RunInfo& info, const sim::StepRecord& record) {
  std::vector<double> numbers{record.t};
  for (const int count : {record.floes, record.contacts, record.islands, record.iterations})
    numbers.push_back(static_cast<double>(count));
  for (const auto& residual : contact::residual_columns()) numbers.push_back(record.residuals.*residual.member);
  numbers.insert(numbers.end(), {record.penetration_max, record.penetration_mean});
  NILAS_DEMAND(record.module_values.size() == info.module_columns.size());
  numbers.insert(numbers.end(), record.module_values.begin(), record.module_values.end());
  add_ledger(info, record.ledger, numbers);
  numbers.insert(numbers.end(), {record.momentum_imbalance, record.angular_momentum_imbalance, record.momentum_scale,
                                 record.angular_momentum_scale});
  numbers.insert(numbers.end(), record.ms.begin(), record.ms.end());
  return numbers;
}

StepsCsv::StepsCsv(const std::filesystem::path& path, const sim::RunInfo& info, std::optional<std::int64_t> keep)
    : file_(path, "", keep), info_(info) {
  if (!keep) file_.append(csv_header(step_columns(info)));
}

void StepsCsv::row(const sim::StepRecord& record) {
  const std::vector<double> numbers = step_numbers(info_, record);
  row_.clear();
  row_.shortest(numbers[0]);
  for (std::size_t k = 1; k <= k_counts_before_status; ++k) row_.integer(std::lround(numbers[k]));
  row_.text(contact::to_string(record.status));
  for (std::size_t k = k_counts_before_status + 1; k < numbers.size(); ++k) row_.shortest(numbers[k]);
  row_.hexadecimal(record.state_hash);
  file_.append(row_.line());
}

}  // namespace nilas::output
