#pragma once
/// Which ice made the largest load, and where it acted.
#include <cstdint>
#include <optional>
#include <string>

#include "apps/report/run/hull_contacts.h"
#include "core/geometry/mesh.h"

namespace nilas::report {

struct PeakCause {
  std::int64_t floe = 0;        ///< id of the floe that contributed most
  double share = 0;             ///< its share of the load along the course, 0 to 1 where all push the same way
  std::size_t floes = 0;        ///< number of floes that pressed in that step
  Vec3 place = Vec3::Zero();    ///< middle of its force, in the frame of the contacts [m]
  Vec2 course = Vec2::UnitX();  ///< horizontal unit vector along the course in that step, in G
};

/// The cause of the load of the step that ends at `time`, whose load is `along` (positive against the course) and
/// `across` (positive to port) [N]. The course is the direction in which the contacts' horizontal force has these
/// components. Empty where the step has no contact with a force. `not_ice`: ids of walls and bodies, whose contacts do
/// not count, since the load is that of ice.
std::optional<PeakCause> peak_cause(const HullContacts& contacts, double time, double h, double along, double across,
                                    const std::vector<std::int64_t>& not_ice = {});

/// Where a place on a vessel is, in words: "at the bow on the port side". `mesh`: in V.
std::string place_on_vessel(const Vec3& place, const geometry::TriangleMesh& mesh);

}  // namespace nilas::report
