#include "core/output/tables/contact_rows.h"

#include <algorithm>
#include <cmath>

#include "contact/law/law_map.h"
#include "core/sim/world/load_axes.h"

namespace nilas::output {

/// Relative velocity per unit impulse between the two bodies, without rotation [1/kg].
static double inverse_mass(const std::array<contact::TouchingBody, 2>& touching) {
  return touching[0].inverse_mass + touching[1].inverse_mass;
}

/// Tangential impulse that the law still permits before the contact slips.
static double friction_left(const contact::ContactProblem& problem, std::size_t c, const Vec3& r) {
  if (problem.law == Law::frictionless) return 0;
  const double used =
      problem.law == Law::pyramid ? std::max(std::abs(r.y()), std::abs(r.z())) : std::hypot(r.y(), r.z());
  return std::max(0.0, problem.mu[c] * r.x() - used);
}

ContactStatus contact_status(const contact::SolvedProblem& solved, std::size_t c) {
  const auto row = 3 * static_cast<Eigen::Index>(c);
  const Vec3 r = solved.solution.r.segment<3>(row);
  const Vec3 u = contact::compliant_velocity(solved.problem, static_cast<int>(c), r, solved.solution.u.segment<3>(row));
  const double d = inverse_mass(solved.touching[c]);
  if (u.x() >= d * r.x()) return ContactStatus::open;
  if (r.x() >= solved.problem.force_limit[c] ||
      (solved.points[c].crushes() && solved.problem.compliance[c] > 0 && r.x() > 0))
    return ContactStatus::crush;
  return std::hypot(u.y(), u.z()) > d * friction_left(solved.problem, c, r) ? ContactStatus::slip
                                                                            : ContactStatus::stick;
}

LoadedBodies loaded_bodies(const bodies::Bodies& bodies, const sim::RunInfo& info) {
  LoadedBodies loaded{
      .vessel = -1, .num_parts = static_cast<int>(info.parts.size()), .com_V = info.vessel_mass.com, .structures = {}};
  for (std::size_t b = 0; b < bodies.id.size(); ++b) {
    if (bodies.kind[b] == bodies::BodyKind::vessel && loaded.vessel < 0) loaded.vessel = static_cast<int>(b);
    if (!info.structures.empty() && sim::is_structure(bodies, b)) loaded.structures.push_back(bodies.id[b]);
  }
  return loaded;
}

std::vector<ContactRow> contact_rows(const contact::SolvedProblem& solved, const LoadedBodies& loaded,
                                     bool of_all_bodies) {
  const int vessel = loaded.vessel;
  const auto is_structure = [&](std::int64_t id) {
    return std::binary_search(loaded.structures.begin(), loaded.structures.end(), id);
  };
  std::vector<ContactRow> rows;
  for (std::size_t i = 0; i < solved.points.size(); ++i) {
    const detect::ContactPoint& c = solved.points[i];
    const bool of_vessel = loaded.is_of_vessel(c.a) || loaded.is_of_vessel(c.b);
    const bool on_structure_a = !of_vessel && is_structure(solved.touching[i][0].id);
    if (!of_all_bodies && !of_vessel && !on_structure_a && !is_structure(solved.touching[i][1].id)) continue;
    const bool on_b = of_vessel ? loaded.is_of_vessel(c.b) : !on_structure_a;
    const double sign = on_b ? 1 : -1;
    ContactRow row;
    row.body = solved.touching[i][on_b ? 1 : 0].id;
    row.other = solved.touching[i][on_b ? 0 : 1].id;
    row.p_G = c.p;
    if (vessel >= 0) row.p_V = solved.vessel_R.transpose() * (c.p - solved.vessel_p) + loaded.com_V;
    row.n = sign * c.n;
    row.gap = c.gap;
    row.impulse = sign * solved.impulses[i];
    if (!solved.couples.empty()) row.couple = sign * solved.couples[i];
    row.status = contact_status(solved, i);
    row.part = 1 + (on_b ? c.part_b : c.part_a);
    row.other_part = 1 + (on_b ? c.part_a : c.part_b);
    row.key = c.key;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace nilas::output
