#include "apps/nilas/hydro/database_picture.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "apps/nilas/reports/templates.h"
#include "core/output/text/fill_template.h"
#include "core/output/text/plot.h"
#include "hydro/database/self_check.h"

namespace nilas::commands {

namespace {

using Json = nlohmann::ordered_json;

/// Up to three headings, from the first to the last.
std::vector<std::size_t> drawn_headings(const hydro::Database& database) {
  const std::size_t count = database.excitation.empty() ? 0 : database.heading.size();
  if (count <= 3) {
    std::vector<std::size_t> all;
    for (std::size_t h = 0; h < count; ++h) all.push_back(h);
    return all;
  }
  return {0, count / 2, count - 1};
}

/// Rows of w, A, B, A(inf) and the moduli for the headings that are drawn.
std::string rows_of(const hydro::Database& database, int mode, const std::vector<std::size_t>& headings) {
  std::string rows;
  for (std::size_t k = 0; k < database.frequency.size(); ++k) {
    const std::string limit = database.added_mass_infinite
                                  ? fmt::format("{:.6g}", (*database.added_mass_infinite)(mode, mode))
                                  : std::string("NaN");
    rows += fmt::format("{:.6g} {:.6g} {:.6g} {}", database.frequency[k], database.added_mass[k](mode, mode),
                        database.damping[k](mode, mode), limit);
    for (const std::size_t h : headings) rows += fmt::format(" {:.6g}", std::abs(database.excitation[k][h][mode]));
    rows += "\n";
  }
  return rows;
}

}  // namespace

void draw_database(const hydro::Database& database, const std::filesystem::path& picture) {
  const std::vector<std::size_t> headings = drawn_headings(database);
  constexpr int k_first_modulus = 5;  // column of the rows
  Json modes = Json::array();
  for (int i = 0; i < static_cast<int>(hydro::k_mode_name.size()); ++i) {
    Json lines = Json::array();
    for (std::size_t n = 0; n < headings.size(); ++n)
      lines.push_back({{"column", k_first_modulus + static_cast<int>(n)},
                       {"label", fmt::format("{:.4g} deg", database.heading[headings[n]] / k_deg)},
                       {"block", hydro::k_mode_name[i]},
                       {"more", n + 1 < headings.size()}});
    modes.push_back({{"name", hydro::k_mode_name[i]},
                     {"rows", rows_of(database, i, headings)},
                     {"mass_unit", i > 2 ? "kg m^2" : "kg"},
                     {"damping_unit", i > 2 ? "kg m^2/s" : "kg/s"},
                     {"load_unit", i > 2 ? "N m/m" : "N/m"},
                     {"lines", lines}});
  }
  const Json data{{"picture", picture.filename().string()},
                  {"title", std::filesystem::path(database.source).filename().string()},
                  {"loads", !headings.empty()},
                  {"modes", modes}};
  const std::filesystem::path folder = picture.has_parent_path() ? picture.parent_path() : ".";
  output::plot(folder, output::fill_template(nilas_template("database.gnuplot"), data, output::Escape::gnuplot));
}

}  // namespace nilas::commands
