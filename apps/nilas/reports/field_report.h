#pragma once
/// The ice that a scene asks for compared with the ice obtained, field by field.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/field/sizes/distribution_statistics.h"
#include "core/sim/world/world.h"

namespace nilas::commands {

/// One quantity over the floes of a field.
struct QuantityReport {
  std::string column;      ///< name with its unit, such as "size_m"
  std::string asked_for;   ///< the request in words; empty if there is none
  field::Quantiles asked;  ///< the quantiles asked for; empty if there are none
  std::vector<double> floes;
  std::vector<double> points;  ///< values at the floes' centres, if it varies within floes; `asked` is then of these

  /// The values that `asked` is compared with.
  const std::vector<double>& judged() const { return points.empty() ? floes : points; }
};

/// Two properties that the scene correlates.
struct CorrelationReport {
  std::string a, b;                     ///< names of the columns
  double asked = 0;                     ///< correlation of the normal scores that was asked for
  double of_scores = 0, of_values = 0;  ///< correlations obtained
};

struct FieldReport {
  std::string name, kind;
  std::size_t floes = 0;
  double area = 0;  ///< [m^2]
  std::optional<double> asked_concentration;
  double concentration = 0;    ///< 0: not known
  double deepest_overlap = 0;  ///< [m]
  int left_out = 0;
  std::size_t weak_lines = 0;  ///< number of weak lines of its sheet
  double seconds = 0;
  std::vector<QuantityReport> quantities;  ///< sizes first
  std::vector<CorrelationReport> correlations;
};

/// The reports: one per <field> that has floes, and one for all single floes.
std::vector<FieldReport> field_reports(const scene::Scene& scene, const sim::WorldParts& parts);

nlohmann::ordered_json report_json(const FieldReport& report);
/// A table of at most 80 columns.
std::string report_text(const FieldReport& report);

}  // namespace nilas::commands
