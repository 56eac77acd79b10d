#include "apps/nilas/hydro/database_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/output/text/console.h"
#include "hydro/database/heading_circle.h"

namespace nilas::commands {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json limits_of(const std::optional<Mat6>& matrix, int mode) { return matrix ? Json((*matrix)(mode, mode)) : Json(); }

Json modes_json(const hydro::Database& database) {
  Json modes = Json::array();
  for (int i = 0; i < static_cast<int>(hydro::k_mode_name.size()); ++i) {
    std::size_t peak = 0;
    for (std::size_t k = 0; k < database.damping.size(); ++k)
      if (database.damping[k](i, i) > database.damping[peak](i, i)) peak = k;
    modes.push_back({{"mode", hydro::k_mode_name[i]},
                     {"added_mass_zero", limits_of(database.added_mass_zero, i)},
                     {"added_mass_lowest", database.added_mass.front()(i, i)},
                     {"added_mass_highest", database.added_mass.back()(i, i)},
                     {"added_mass_infinite", limits_of(database.added_mass_infinite, i)},
                     {"damping_peak", database.damping[peak](i, i)},
                     {"damping_peak_rad_s", database.frequency[peak]}});
  }
  return modes;
}

Json haskind_json(const hydro::SelfCheck& check) {
  Json rows = Json::array();
  for (const hydro::HaskindRatio& ratio : check.haskind)
    rows.push_back({{"mode", hydro::k_mode_name[ratio.mode]},
                    {"median", ratio.median},
                    {"least", ratio.least},
                    {"largest", ratio.largest},
                    {"frequencies", ratio.frequencies},
                    {"lowest_rad_s", ratio.lowest},
                    {"highest_rad_s", ratio.highest}});
  return rows;
}

Json closure_json(const hydro::SelfCheck& check) {
  Json rows = Json::array();
  for (const hydro::Closure& closure : check.closure)
    rows.push_back({{"mode", hydro::k_mode_name[closure.mode]},
                    {"worst", closure.worst},
                    {"worst_rad_s", closure.worst_frequency},
                    {"share", closure.share}});
  return rows;
}

Json long_wave_json(const hydro::SelfCheck& check) {
  if (!check.long_wave) return {};
  const hydro::LongWave& wave = *check.long_wave;
  return {{"rad_s", wave.frequency},
          {"heave", or_null(wave.heave)},
          {"horizontal", or_null(wave.horizontal)},
          {"phase_right", wave.horizontal_sign > 0}};
}

Json periods_json(const hydro::Database& database, const std::optional<Mat6>& mass) {
  Json rows = Json::array();
  const std::optional<Mat6>& body = mass ? mass : database.mass;
  if (!body) return rows;
  for (const hydro::NaturalMode& mode : hydro::natural_modes(database, *body))
    rows.push_back({{"mode", hydro::k_mode_name[mode.mode]}, {"period_s", mode.period}});
  return rows;
}

/// The largest share by which the diagonal at the highest frequency differs from the limit.
Json distance_to_limit(const hydro::Database& database) {
  if (!database.added_mass_infinite) return {};
  double worst = 0;
  const Vec6 last = database.added_mass.back().diagonal(), limit = database.added_mass_infinite->diagonal();
  const Vec6 scale = hydro::mode_scale(database, database.added_mass);
  for (int i = 0; i < static_cast<int>(hydro::k_mode_name.size()); ++i)
    if (scale[i] > 0) worst = std::max(worst, std::abs(last[i] - limit[i]) / scale[i]);
  return worst;
}

/// A number with five digits, or a dash for null.
std::string short_number(const Json& value) {
  return value.is_null() ? "-" : fmt::format("{:.5g}", value.get<double>());
}

std::string modes_text(const Json& report) {
  std::string text =
      "\n  Added mass A and damping B on the diagonal [kg, kg m^2; kg/s, kg m^2/s]\n"
      "  mode        A(w=0)  A(lowest) A(highest)     A(inf)   B largest   at period\n";
  for (const Json& mode : report["modes"])
    text += fmt::format("  {:<7}{:>11}{:>11}{:>11}{:>11}{:>12}{:>10} s\n", mode["mode"].get<std::string>(),
                        short_number(mode["added_mass_zero"]), short_number(mode["added_mass_lowest"]),
                        short_number(mode["added_mass_highest"]), short_number(mode["added_mass_infinite"]),
                        short_number(mode["damping_peak"]),
                        short_number(2 * k_pi / mode["damping_peak_rad_s"].get<double>()));
  return text;
}

std::string haskind_text(const Json& report) {
  if (report["haskind_newman"].empty())
    return "\n  " +
           output::wrapped("Haskind-Newman was not tested: " + report["no_haskind_newman"].get<std::string>() + ".",
                           2) +
           "\n";
  std::string text =
      "\n  Haskind-Newman: damping from the excitation, divided by that of the file; 1 is right\n"
      "  mode       median      least    largest   frequencies from        to [rad/s]\n";
  for (const Json& row : report["haskind_newman"])
    text += fmt::format("  {:<7}{:>10.4f}{:>11.4f}{:>11.4f}{:>14}{:>10.4g}{:>10.4g}\n", row["mode"].get<std::string>(),
                        row["median"].get<double>(), row["least"].get<double>(), row["largest"].get<double>(),
                        row["frequencies"].get<int>(), row["lowest_rad_s"].get<double>(),
                        row["highest_rad_s"].get<double>());
  return text;
}

std::string closure_text(const Json& report) {
  if (report["closure"].empty())
    return "\n  " + output::wrapped("Motions were not compared: " + report["no_closure"].get<std::string>() + ".", 2) +
           "\n";
  std::string text =
      "\n  Motions from the matrices against those of the file\n"
      "  mode      largest difference   at period   largest share of motions above a fifth of the largest\n";
  for (const Json& row : report["closure"]) {
    constexpr double k_percent = 100;
    text += fmt::format("  {:<7}{:>21.3g}{:>10.4g} s{:>9.3g} %\n", row["mode"].get<std::string>(),
                        row["worst"].get<double>(), 2 * k_pi / row["worst_rad_s"].get<double>(),
                        k_percent * row["share"].get<double>());
  }
  return text;
}

std::string checks_text(const Json& report) {
  const auto yes = [](bool holds) { return holds ? "yes" : "no"; };
  constexpr double k_percent = 100;
  std::string text = fmt::format("\n  symmetric               {} (largest share {:.2g})\n",
                                 yes(report["symmetric"].get<bool>()), report["asymmetry"].get<double>());
  text += fmt::format("  damping positive        {}\n", yes(report["damping_positive"].get<bool>()));
  if (!report["distance_to_infinite"].is_null())
    text += fmt::format("  A(highest) and A(inf)   differ by {:.3g} % of the largest\n",
                        k_percent * report["distance_to_infinite"].get<double>());
  if (const Json& wave = report["long_wave"]; !wave.is_null()) {
    text += fmt::format("  longest wave            {:.4g} rad/s: heave / C33 = {}", wave["rad_s"].get<double>(),
                        short_number(wave["heave"]));
    text += fmt::format(", horizontal / inertia = {}, phase {}\n", short_number(wave["horizontal"]),
                        wave["phase_right"].get<bool>() ? "as exp(+i w t)" : "wrong");
  }
  for (const Json& mode : report["natural_periods"])
    text += fmt::format("  natural period          {:<6} {:.4g} s\n", mode["mode"].get<std::string>(),
                        mode["period_s"].get<double>());
  return text;
}

std::string head_text(const Json& report) {
  const auto number = [&](const char* key) { return report[key].get<double>(); };
  std::string text =
      fmt::format("{}\n  density {:.6g} kg/m^3, gravity {:.6g} m/s^2, depth {}, displaced volume {}\n",
                  report["file"].get<std::string>(), number("density_kg_m3"), number("gravity_m_s2"),
                  report["depth_m"].is_null() ? "infinite" : short_number(report["depth_m"]) + " m",
                  report["volume_m3"].is_null() ? "not stated" : short_number(report["volume_m3"]) + " m^3");
  text += fmt::format("  {} frequencies from {:.4g} to {:.4g} rad/s", report["frequencies"].get<int>(),
                      number("lowest_rad_s"), number("highest_rad_s"));
  if (const int headings = report["headings"].get<int>(); headings == 1)
    text += fmt::format(", the heading {:.4g} deg", number("heading_first_deg"));
  else if (headings > 1)
    text += fmt::format(", {} headings from {:.4g} to {:.4g} deg", headings, number("heading_first_deg"),
                        number("heading_last_deg"));
  std::string parts;
  for (const Json& part : report["has"]) parts += (parts.empty() ? "" : ", ") + part.get<std::string>();
  return text + "\n  has " + parts + "\n";
}

}  // namespace

Json database_report(const hydro::Database& database, const hydro::SelfCheck& check, const std::optional<Mat6>& mass) {
  Json has = Json::array({"added mass", "damping"});
  const auto add = [&](bool there, const char* what) {
    if (there) has.push_back(what);
  };
  add(database.added_mass_infinite.has_value(), "A(inf)");
  add(!database.excitation.empty(), "wave excitation");
  add(!database.motion.empty(), "motions");
  add(!database.drift.empty(), "mean drift");
  add(database.restoring.has_value(), "hydrostatic stiffness");
  add(database.mass.has_value(), "mass");
  constexpr double k_symmetric = 0.15;  // share beyond which a finding says so
  Json report{{"file", database.source},
              {"density_kg_m3", database.density},
              {"gravity_m_s2", database.gravity},
              {"depth_m", or_null(database.depth)},
              {"volume_m3", or_null(database.volume)},
              {"frequencies", database.frequency.size()},
              {"lowest_rad_s", database.frequency.front()},
              {"highest_rad_s", database.frequency.back()},
              {"headings", database.heading.size()},
              {"heading_first_deg", database.heading.empty() ? Json() : Json(database.heading.front() / k_deg)},
              {"heading_last_deg", database.heading.empty() ? Json() : Json(database.heading.back() / k_deg)},
              {"has", has},
              {"modes", modes_json(database)},
              {"symmetric", check.asymmetry.share < k_symmetric},
              {"asymmetry", check.asymmetry.share},
              {"damping_positive", check.negative.empty()},
              {"distance_to_infinite", distance_to_limit(database)},
              {"long_wave", long_wave_json(check)},
              {"haskind_newman", haskind_json(check)},
              {"no_haskind_newman", check.no_haskind},
              {"closure", closure_json(check)},
              {"no_closure", check.no_closure},
              {"natural_periods", periods_json(database, mass)}};
  report["faults"] = Json::array();
  report["warnings"] = Json::array();
  for (const hydro::Finding& finding : hydro::findings(database, check))
    report[finding.severe ? "faults" : "warnings"].push_back(finding.text);
  return report;
}

std::string database_text(const Json& report) {
  return head_text(report) + modes_text(report) + checks_text(report) + haskind_text(report) + closure_text(report);
}

}  // namespace nilas::commands
