#include "apps/nilas/reports/field_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/field/sizes/floe_sizes.h"
#include "core/geometry/mass_properties.h"

namespace nilas::commands {

namespace {

using Json = nlohmann::ordered_json;

std::string size_in_words(const scene::SizeScene& size) {
  const std::string name = name_of(kind_of<SizeDistribution>(size));
  const auto range = [](const auto& of) { return fmt::format("{:g} to {:g}", of.min, of.max); };
  return std::visit(
      Overloaded{[&](const scene::FixedSizeScene& of) { return fmt::format("{} {:g}", name, of.mean); },
                 [&](const scene::UniformSizeScene& of) { return fmt::format("{}, {}", name, range(of)); },
                 [&](const scene::LognormalSizeScene& of) {
                   return fmt::format("{}, mean {:g}, sd {:g}, cut at {}", name, of.mean, of.sd, range(of));
                 },
                 [&](const scene::PowerLawSizeScene& of) {
                   return fmt::format("{}, exponent {:g}, {}", name, of.exponent, range(of));
                 },
                 [&](const scene::LibrarySizeScene&) { return name; }},
      size);
}

QuantityReport size_report(const sim::PlannedIce& ice) {
  QuantityReport report;
  report.column = "size_m";
  for (const auto& one : ice.floes) report.floes.push_back(std::sqrt(geometry::polygon_moments(one.floe.outline).area));
  if (ice.packed) {
    report.asked_for = size_in_words(*ice.field->size());
    report.asked = [spec = *ice.packed](double u) { return field::size_quantile(spec, u); };
  }
  return report;
}

/// The mean of a property before it varies, if it is the same for all of these floes; else 0.
double common_mean(const sim::PlannedIce& ice, FloeProperty property) {
  const auto mean = [&](const sim::PlannedFloe& one) { return one.means[static_cast<std::size_t>(property)]; };
  const double first = mean(ice.floes.front());
  const bool same =
      std::all_of(ice.floes.begin(), ice.floes.end(), [&](const auto& one) { return mean(one) == first; });
  return same ? first : 0;
}

std::string spread_in_words(const scene::VaryScene& vary, double mean) {
  return fmt::format("{}, mean {:g}, cov {:g}{}", name_of(vary.distribution), mean, vary.cov,
                     vary.correlation_length > 0 ? fmt::format(", correlation length {:g} m", vary.correlation_length)
                                                 : std::string());
}

QuantityReport property_report(const scene::Scene& scene, const sim::PlannedIce& ice, FloeProperty property,
                               const field::FloeVariation& variation) {
  QuantityReport report;
  report.column = field::column_of(property);
  for (const auto& one : ice.floes) {
    report.floes.push_back(field::value_of(one.floe, property));
    for (const auto& textured : one.texture)
      if (textured.property == property) report.points.push_back(textured.texture.at(0, 0));
  }
  const double mean = common_mean(ice, property);
  const bool from_file = ice.field && ice.field->kind() == FieldKind::file;
  if (mean <= 0 || from_file) return report;
  for (const field::PropertySpread& spread : variation.spreads())
    if (spread.property == property)
      report.asked = [mean, cut = spread.distribution](double u) { return mean * cut.quantile(u); };
  for (const scene::VaryScene& vary : scene.ice->vary)
    if (vary.property == property) report.asked_for = spread_in_words(vary, mean);
  return report;
}

std::vector<CorrelationReport> correlation_reports(const scene::Scene& scene, const FieldReport& report) {
  const auto sample = [&](FloeProperty property) {
    return std::find_if(report.quantities.begin(), report.quantities.end(),
                        [&](const auto& quantity) { return quantity.column == field::column_of(property); });
  };
  std::vector<CorrelationReport> all;
  for (const scene::VaryScene& vary : scene.ice->vary)
    for (const auto& [partner, asked] : vary.correlations) {
      const auto a = sample(vary.property), b = sample(partner);
      if (a == report.quantities.end() || b == report.quantities.end() || !a->asked || !b->asked) continue;
      all.push_back({a->column, b->column, asked, field::score_correlation(a->judged(), b->judged()),
                     field::correlation(a->judged(), b->judged())});
    }
  return all;
}

FieldReport field_report(const scene::Scene& scene, const sim::PlannedIce& ice, const field::FloeVariation& variation) {
  FieldReport report;
  report.name = ice.name;
  report.kind = ice.field ? name_of(ice.field->kind()) : "floe";
  report.floes = ice.floes.size();
  for (const auto& one : ice.floes) report.area += geometry::polygon_moments(one.floe.outline).area;
  if (ice.packed) report.asked_concentration = ice.packed->concentration;
  report.concentration = ice.concentration;
  report.deepest_overlap = ice.worst_overlap;
  report.left_out = ice.left_out;
  report.weak_lines = ice.weak_lines.size();
  report.seconds = ice.seconds;
  report.quantities.push_back(size_report(ice));
  for (const FloeProperty property : field::k_floe_properties) {
    QuantityReport quantity = property_report(scene, ice, property, variation);
    const bool known = std::any_of(quantity.floes.begin(), quantity.floes.end(), [](double x) { return x > 0; });
    if (known) report.quantities.push_back(std::move(quantity));
  }
  report.correlations = correlation_reports(scene, report);
  return report;
}

Json summary_json(const field::DistributionSummary& summary) {
  Json json{{"mean", summary.mean}, {"sd", summary.sd}, {"min", summary.min}, {"max", summary.max}};
  for (std::size_t k = 0; k < field::k_reported_quantiles.size(); ++k)
    json[fmt::format("q{:02.0f}", 100 * field::k_reported_quantiles[k])] = summary.quantiles[k];
  return json;
}

Json quantity_json(const QuantityReport& quantity) {
  Json json;
  if (quantity.asked) {
    json["asked_for"] = quantity.asked_for;
    json["asked"] = summary_json(field::summary_of(quantity.asked));
  }
  json["obtained"] = summary_json(field::summary_of(quantity.floes));
  if (!quantity.points.empty()) json["obtained_at_points"] = summary_json(field::summary_of(quantity.points));
  if (quantity.asked) json["ks_distance"] = field::ks_distance(quantity.judged(), quantity.asked);
  return json;
}

/// A number of ten columns; "-" stands for no bound.
std::string cell(double x) { return std::isfinite(x) ? fmt::format("{:>10.4g}", x) : fmt::format("{:>10}", "-"); }

std::string row(const std::string& name, const field::DistributionSummary& s) {
  std::string line = fmt::format("  {:<8}", name);
  for (const double x : {s.mean, s.sd, s.min, s.quantiles.front(), s.quantiles[2], s.quantiles.back(), s.max})
    line += cell(x);
  return line + "\n";
}

std::string quantity_text(const QuantityReport& quantity) {
  std::string text =
      "  " + quantity.column + (quantity.asked_for.empty() ? std::string() : ": " + quantity.asked_for) + "\n";
  if (quantity.asked) text += row("asked", field::summary_of(quantity.asked));
  text += row("obtained", field::summary_of(quantity.floes));
  if (!quantity.points.empty()) text += row("points", field::summary_of(quantity.points));
  if (!quantity.asked) return text;
  text += fmt::format("    Kolmogorov-Smirnov distance {:.4f}", field::ks_distance(quantity.judged(), quantity.asked));
  if (!quantity.points.empty()) return text + "; points near each other are not independent\n";
  constexpr double k_one_in_twenty = 1.36;
  const std::size_t n = quantity.floes.size();
  return text + fmt::format("; one sample of {} in twenty has {:.4f}\n", n,
                            k_one_in_twenty / std::sqrt(static_cast<double>(n)));
}

}  // namespace

std::vector<FieldReport> field_reports(const scene::Scene& scene, const sim::WorldParts& parts) {
  const field::FloeVariation variation = sim::floe_variation(scene);
  std::vector<FieldReport> reports;
  for (const sim::PlannedIce& ice : parts.ice)
    if (!ice.floes.empty()) reports.push_back(field_report(scene, ice, variation));
  return reports;
}

Json report_json(const FieldReport& report) {
  Json json{{"name", report.name}, {"kind", report.kind}, {"floes", report.floes}, {"area_m2", report.area}};
  if (report.asked_concentration) json["concentration_asked"] = *report.asked_concentration;
  json["concentration"] = report.concentration;
  json["worst_overlap_m"] = report.deepest_overlap;
  json["left_out"] = report.left_out;
  json["weak_lines"] = report.weak_lines;
  json["seconds"] = report.seconds;
  for (const auto& quantity : report.quantities) json[quantity.column] = quantity_json(quantity);
  json["correlations"] = Json::array();
  for (const auto& one : report.correlations)
    json["correlations"].push_back({{"between", {one.a, one.b}},
                                    {"asked", one.asked},
                                    {"obtained", one.of_scores},
                                    {"obtained_of_values", one.of_values}});
  return json;
}

std::string report_text(const FieldReport& report) {
  std::string text = fmt::format("{}: {}, {} floes, {:.5g} m^2, {:.2f} s\n", report.name, report.kind, report.floes,
                                 report.area, report.seconds);
  if (report.concentration > 0) {
    text += fmt::format("  concentration {:.5f}", report.concentration);
    text += report.asked_concentration ? fmt::format(", asked {:g}\n", *report.asked_concentration) : "\n";
  }
  text += fmt::format("  deepest overlap {:g} m; {} floes left out because of the hull\n", report.deepest_overlap,
                      report.left_out);
  if (report.weak_lines > 0)
    text += fmt::format("  {} weak lines, seams of floes frozen together\n", report.weak_lines);
  text += fmt::format("{:<10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "mean", "sd", "min", "5 %", "50 %",
                      "95 %", "max");
  for (const auto& quantity : report.quantities) text += quantity_text(quantity);
  for (const auto& one : report.correlations)
    text += fmt::format("  {} with {}\n    correlation {:.3f} of the scores, {:.3f} of the values; asked {:g}\n", one.a,
                        one.b, one.of_scores, one.of_values, one.asked);
  return text;
}

}  // namespace nilas::commands
