#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "apps/verify/extremes.h"
#include "apps/verify/templates.h"
#include "core/base/error.h"
#include "core/output/text/fill_template.h"
#include "core/output/text/plot.h"

namespace nilas::verify {

namespace {

std::string row_name(const Cell& cell) { return cell.extreme + " " + cell.level; }
std::string column_name(const Cell& cell) {
  return cell.model.solver + (cell.model.integrator == "moreau" ? " m" : " e");
}

/// Returns the letter that a cell shows beside its colour, so that the map can be read in grey print.
char letter(Hold hold) {
  switch (hold) {
    case Hold::holds:
      return ' ';
    case Hold::short_of_it:
      return 's';
    case Hold::stopped:
      return 'x';
    case Hold::refused:
      return 'r';
    case Hold::stated:
      return 'l';
    case Hold::fails:
      break;
  }
  return 'F';
}

std::vector<std::string> distinct(const std::vector<Cell>& cells, std::string (*name)(const Cell&)) {
  std::vector<std::string> names;
  for (const auto& cell : cells)
    if (std::find(names.begin(), names.end(), name(cell)) == names.end()) names.push_back(name(cell));
  return names;
}

std::string ticks(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k) text += fmt::format("{}'{}' {}", k > 0 ? "," : "", names[k], k);
  return text;
}

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

}  // namespace

std::string extremes_text(const std::vector<Cell>& cells) {
  const auto rows = distinct(cells, row_name), columns = distinct(cells, column_name);
  std::string text = "columns (e: semi-implicit-euler, m: moreau):\n";
  for (std::size_t k = 0; k < columns.size(); ++k) text += fmt::format("  {:>2} {}\n", k + 1, columns[k]);
  text += fmt::format("{:<36}", "");
  for (std::size_t k = 0; k < columns.size(); ++k) text += fmt::format("{:>2} ", k + 1);
  text += "\n";
  for (const auto& row : rows) {
    text += fmt::format("{:<36}", row);
    for (const auto& column : columns) {
      const auto cell = std::find_if(cells.begin(), cells.end(), [&](const Cell& one) {
        return row_name(one) == row && column_name(one) == column;
      });
      const char mark = cell == cells.end() ? '-' : cell->hold == Hold::holds ? '.' : letter(cell->hold);
      text += fmt::format("{:>2} ", mark);
    }
    text += "\n";
  }
  text +=
      ". holds   s breaks a limit, the run reported a missed tolerance   x stopped with an error\n"
      "r refused   l breaks a limit as documented   F breaks a limit, nothing was reported   - not run\n";
  for (const auto& cell : cells)
    if (cell.hold == Hold::fails)
      text +=
          fmt::format("FAILS {} with {} {}: energy gained {:.2g}, momentum {:.2g}, penetration {:.2g}, drift {:.2g}\n",
                      row_name(cell), cell.model.solver, cell.model.integrator, cell.energy_won, cell.momentum_error,
                      cell.penetration, cell.drift);
  return text;
}

nlohmann::ordered_json extremes_json(const std::vector<Cell>& cells) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& cell : cells)
    list.push_back({{"extreme", cell.extreme},
                    {"level", cell.level},
                    {"solver", cell.model.solver},
                    {"integrator", cell.model.integrator},
                    {"verdict", to_string(cell.hold)},
                    {"energy_won", cell.energy_won},
                    {"momentum_error", cell.momentum_error},
                    {"penetration", cell.penetration},
                    {"drift", cell.drift},
                    {"law_map_m_s", cell.residual},
                    {"short_steps", cell.short_steps},
                    {"message", cell.message}});
  return {{"cells", list}};
}

std::string extremes_csv(const std::vector<Cell>& cells) {
  std::string text =
      "extreme,level,solver,integrator,verdict,energy_won,momentum_error,penetration,drift,law_map_m_s,short_steps,"
      "message\n";
  for (const auto& cell : cells) {
    std::string message = cell.message;
    std::replace(message.begin(), message.end(), '"', '\'');
    std::replace(message.begin(), message.end(), '\n', ' ');
    text += fmt::format("{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{},{}\n", in_quotes(cell.extreme),
                        cell.level, cell.model.solver, cell.model.integrator, to_string(cell.hold), cell.energy_won,
                        cell.momentum_error, cell.penetration, cell.drift, cell.residual, cell.short_steps,
                        in_quotes(message));
  }
  return text;
}

void write_extremes(const std::filesystem::path& folder, const std::vector<Cell>& cells) {
  std::ofstream out(folder / "extremes.csv");
  out << extremes_csv(cells);
  if (!out.flush()) throw FileError("cannot write " + (folder / "extremes.csv").string());
  const auto rows = distinct(cells, row_name), columns = distinct(cells, column_name);
  std::string marks;
  for (const auto& cell : cells) {
    const auto x = std::find(columns.begin(), columns.end(), column_name(cell)) - columns.begin();
    const auto y = std::find(rows.begin(), rows.end(), row_name(cell)) - rows.begin();
    marks += fmt::format("{} {} {} {}\n", x, y, static_cast<int>(cell.hold),
                         cell.hold == Hold::holds ? "." : std::string(1, letter(cell.hold)));
  }
  const nlohmann::ordered_json data{
      {"cells", marks},
      {"right", static_cast<double>(columns.size()) - 0.5},
      {"bottom", static_cast<double>(rows.size()) - 0.5},
      {"columns", ticks(columns)},
      {"rows", ticks(rows)},
      {"formats",
       {{{"kind", "svg"}, {"terminal", "svg size 1000,1150 font 'sans,12' background '#ffffff'"}},
        {{"kind", "png"}, {"terminal", "pngcairo size 1250,1440 font 'sans,12'"}}}}};
  output::plot(folder, output::fill_template(verify_template("extremes.gnuplot"), data, output::Escape::gnuplot));
}

}  // namespace nilas::verify
