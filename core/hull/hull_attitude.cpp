#include "core/hull/hull_attitude.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace nilas::hull {

namespace {

/// Values of HullMeasures::lopsided: up to the first a solid is symmetric, above the second it is certainly not.
constexpr double k_symmetric = 3e-3, k_lopsided = 1e-2;

bool symmetric(const HullMeasures& m, int axis) { return m.lopsided[axis] < k_symmetric; }
bool lopsided(const HullMeasures& m, int axis) { return m.lopsided[axis] > k_lopsided; }

/// Direction of the deck: 1 where the bottom tapers under a level deck, -1 for the reverse, 0 where both or neither are
/// level.
int deck_direction(const HullMeasures& m) {
  constexpr double k_level = 0.96, k_tapered = 0.9;
  if (m.flat_top >= k_level && m.flat_bottom <= k_tapered) return 1;
  if (m.flat_bottom >= k_level && m.flat_top <= k_tapered) return -1;
  return 0;
}

/// Whether the solid has only upright walls and level faces, with any outline in plan.
bool prismatic(const HullMeasures& m) {
  constexpr double k_level = 0.95;
  return std::min(m.flat_top, m.flat_bottom) > k_level;
}

/// Longer of two axes.
int longer(const HullMeasures& m, int a, int b) { return m.size()[b] > m.size()[a] ? b : a; }

/// Axes with forward along `forward` and port along `port`, in the directions that the shape indicates; otherwise as
/// drawn or along the axis. A fixed solid without a bow may be a foundation, which has its level face below.
MeshAxes directed(const geometry::TriangleMesh& mesh, int forward, int port, bool fixed) {
  MeshAxes axes{{forward, 1}, {3 - forward - port, 1}};
  const HullMeasures m = measure_hull(turned(mesh, axes));
  const int bow = bow_direction(m);
  if (deck_direction(m) < 0 && (!fixed || bow != 0)) axes.up.sign = -1;
  if (bow < 0) axes.forward.sign = -1;
  return axes;
}

/// Forward and port axes that follow from the planes of symmetry; empty where y may be port.
struct Lying {
  int forward, port;
};
std::optional<Lying> by_planes(const HullMeasures& m) {
  const Vec3 size = m.size();
  if (!lopsided(m, 1)) return std::nullopt;
  constexpr double k_longer = 1.2, k_flat = 1.5;
  if (symmetric(m, 0) && symmetric(m, 2)) {  // both ends alike, or deck and keel
    if (k_flat * size.y() < std::min(size.x(), size.z())) return Lying{longer(m, 0, 2), size.x() < size.z() ? 0 : 2};
    if (size.y() > k_longer * std::max(size.x(), size.z())) return Lying{1, longer(m, 0, 2)};
    return std::nullopt;
  }
  for (const auto& [port, other] : {std::pair{0, 2}, std::pair{2, 0}}) {
    const int forward = longer(m, 1, other);
    if (symmetric(m, port) && size[forward] > k_longer * size[port]) return Lying{forward, port};
  }
  return std::nullopt;
}

std::optional<HullAttitude> by_symmetry(const geometry::TriangleMesh& mesh, const HullMeasures& m, bool fixed) {
  const auto lying = by_planes(m);
  if (!lying) return std::nullopt;
  // an upright prism of any outline is symmetric top to bottom, and a pier stands on end
  constexpr double k_wall = 1.5;
  if (lying->port == 2 && prismatic(m) && (fixed || m.size().z() < k_wall * m.size().y())) return std::nullopt;
  if (lying->forward == 2 && (fixed || prismatic(m))) return std::nullopt;
  return HullAttitude{directed(mesh, lying->forward, lying->port, fixed), AttitudeSign::symmetry};
}

/// Attitude from the side lengths of a floating solid that is symmetric about y = const, where they do not fit a ship
/// or barge.
std::optional<HullAttitude> by_slenderness(const geometry::TriangleMesh& mesh, const HullMeasures& m) {
  const Vec3 size = m.size();
  constexpr double k_broad = 1.5, k_high = 1.5, k_long = 2, k_very_broad = 2.5, k_longer = 1.2;
  const auto lies = [&](int forward, int port) {
    return HullAttitude{directed(mesh, forward, port, false), AttitudeSign::slender};
  };
  if (symmetric(m, 0) && size.y() > k_broad * size.x() && size.y() > size.z())
    return lies(1, symmetric(m, 2) && size.z() > k_high * size.x() ? 2 : 0);
  // a body that differs ahead and astern has its bow there, however broad it is, unless it tapers to the sides
  if (lopsided(m, 0) && symmetric(m, 2) && !prismatic(m) && size.y() > k_very_broad * size.x() &&
      size.y() > k_longer * size.z())
    return lies(1, 2);
  if (symmetric(m, 2) && size.z() > k_high * size.y() && size.x() > k_long * size.z()) return lies(0, 2);
  // a spar or a column is round or square
  if (lopsided(m, 0) && size.z() > k_high * std::max(size.x(), size.y()) && !prismatic(m)) return lies(2, 1);
  return std::nullopt;
}

/// A hull that lies along x with its sides to port and starboard: bow and stern, deck and keel.
HullAttitude by_ends_and_faces(const HullMeasures& m) {
  HullAttitude found;
  const Vec3 size = m.size();
  constexpr double k_pointed = 1.5, k_ship = 2,
                   k_barge = 2.5;  // length over beam; shorter ones are indenters, caissons
  constexpr double k_tower = 1.5;  // height over beam
  const double least = symmetric(m, 0) ? k_barge : k_ship;
  if (size.x() > least * size.y() && size.z() < k_tower * size.y() && deck_direction(m) < 0) {
    found.axes.up.sign = -1;
    found.sign = AttitudeSign::faces;
  }
  if (size.x() > k_pointed * size.y() && bow_direction(m) < 0) {
    found.axes.forward.sign = -1;
    found.sign = found.sign == AttitudeSign::none ? AttitudeSign::ends : found.sign;
  }
  return found;
}

}  // namespace

int bow_direction(const HullMeasures& m) {
  constexpr double k_sharp = 0.35, k_broad = 0.5, k_square = 0.65;  // less is round, as the bow of a submarine
  constexpr double k_full = 0.2, k_fuller = 2.5;
  const auto bow_and_stern = [](double sharp, double fine, double broad, double full, double square) {
    return sharp <= k_sharp && broad >= k_broad && square >= k_square && full >= k_full && full >= k_fuller * fine;
  };
  if (bow_and_stern(m.broad_fore, m.full_fore, m.broad_aft, m.full_aft, m.square_aft)) return 1;
  if (bow_and_stern(m.broad_aft, m.full_aft, m.broad_fore, m.full_fore, m.square_fore)) return -1;
  return 0;
}

HullAttitude probable_attitude(const geometry::TriangleMesh& mesh, bool fixed) {
  const HullMeasures m = measure_hull(mesh);
  if (const auto found = by_symmetry(mesh, m, fixed)) return *found;
  if (fixed) return {};
  if (!lopsided(m, 1))
    if (const auto found = by_slenderness(mesh, m)) return *found;
  return by_ends_and_faces(m);
}

}  // namespace nilas::hull
