#include "apps/nilas/reports/check_mooring.h"

#include <fmt/format.h>

#include <vector>

#include "core/sim/build/moored_vessel.h"

namespace nilas::commands {

std::optional<MooringReport> mooring_report(const sim::WorldParts& parts) {
  if (!parts.mooring) return std::nullopt;
  const sim::MooringAtStart start = sim::mooring_at_start(parts);
  const Wrench& load = start.loads.on_hull;
  MooringReport report;
  report.text = "\nmooring at the start, at rest, in the ground frame about the centre of mass:\n";
  auto lines = nlohmann::ordered_json::object();
  for (std::size_t k = 0; k < parts.mooring->lines.size(); ++k) {
    const std::string& name = parts.mooring->lines[k].name;
    report.text += fmt::format("  line {:<12} {:>10.4g} N\n", name, start.loads.tensions[k]);
    lines[name] = start.loads.tensions[k];
  }
  report.text +=
      fmt::format("  force  {:>10.4g} {:>10.4g} {:>10.4g} N\n", load.force.x(), load.force.y(), load.force.z());
  report.text +=
      fmt::format("  torque {:>10.4g} {:>10.4g} {:>10.4g} N m\n", load.torque.x(), load.torque.y(), load.torque.z());
  report.text += "  stiffness for translations [m] and rotations [rad]:\n";
  auto rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < start.stiffness.rows(); ++i) {
    std::vector<double> row;
    report.text += "   ";
    for (Eigen::Index j = 0; j < start.stiffness.cols(); ++j) {
      row.push_back(start.stiffness(i, j));
      report.text += fmt::format(" {:>10.3g}", row.back());
    }
    report.text += "\n";
    rows.push_back(row);
  }
  report.json = {{"tensions_N", lines},
                 {"force_N", {load.force.x(), load.force.y(), load.force.z()}},
                 {"torque_Nm", {load.torque.x(), load.torque.y(), load.torque.z()}},
                 {"stiffness", rows}};
  return report;
}

}  // namespace nilas::commands
