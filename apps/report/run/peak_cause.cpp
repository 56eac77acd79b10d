#include "apps/report/run/peak_cause.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace nilas::report {

namespace {

/// Force of one floe in the step, and the sum of its places weighted by the sizes of the forces.
struct FloeShare {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0;
};

}  // namespace

std::optional<PeakCause> peak_cause(const HullContacts& contacts, double time, double h, double along, double across,
                                    const std::vector<std::int64_t>& not_ice) {
  std::map<std::int64_t, FloeShare> floes;
  Vec3 total = Vec3::Zero();
  for (std::size_t k = 0; k < contacts.time.size(); ++k) {
    if (std::abs(contacts.time[k] - time) > 0.5 * h) continue;
    if (std::find(not_ice.begin(), not_ice.end(), contacts.other[k]) != not_ice.end()) continue;
    FloeShare& floe = floes[contacts.other[k]];
    const double size = contacts.force[k].norm();
    floe.force += contacts.force[k];
    floe.moment += size * contacts.place[k];
    floe.size += size;
    total += contacts.force[k];
  }
  if (floes.empty()) return std::nullopt;
  PeakCause cause;
  // along = -F . course and across = F . port
  const double turn = std::atan2(total.y(), total.x()) - std::atan2(across, -along);
  cause.course = direction_of(turn);
  cause.floes = floes.size();
  double best = -std::numeric_limits<double>::infinity();
  const double side = along < 0 ? 1 : -1;
  for (const auto& [id, floe] : floes) {
    const double part = side * floe.force.head<2>().dot(cause.course);
    if (part <= best) continue;
    best = part;
    cause.floe = id;
    cause.place = floe.moment / floe.size;
  }
  cause.share = along == 0 ? 0 : best / std::abs(along);
  return cause;
}

std::string place_on_vessel(const Vec3& place, const geometry::TriangleMesh& mesh) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  const double share = (place.x() - low.x()) / (high.x() - low.x());
  constexpr double k_third = 1.0 / 3, k_middle = 0.05;
  const char* length = share > 1 - k_third ? "at the bow" : share > k_third ? "amidships" : "at the stern";
  const double side = (place.y() - 0.5 * (low.y() + high.y())) / (high.y() - low.y());
  if (std::abs(side) < k_middle) return std::string(length) + " near the centre plane";
  return std::string(length) + (side > 0 ? " on the port side" : " on the starboard side");
}

}  // namespace nilas::report
