#pragma once
/// The lines of cracks: straight splitting cracks, and the wedges of a bending failure.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "fracture/cut/cut_outline.h"

namespace nilas::fracture {

/// A straight crack from edge to edge of an outline.
struct Chord {
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< [m]
  double length() const { return (end - start).norm(); }
};

/// A point on an outline's edge.
struct EdgePlace {
  std::size_t edge = 0;         ///< Edge from vertex `edge` on, that vertex included.
  Vec2 point = Vec2::Zero();    ///< [m]
  Vec2 inward = Vec2::UnitX();  ///< Unit vector into the polygon: the edge's normal, at a vertex the bisector.
  double inside = 0;            ///< Interior angle of the polygon at the point, pi along an edge [rad].
};

/// The nearest place on the edge of a counter-clockwise outline. Throws ContractError for fewer than three vertices.
EdgePlace nearest_edge_place(const std::vector<Vec2>& outline, const Vec2& point);

/// The chords of the outline on the line from `point` along `angle` [rad, from x], in order. They are all chords ahead
/// of the point, and the one that contains it, with its length behind the point. A point some distance inside the edge
/// therefore serves as well. A line along an edge may give the edge itself. A chord ends at a vertex that it touches
/// within snap_resolution. `outline` must be simple.
std::vector<Chord> chords(const std::vector<Vec2>& outline, const Vec2& point, double angle);

/// The shortest of chords(): the candidate of Metrikin (2014), section 5.2. Nothing where the line misses the outline.
std::optional<Chord> shortest_chord(const std::vector<Vec2>& outline, const Vec2& point, double angle);

/// The length of the straight way between two points that is not in the outline [m]. A part that runs along an edge, by
/// less than a hundredth of the way beside it, counts as inside: contact points lie on edges, to within the gap.
double way_outside(const std::vector<Vec2>& outline, const Vec2& from, const Vec2& to);

enum class SplitVerdict {
  splits,
  no_chord,       ///< The line does not pass through the ice.
  below_bending,  ///< The chord is not longer than the bending radius.
  above_reach,    ///< The chord is not shorter than `multiplier` bending radii.
  not_cut,        ///< The chord separates nothing, or a piece is not simple.
  too_small,      ///< A piece is below min_area.
  too_narrow      ///< The aspect of a piece is above max_aspect.
};
std::string name_of(SplitVerdict verdict);

struct SplitRule {
  double bending_radius = 0;  ///< R_bending: radius of the circumferential crack [m].
  double multiplier = 2.5;    ///< S_k
  double min_area = 2e-4;     ///< [m^2]
  double max_aspect = 8;      ///< R_size
};

struct Split {
  SplitVerdict verdict = SplitVerdict::no_chord;
  Chord chord;  ///< The candidate, for every verdict but no_chord.
};

/// The geometric splitting rule of Metrikin (2014), section 5.2. The shortest chord splits the floe where R_bending <
/// length < S_k R_bending and both pieces are simple, large and broad enough. `outline` must be simple and
/// counter-clockwise.
Split split_along(const std::vector<Vec2>& outline, const Vec2& breaking_point, double crack_angle,
                  const SplitRule& rule);

/// The verdict on a crack of any length: whether it cuts the outline into pieces that the rule accepts.
SplitVerdict verdict_on_cut(const std::vector<Vec2>& outline, const std::vector<Vec2>& crack, const SplitRule& rule);

/// The wedges that break off in bending around a loaded point of the edge.
struct WedgeFan {
  Vec2 apex = Vec2::Zero();  ///< The loaded point on the edge [m].
  double direction = 0;      ///< Direction of the fan's middle, into the ice, from x [rad].
  int wedges = 0;            ///< n_w
  double wedge_angle = 0;    ///< alpha_wedge [rad]
  double radius = 0;         ///< R_bending [m]
  /// The largest distance between the circumferential crack and its circle [m]. Infinite: one chord per wedge.
  double arc_tolerance = 0;
};

/// The fan at the edge point nearest to `point`. It spans the ice from edge to edge, half a turn or a corner's angle,
/// in equal wedges whose angle is nearest to `wedge_angle`. A fan that spans less would touch the edge at its apex
/// only, and leave a floe that is pinched there, which cut_outline refuses. `outline` must be simple and
/// counter-clockwise. Throws ContractError unless the wedge angle is positive.
WedgeFan fan_across(const std::vector<Vec2>& outline, const Vec2& point, double wedge_angle, double radius,
                    double arc_tolerance);

/// The cracks of a fan, for cut_outline, which drops their parts outside the floe: `wedges` + 1 radial cracks, then the
/// circumferential one through their ends. Throws ContractError unless there is a wedge, the fan spans less than a full
/// turn, and angle, radius and tolerance are positive.
std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan);

/// The cracks of a fan whose circumferential crack is at the distances `radii` [m] on the rays. The rays divide the fan
/// into 2 `wedges` equal angles and include its two sides. The radius and arc_tolerance of the fan are not used. Also
/// throws ContractError unless there are 2 `wedges` + 1 radii, all positive.
std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan, const std::vector<double>& radii);
/// The same cracks with a circumferential one that goes on beyond the sides of the fan where they run into the ice, as
/// in a notch, until it meets an edge. The radial crack on such a side is left out. A crack that ended at the side
/// would leave the outermost wedge with ice on its back, which locks the whole fan. Where an end does not meet an edge
/// within a quarter of a turn, rounded up to whole chords, it stays as it is. Throws ContractError unless `cracks` are
/// those of the fan.
std::vector<std::vector<Vec2>> to_free_edges(const std::vector<Vec2>& outline, const WedgeFan& fan,
                                             std::vector<std::vector<Vec2>> cracks);
/// The direction of ray k of these rays, from x [rad].
double ray_angle(const WedgeFan& fan, int k);

}  // namespace nilas::fracture
