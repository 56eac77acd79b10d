#pragma once
/// Where cracks run: straight splitting cracks, and the wedges of a bending failure.
#include <optional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "fracture/cut/cut_outline.h"

namespace nilas {

/// Straight crack from edge to edge of an outline.
struct Chord {
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();  ///< [m]
  double length() const { return (end - start).norm(); }
};

/// A point of an outline's edge.
struct EdgePlace {
  std::size_t edge = 0;         ///< from vertex `edge` on, that vertex included
  Vec2 point = Vec2::Zero();    ///< [m]
  Vec2 inward = Vec2::UnitX();  ///< into the polygon, unit: the edge's normal, at a vertex the middle of its angle
  double inside = 0;            ///< angle of the polygon there, pi along an edge [rad]
};

/// Nearest place on the edge of a counter-clockwise outline. Throws ContractError below three vertices.
EdgePlace nearest_edge_place(const std::vector<Vec2>& outline, const Vec2& point);

/// Parts inside the outline of the line from `point` along `angle` [rad, from x], in order: all that lie ahead of the
/// point, and the one it lies in with its part behind, so that a point some way inside the edge serves as well. A line
/// along an edge may give the edge itself, and one that touches a vertex within snap_resolution ends there. `outline`
/// simple.
std::vector<Chord> chords(const std::vector<Vec2>& outline, const Vec2& point, double angle);

/// The shortest of chords(): the splitting crack of Metrikin (2014), 5.2, steps 1 and 2. None when the line misses.
std::optional<Chord> shortest_chord(const std::vector<Vec2>& outline, const Vec2& point, double angle);

enum class SplitVerdict {
  splits,
  no_chord,       ///< the line does not pass through the ice
  below_bending,  ///< the chord is not longer than the bending radius
  above_reach,    ///< the chord is not shorter than `multiplier` bending radii: bending wins
  not_cut,        ///< the chord separates nothing, or a piece is not simple
  too_small,      ///< a piece is below min_area
  too_narrow      ///< a piece is longer than max_aspect
};
std::string name_of(SplitVerdict verdict);

struct SplitRule {
  double bending_radius = 0;  ///< R_bending: of the circumferential crack [m]
  double multiplier = 2.5;    ///< S_k
  double min_area = 2e-4;     ///< [m^2]
  double max_aspect = 8;      ///< R_size
};

struct Split {
  SplitVerdict verdict = SplitVerdict::no_chord;
  Chord chord;  ///< the candidate, whatever the verdict but no_chord
};

/// Geometric splitting rule of Metrikin (2014), 5.2: the shortest chord splits the floe when R_bending < length <
/// S_k R_bending and both pieces are simple, large and broad enough. `outline` simple, counter-clockwise.
Split split_along(const std::vector<Vec2>& outline, const Vec2& breaking_point, double crack_angle,
                  const SplitRule& rule);

/// Whether a crack cuts an outline into pieces that the rule takes, however long it is.
SplitVerdict verdict_on_cut(const std::vector<Vec2>& outline, const std::vector<Vec2>& crack, const SplitRule& rule);

/// Wedges that break off in bending around a loaded point of the edge.
struct WedgeFan {
  Vec2 apex = Vec2::Zero();  ///< on the edge [m]
  double direction = 0;      ///< of the fan's middle, into the ice, from x [rad]
  int wedges = 0;            ///< n_w
  double wedge_angle = 0;    ///< alpha_wedge [rad]
  double radius = 0;         ///< R_bending [m]
  /// Largest distance between the circumferential crack and its circle; infinite: one chord per wedge [m]
  double arc_tolerance = 0;
};

/// Fan at the edge point nearest to `point` that spans the ice from edge to edge, half a turn or a corner's angle, in
/// as many equal wedges as come nearest to `wedge_angle`. A fan that spans less touches the edge at its apex only and
/// leaves a floe pinched there, which cut_outline refuses. `outline` simple, counter-clockwise. Throws ContractError
/// when the wedge angle is not positive.
WedgeFan fan_across(const std::vector<Vec2>& outline, const Vec2& point, double wedge_angle, double radius,
                    double arc_tolerance);

/// wedges + 1 radial cracks, then the circumferential one through their ends, for cut_outline, which drops what lies
/// outside the floe. Throws ContractError unless there is a wedge, angle, radius and tolerance are positive, and the
/// fan spans less than a full turn.
std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan);

/// The same with a circumferential crack at `radii` [m] of the rays that part the fan into 2 wedges equal angles, its
/// two sides included; the radius and arc_tolerance of the fan have no part in it. Throws ContractError also unless
/// there are 2 wedges + 1 radii, all positive.
std::vector<std::vector<Vec2>> wedge_cracks(const WedgeFan& fan, const std::vector<double>& radii);
/// Direction of ray k of those, from x [rad].
double ray_angle(const WedgeFan& fan, int k);

}  // namespace nilas
