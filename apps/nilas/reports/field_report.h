#pragma once
/// What a scene asks of its ice against what came out, field by field.
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/field/sizes/distribution_statistics.h"
#include "core/sim/world/world.h"

namespace nilas {

/// One quantity over the floes of a field.
struct QuantityReport {
  std::string column;     ///< with its unit: "size_m"
  std::string asked_for;  ///< in words; empty where nothing was
  Quantiles asked;        ///< empty where nothing was
  std::vector<double> floes;
  std::vector<double> points;  ///< at the floes' centres, where it varies within floes: `asked` is of these then

  /// What `asked` speaks of.
  const std::vector<double>& judged() const { return points.empty() ? floes : points; }
};

/// Two properties that the scene correlates.
struct CorrelationReport {
  std::string a, b;                     ///< columns
  double asked = 0;                     ///< of the normal scores
  double of_scores = 0, of_values = 0;  ///< obtained
};

struct FieldReport {
  std::string name, kind;
  std::size_t floes = 0;
  double area = 0;  ///< [m^2]
  std::optional<double> asked_concentration;
  double concentration = 0;    ///< 0: not known
  double deepest_overlap = 0;  ///< [m]
  int left_out = 0;
  std::size_t weak_lines = 0;  ///< of its sheet
  double seconds = 0;
  std::vector<QuantityReport> quantities;  ///< sizes first
  std::vector<CorrelationReport> correlations;
};

/// A report per <field> that has floes, and one for all single floes.
std::vector<FieldReport> field_reports(const Scene& scene, const WorldParts& parts);

nlohmann::ordered_json report_json(const FieldReport& report);
/// A table of at most 80 columns.
std::string report_text(const FieldReport& report);

}  // namespace nilas
