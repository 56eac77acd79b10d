#include "apps/verify/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

namespace nilas::verify {

namespace {

const char* verdict(bool holds) { return holds ? "holds" : "FAILS"; }

std::string short_integrator(const Model& model) {
  if (model.continuous()) return "ref.";
  return model.integrator == "moreau" ? "moreau" : "euler";
}

/// Returns the error over the allowed error. Above 1 the row does not hold.
double strain(const Row& row) { return row.tolerance > 0 ? row.error / row.tolerance : row.error > 0 ? 1e300 : 0; }

struct Group {
  const Row* worst = nullptr;
  int solvers = 0;
  bool holds = true;
};

/// The case, the quantity and the input of a group of rows.
using Heading = std::tuple<std::string, std::string, std::string>;

}  // namespace

bool all_hold(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.holds; });
}

std::string table_text(const std::vector<Row>& rows) {
  std::map<Heading, std::map<std::pair<std::string, std::string>, Group>> groups;
  std::vector<Heading> order;
  for (const auto& row : rows) {
    const Heading heading{row.id, row.quantity, row.input};
    const auto [at, fresh] = groups.try_emplace(heading);
    if (fresh) order.push_back(heading);
    Group& group = at->second[{row.model.law, row.model.integrator}];
    ++group.solvers;
    group.holds = group.holds && row.holds;
    if (group.worst == nullptr || !(strain(row) <= strain(*group.worst))) group.worst = &row;
  }
  std::string text = fmt::format(
      "each line shows, of n solvers, the one nearest to its limit\n  {:<12} {:<6} {:>2} {:>12} {:>12} {:>8} {:>8} "
      "{:>5}\n",
      "law", "integ.", "n", "measured", "expected", "error", "allowed", "order");
  for (const auto& heading : order) {
    const auto& [id, quantity, input] = heading;
    text += fmt::format("{} {}{}\n", id, quantity, input == "as given" ? "" : ", " + input);
    for (const auto& [model, group] : groups.at(heading)) {
      const Row& row = *group.worst;
      text +=
          fmt::format("  {:<12} {:<6} {:>2} {:>12.6g} {:>12.6g} {:>8.1e} {:>8.1e} {:>5} {}\n", row.model.law,
                      short_integrator(row.model), group.solvers, row.measured, row.expected, row.error, row.tolerance,
                      row.proven_order > 0 ? fmt::format("{:.2f}", row.order) : "", verdict(group.holds));
    }
  }
  return text;
}

std::string failures_text(const std::vector<Row>& rows) {
  std::string text;
  for (const auto& row : rows)
    if (!row.holds)
      text += fmt::format("{} {} ({}), {} {} {}: measured {:.17g}, expected {:.17g}, error {:.3g} above {:.3g}{}{}\n",
                          row.id, row.quantity, row.input, row.model.law, row.model.solver, row.model.integrator,
                          row.measured, row.expected, row.error, row.tolerance,
                          row.proven_order > 0 ? fmt::format(", order {:.3f} of {}", row.order, row.proven_order) : "",
                          row.message.empty() ? "" : ": " + row.message);
  return text;
}

nlohmann::ordered_json table_json(const std::vector<Row>& rows) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& row : rows) {
    nlohmann::ordered_json entry{{"case", row.id},
                                 {"family", std::string(1, row.family)},
                                 {"quantity", row.quantity},
                                 {"input", row.input},
                                 {"law", row.model.law},
                                 {"solver", row.model.solver},
                                 {"integrator", row.model.integrator},
                                 {"step_s", row.model.step},
                                 {"measured", row.measured},
                                 {"expected", row.expected},
                                 {"error", row.error},
                                 {"scale", row.scale},
                                 {"tolerance", row.tolerance},
                                 {"order", nullptr},
                                 {"verdict", row.holds ? "holds" : "fails"}};
    if (row.proven_order > 0) entry["order"] = row.order;
    if (!row.message.empty()) entry["message"] = row.message;
    list.push_back(std::move(entry));
  }
  return list;
}

std::string table_csv(const std::vector<Row>& rows) {
  std::string text =
      "case,family,quantity,input,law,solver,integrator,step_s,measured,expected,scale,error,tolerance,order,verdict,"
      "message\n";
  const auto quoted = [](const std::string& cell) {
    return cell.find(',') == std::string::npos ? cell : '"' + cell + '"';
  };
  for (const auto& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{},{},{}\n", row.id,
                        row.family, quoted(row.quantity), quoted(row.input), row.model.law, row.model.solver,
                        row.model.integrator, row.model.step, row.measured, row.expected, row.scale, row.error,
                        row.tolerance, row.proven_order > 0 ? fmt::format("{:.17g}", row.order) : "",
                        row.holds ? "holds" : "fails", quoted(row.message));
  return text;
}

std::string catalogue_text() {
  std::string text;
  char family = 0;
  for (const auto& one : catalogue()) {
    if (one.family != family) text += fmt::format("{}  {}\n", one.family, family_title(one.family));
    family = one.family;
    text += fmt::format("  {:<4} {}\n", one.id(), one.title);
  }
  return text;
}

}  // namespace nilas::verify
