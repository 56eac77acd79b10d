#include "fracture/bend/edge_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "fracture/cut/crack_lines.h"

namespace nilas::fracture {

namespace {

using Group = std::vector<PointLoad>;

/// The least horizontal share of a force. Below it the load is vertical, since its direction in the plane is random
/// [-].
constexpr double k_least_level = 0.05;
/// The least force of a point that counts, over that of the strongest [-].
constexpr double k_least_force = 1e-12;

/// The groups of loads: the strongest load that is in no group yet, with all others within reach of it.
std::vector<Group> linked(const std::vector<Vec2>& outline, const std::vector<PointLoad>& loads,
                          const LoadReach& reach) {
  double strongest_force = 0;
  for (const PointLoad& load : loads) strongest_force = std::max(strongest_force, load.force.norm());
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < loads.size(); ++k)
    if (loads[k].force.norm() > k_least_force * strongest_force) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) {
    return loads[i].force.squaredNorm() > loads[k].force.squaredNorm();
  });
  std::vector<Group> groups;
  while (!order.empty()) {
    const Vec2 strongest = loads[order.front()].x.head<2>();
    Group group;
    std::erase_if(order, [&](std::size_t k) {
      const Vec2 x = loads[k].x.head<2>();
      if ((x - strongest).norm() > reach.link) return false;
      if ((x - strongest).norm() > reach.widest_gap && way_outside(outline, strongest, x) > reach.widest_gap)
        return false;
      group.push_back(loads[k]);
      return true;
    });
    groups.push_back(std::move(group));
  }
  return groups;
}

/// The length of an even load along a direction [m]. `whole` is the sum of the forces [N].
double extent(const Group& group, const Vec2& along, double whole) {
  const bool of_areas = std::all_of(group.begin(), group.end(), [](const PointLoad& p) { return p.of_area; });
  double low = std::numeric_limits<double>::infinity(), high = -low, mean = 0, square = 0;
  for (const PointLoad& p : group) {
    const double s = along.dot(p.x.head<2>());
    low = std::min(low, s);
    high = std::max(high, s);
    mean += p.force.norm() / whole * s;
  }
  if (!of_areas) return high - low;
  for (const PointLoad& p : group) square += p.force.norm() / whole * std::pow(along.dot(p.x.head<2>()) - mean, 2);
  return std::sqrt(12 * square);
}

/// Finds the edge point where the load came in: against its direction, or the nearest one for a vertical load.
void find_edge(const std::vector<Vec2>& outline, const Vec2& middle, double whole, EdgeContact& contact) {
  const EdgePlace nearest = nearest_edge_place(outline, middle);
  contact.edge_point = nearest.point;
  contact.inward = nearest.inward;
  const Vec2 level = contact.force.head<2>();
  contact.pushes_in = level.norm() > k_least_level * whole;
  if (contact.pushes_in) {
    contact.inward = level.normalized();
    const std::vector<Chord> ahead = chords(outline, middle, std::atan2(level.y(), level.x()));
    if (!ahead.empty()) contact.edge_point = ahead.front().start;
  }
  contact.from_edge = (middle - contact.edge_point).norm();
}

EdgeContact contact_of(const std::vector<Vec2>& outline, const Group& group) {
  EdgeContact contact;
  double whole = 0;
  Vec2 middle = Vec2::Zero();
  for (const PointLoad& p : group) {
    const double amount = p.force.norm();
    whole += amount;
    middle += amount * p.x.head<2>();
    contact.force += p.force;
    contact.speed += amount * p.speed;
  }
  contact.speed /= whole;
  find_edge(outline, middle / whole, whole, contact);
  const Vec2 along(-contact.inward.y(), contact.inward.x());
  contact.width = extent(group, along, whole);
  contact.depth = extent(group, contact.inward, whole);
  if (contact.pushes_in)
    for (const PointLoad& p : group) contact.opening += 0.5 * std::abs(along.dot(p.force.head<2>()));
  return contact;
}

}  // namespace

std::vector<EdgeContact> edge_contacts(const std::vector<Vec2>& outline, const std::vector<PointLoad>& loads,
                                       const LoadReach& reach) {
  NILAS_DEMAND(outline.size() >= 3 && reach.link >= 0 && reach.widest_gap >= 0);
  std::vector<EdgeContact> contacts;
  for (const Group& group : linked(outline, loads, reach)) contacts.push_back(contact_of(outline, group));
  return contacts;
}

}  // namespace nilas::fracture
