#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "core/vessel/mooring/mooring_model.h"

namespace nilas::vessel {

namespace {

/// Index of the row at the end of the segment that holds a stretch; 0 before the first row.
std::size_t end_of_segment(const std::vector<SpringLine::Point>& curve, double stretch) {
  const auto above = std::lower_bound(curve.begin(), curve.end(), stretch,
                                      [](const SpringLine::Point& row, double e) { return row.stretch < e; });
  return std::min<std::size_t>(static_cast<std::size_t>(above - curve.begin()), curve.size() - 1);
}

double slope_before(const std::vector<SpringLine::Point>& curve, std::size_t k) {
  return (curve[k].tension - curve[k - 1].tension) / (curve[k].stretch - curve[k - 1].stretch);
}

LineForce pull_of(const SpringLine& line, const Vec3& to_anchor) {
  LineForce force;
  const double distance = to_anchor.norm();
  if (!(distance > 0)) return force;
  const double stretch = distance - line.length, tension = line.tension(stretch);
  const Vec3 along = to_anchor / distance;
  force.on_fairlead = tension * along;
  force.stiffness = line.slope(stretch) * along * along.transpose() +
                    tension / distance * (Mat3::Identity() - along * along.transpose());
  force.fairlead_tension = force.anchor_tension = tension;
  force.strain = std::max(0.0, stretch) / line.length;
  return force;
}

LineForce pull_of(const CatenaryLine& line, std::optional<double> bed, const MooringLine& of, const Vec3& fairlead) {
  const Vec2 out = (fairlead - of.anchor).head<2>();
  const std::optional<double> resting = axis_on_bed(of, bed);
  double foot = of.anchor.z();
  if (resting && line.diameter > 0) foot = std::max(foot, *resting);
  CatenarySpan span{out.norm(), fairlead.z() - foot, std::nullopt};
  if (resting) {
    span.above_bed = foot - *resting;
    if (*span.above_bed + span.up < 0)
      throw SimulationError(fmt::format("mooring line '{}': its fairlead is {:.4g} m below {}", of.name,
                                        -(*span.above_bed + span.up),
                                        line.diameter > 0 ? "the axis of a line on the sea bed" : "the sea bed"));
  }
  const CatenaryForces at = solve_catenary(line, span);
  LineForce force;
  // Below this distance, in lengths of the line, its direction is rounding, and the line is plumb.
  constexpr double k_plumb = 1e-12;
  const bool plumb = !(span.across > k_plumb * line.length);
  const Vec3 away = plumb ? Vec3::UnitX() : Vec3(out.x() / span.across, out.y() / span.across, 0);
  const Vec3 up = Vec3::UnitZ(), aside = up.cross(away);
  const double turning = plumb ? at.stiffness(0, 0) : at.fairlead_across / span.across;
  force.on_fairlead = -at.fairlead_across * away - at.fairlead_down * up;
  force.stiffness = at.stiffness(0, 0) * away * away.transpose() + at.stiffness(0, 1) * away * up.transpose() +
                    at.stiffness(1, 0) * up * away.transpose() + at.stiffness(1, 1) * up * up.transpose() +
                    turning * aside * aside.transpose();
  force.fairlead_tension = at.fairlead_tension();
  force.anchor_tension = at.anchor_tension();
  force.strain = greatest_strain(line, at);
  return force;
}

}  // namespace

double SpringLine::tension(double stretch) const {
  if (stretch < curve.front().stretch) return 0;
  const std::size_t k = std::max<std::size_t>(end_of_segment(curve, stretch), 1);
  return curve[k - 1].tension + slope_before(curve, k) * (stretch - curve[k - 1].stretch);
}

double SpringLine::slope(double stretch) const {
  const std::size_t k = end_of_segment(curve, stretch);
  return k == 0 ? 0 : slope_before(curve, k);
}

SpringLine bilinear_spring(double length, double stiffness, double knee, double second) {
  return {length, {{0, 0}, {knee, stiffness * knee}, {knee + 1, stiffness * knee + second}}};
}

SpringLine tabulated_spring(double length, const std::string& csv_file, double scale) {
  const CsvTable table = read_csv(csv_file, {"stretch_m", "tension_N"});
  SpringLine line{length, {}};
  const auto refuse = [&](std::size_t row, const std::string& message) {
    throw InputError(fmt::format("{}:{}: {}", csv_file, table.lines[row], message));
  };
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const SpringLine::Point point{table.rows[k][0], table.rows[k][1]};
    if (point.tension < 0) refuse(k, fmt::format("found a tension of {:g} N; allowed: >= 0", point.tension));
    if (k > 0) {
      const SpringLine::Point before{table.rows[k - 1][0], table.rows[k - 1][1]};
      if (!(point.stretch > before.stretch))
        refuse(k, fmt::format("found a stretch of {:g} m; allowed: more than in the row before, {:g} m", point.stretch,
                              before.stretch));
      if (point.tension < before.tension)
        refuse(k, fmt::format("found a tension of {:g} N; allowed: no less than in the row before, {:g} N",
                              point.tension, before.tension));
    }
    line.curve.push_back({scale * point.stretch, scale * scale * scale * point.tension});
  }
  if (line.curve.size() < 2) refuse(0, "found one row; allowed: two rows or more");
  return line;
}

std::optional<double> axis_on_bed(const MooringLine& line, std::optional<double> bed) {
  const auto* catenary = std::get_if<CatenaryLine>(&line.form);
  if (!bed || !catenary || !(catenary->weight > 0)) return std::nullopt;
  return *bed + 0.5 * catenary->diameter;
}

LineForce line_force(const MooringLine& line, std::optional<double> bed, const Vec3& fairlead) {
  if (const auto* spring = std::get_if<SpringLine>(&line.form)) return pull_of(*spring, line.anchor - fairlead);
  return pull_of(std::get<CatenaryLine>(line.form), bed, line, fairlead);
}

}  // namespace nilas::vessel
