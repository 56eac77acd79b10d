#include "fracture/cut/crack_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "fracture/cut/smallest_box.h"
#include "fracture/cut/snap_lines.h"

namespace nilas::fracture {

namespace {

/// The sorted distances from `point` at which the line crosses the outline's edges. Their number is even, since
/// vertices on the line count as left of it. A vertex that the line passes within `resolution` adds two, an end and a
/// start.
std::vector<double> crossings(const std::vector<Vec2>& outline, const Vec2& point, const Vec2& along,
                              double resolution) {
  double reach = 0;
  for (const Vec2& p : outline) reach = std::max(reach, (p - point).norm());
  const Vec2 beyond = point + reach * along;
  const Vec2 line = (beyond - point).normalized();
  const auto left = [&](const Vec2& p) { return geometry::orientation(point, beyond, p) >= 0; };
  const auto height = [&](const Vec2& p) { return std::abs(line.x() * (p - point).y() - line.y() * (p - point).x()); };
  std::vector<double> found;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (height(a) <= resolution) found.insert(found.end(), 2, line.dot(a - point));
    if (left(a) == left(b)) continue;
    const double sum = height(a) + height(b), share = sum > 0 ? height(a) / sum : 0;
    found.push_back(line.dot(a - point) + share * line.dot(b - a));
  }
  std::sort(found.begin(), found.end());
  return found;
}

SplitVerdict judge_pieces(const std::vector<CutPiece>& pieces, const SplitRule& rule) {
  for (const CutPiece& piece : pieces)
    if (geometry::polygon_moments(piece.outline).area < rule.min_area) return SplitVerdict::too_small;
  for (const CutPiece& piece : pieces)
    if (smallest_box(piece.outline).aspect() > rule.max_aspect) return SplitVerdict::too_narrow;
  return SplitVerdict::splits;
}

/// The sorted shares of the way from `from` to `to` at which edges of the outline cross it.
std::vector<double> crossings_between(const std::vector<Vec2>& outline, const Vec2& from, const Vec2& to) {
  std::vector<double> found;
  const Vec2 way = to - from;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 start = outline[i] - from, edge = outline[(i + 1) % outline.size()] - outline[i];
    const double turn = cross2(way, edge);
    if (turn == 0) continue;
    const double share = cross2(start, edge) / turn, along = cross2(start, way) / turn;
    if (share > 0 && share <= 1 && along >= 0 && along < 1) found.push_back(share);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The points of a circumferential crack beyond the side of its fan, in chords that turn by `turn` [rad] each, from
/// the end of the side to just outside the ice. There are none where no ice is beyond the side, or where a quarter of a
/// turn does not lead out of it.
std::vector<Vec2> beyond_side(const std::vector<Vec2>& outline, const Vec2& apex, const Vec2& end, double turn) {
  constexpr double k_least_turn = 1e-3;  // [rad] Edges that turn away by less count as straight.
  constexpr double k_overshoot = 1e-6;   // share of a chord by which the crack passes the edge, so as to reach it
  const Vec2 arm = end - apex;
  const auto turned = [&](double angle) -> Vec2 { return apex + Eigen::Rotation2Dd(angle) * arm; };
  Vec2 from = turned(std::copysign(k_least_turn, turn));
  if (!geometry::contains(outline, from)) return {};
  std::vector<Vec2> points;
  const int most =
      static_cast<int>(std::ceil(k_pi / 2 / std::abs(turn) - 1e-6));  // a quarter of a turn in whole chords
  for (int k = 1; k <= most; ++k) {
    const Vec2 to = turned(k * turn);
    const std::vector<double> out = crossings_between(outline, from, to);
    points.push_back(out.empty() ? to : Vec2(from + (out.front() + k_overshoot) * (to - from)));
    if (!out.empty()) return points;
    from = to;
  }
  return {};
}

/// The number of chords per wedge that keep the tolerance: a chord over the angle a is off by radius (1 - cos(a / 2)).
int chords_per_wedge(const WedgeFan& fan) {
  if (fan.arc_tolerance >= fan.radius * (1 - std::cos(fan.wedge_angle / 2))) return 1;
  const double largest = 2 * std::acos(1 - fan.arc_tolerance / fan.radius);
  return static_cast<int>(std::ceil(fan.wedge_angle / largest));
}

}  // namespace

EdgePlace nearest_edge_place(const std::vector<Vec2>& outline, const Vec2& point) {
  NILAS_DEMAND(outline.size() >= 3);
  EdgePlace best{0, outline.front()};
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % n], along = b - a;
    const double square = along.squaredNorm();
    const double share = square > 0 ? along.dot(point - a) / square : 0;
    const Vec2 foot = share <= 0 ? a : share >= 1 ? b : Vec2(a + share * along);
    if ((foot - point).squaredNorm() < (best.point - point).squaredNorm()) best = {foot == b ? (i + 1) % n : i, foot};
  }
  const bool corner = best.point == outline[best.edge];
  const Vec2 onward = outline[(best.edge + 1) % n] - best.point;
  const Vec2 back = outline[corner ? (best.edge + n - 1) % n : best.edge] - best.point;
  best.inside = k_pi;
  if (corner) best.inside = std::atan2(onward.x() * back.y() - onward.y() * back.x(), onward.dot(back));
  if (best.inside <= 0) best.inside += 2 * k_pi;
  best.inward = direction_of(std::atan2(onward.y(), onward.x()) + 0.5 * best.inside);
  return best;
}

std::vector<Chord> chords(const std::vector<Vec2>& outline, const Vec2& point, double angle) {
  const Vec2 along = direction_of(angle);
  const double resolution = snap_resolution(outline);
  const std::vector<double> at = crossings(outline, point, along, resolution);
  std::vector<Chord> found;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2)
    if (at[i + 1] > resolution && at[i + 1] - at[i] > resolution)
      found.push_back({point + at[i] * along, point + at[i + 1] * along});
  return found;
}

std::optional<Chord> shortest_chord(const std::vector<Vec2>& outline, const Vec2& point, double angle) {
  const std::vector<Chord> all = chords(outline, point, angle);
  const auto shorter = [](const Chord& a, const Chord& b) { return a.length() < b.length(); };
  const auto best = std::min_element(all.begin(), all.end(), shorter);
  return best == all.end() ? std::nullopt : std::optional<Chord>(*best);
}

std::string name_of(SplitVerdict verdict) {
  switch (verdict) {
    case SplitVerdict::splits:
      return "splits";
    case SplitVerdict::no_chord:
      return "no chord";
    case SplitVerdict::below_bending:
      return "shorter than the bending radius";
    case SplitVerdict::above_reach:
      return "longer than the multiplier allows";
    case SplitVerdict::not_cut:
      return "not cut";
    case SplitVerdict::too_small:
      return "a piece is too small";
    case SplitVerdict::too_narrow:
      return "a piece is too narrow";
  }
  return "";
}

Split split_along(const std::vector<Vec2>& outline, const Vec2& breaking_point, double crack_angle,
                  const SplitRule& rule) {
  const std::optional<Chord> chord = shortest_chord(outline, breaking_point, crack_angle);
  if (!chord) return {};
  const double length = chord->length();
  if (length <= rule.bending_radius) return {SplitVerdict::below_bending, *chord};
  if (length >= rule.multiplier * rule.bending_radius) return {SplitVerdict::above_reach, *chord};
  return {verdict_on_cut(outline, {chord->start, chord->end}, rule), *chord};
}

SplitVerdict verdict_on_cut(const std::vector<Vec2>& outline, const std::vector<Vec2>& crack, const SplitRule& rule) {
  const CutResult cut = cut_outline(outline, {crack});
  return cut.status == CutStatus::cut ? judge_pieces(cut.pieces, rule) : SplitVerdict::not_cut;
}

WedgeFan fan_across(const std::vector<Vec2>& outline, const Vec2& point, double wedge_angle, double radius,
                    double arc_tolerance) {
  NILAS_DEMAND(wedge_angle > 0);
  const EdgePlace place = nearest_edge_place(outline, point);
  const int wedges = std::max(1, static_cast<int>(std::lround(place.inside / wedge_angle)));
  return {place.point,  std::atan2(place.inward.y(), place.inward.x()), wedges, place.inside / wedges, radius,
          arc_tolerance};
}

std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan) {
  NILAS_DEMAND(fan.wedges > 0 && fan.wedge_angle > 0 && fan.radius > 0 && fan.arc_tolerance > 0);
  NILAS_DEMAND(fan.wedges * fan.wedge_angle < 2 * k_pi);
  const int steps = chords_per_wedge(fan), last = fan.wedges * steps;
  std::vector<Vec2> arc;
  for (int i = 0; i <= last; ++i) {
    const double angle = fan.direction + (static_cast<double>(i) / steps - 0.5 * fan.wedges) * fan.wedge_angle;
    arc.push_back(fan.apex + fan.radius * direction_of(angle));
  }
  std::vector<std::vector<Vec2>> cracks;
  for (int i = 0; i <= last; i += steps) cracks.push_back({fan.apex, arc[i]});
  cracks.push_back(std::move(arc));
  return cracks;
}

double way_outside(const std::vector<Vec2>& outline, const Vec2& from, const Vec2& to) {
  constexpr double k_along_edge = 0.01;  // share of the way; a part that stays so near to an edge runs along it
  const double length = (to - from).norm();
  double share = 0, outside = 0;
  std::vector<double> ends = crossings_between(outline, from, to);
  ends.push_back(1);
  for (const double end : ends) {
    const Vec2 middle = from + 0.5 * (share + end) * (to - from);
    if (!geometry::contains(outline, middle) &&
        (nearest_edge_place(outline, middle).point - middle).norm() > k_along_edge * length)
      outside += end - share;
    share = end;
  }
  return outside * length;
}

std::vector<std::vector<Vec2>> to_free_edges(const std::vector<Vec2>& outline, const WedgeFan& fan,
                                             std::vector<std::vector<Vec2>> cracks) {
  NILAS_DEMAND(fan.wedges > 0 && static_cast<int>(cracks.size()) == fan.wedges + 2);
  const std::vector<Vec2> right = beyond_side(outline, fan.apex, cracks.back().front(), -fan.wedge_angle);
  const std::vector<Vec2> left = beyond_side(outline, fan.apex, cracks.back().back(), fan.wedge_angle);
  std::vector<Vec2>& around = cracks.back();
  around.insert(around.begin(), right.rbegin(), right.rend());
  around.insert(around.end(), left.begin(), left.end());
  // Ice between the fan's side and the free edge belongs to the outermost wedge.
  if (!left.empty()) cracks.erase(cracks.end() - 2);
  if (!right.empty()) cracks.erase(cracks.begin());
  return cracks;
}

double ray_angle(const WedgeFan& fan, int k) { return fan.direction + 0.5 * (k - fan.wedges) * fan.wedge_angle; }

std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan, const std::vector<double>& radii) {
  NILAS_DEMAND(fan.wedges > 0 && fan.wedge_angle > 0 && fan.wedges * fan.wedge_angle < 2 * k_pi);
  NILAS_DEMAND(static_cast<int>(radii.size()) == 2 * fan.wedges + 1);
  NILAS_DEMAND(*std::min_element(radii.begin(), radii.end()) > 0);
  std::vector<Vec2> around;
  for (int k = 0; k <= 2 * fan.wedges; ++k) around.emplace_back(fan.apex + radii[k] * direction_of(ray_angle(fan, k)));
  std::vector<std::vector<Vec2>> cracks;
  for (std::size_t k = 0; k < around.size(); k += 2) cracks.push_back({fan.apex, around[k]});
  cracks.push_back(std::move(around));
  return cracks;
}

}  // namespace nilas::fracture
