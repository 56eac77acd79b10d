#pragma once
/// Ice fields: outlines of many floes inside a region.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/bodies/ice_properties.h"

namespace nilas {

/// One floe of a field, in the still-water plane.
struct FieldFloe {
  std::vector<Vec2> outline;                               ///< counter-clockwise, in G [m]
  double thickness = 0;                                    ///< [m]; 0: the scene's
  double density = 0;                                      ///< [kg/m^3]; 0: the scene's
  double flexural_strength = 0, compressive_strength = 0;  ///< [Pa]; 0: the scene's
  double fracture_toughness = 0;                           ///< [Pa sqrt(m)]; 0: the scene's
  bool fixed = false;                                      ///< never moves, whatever the field says
};

enum class FloeShape { polygon, rectangle, square, parallelogram, disc, library };
enum class SizeDistribution { fixed, uniform, lognormal, power_law, as_library };

struct PackedSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();  ///< region [m]
  double concentration = 0.8;                    ///< area of ice / free area of region
  double overlap_tolerance = 1e-3;               ///< largest overlap depth left, as a fraction of the mean floe size
  SizeDistribution distribution = SizeDistribution::lognormal;
  double mean = 0.8, sd = 0.3, min = 0.3, max = 1.6;  ///< of sqrt(area) [m]
  double exponent = 1.5;                              ///< power law n(D) ~ D^-(1 + exponent)
  FloeShape shape = FloeShape::polygon;
  int vertices_min = 5, vertices_max = 9;
  double aspect = 1.5;  ///< long side / short side of rectangle and parallelogram
  double shear = 0;     ///< parallelogram, angle from a rectangle [rad]
  std::vector<std::vector<Vec2>>
      library;  ///< simple counter-clockwise outlines to draw from, scaled to the drawn sizes
  std::vector<std::vector<Vec2>>
      keep_out;  ///< convex counter-clockwise outlines that ice keeps clear of; their area is no part of the region
  double keep_out_margin = 0;  ///< [m]
  std::uint64_t seed = 1;
};
struct FieldResult {
  std::vector<FieldFloe> floes;
  double concentration = 0;          ///< reached, ice area / free region area
  double worst_overlap = 0;          ///< depth [m]
  int passes = 0;                    ///< relaxation passes used
  int fitted = 0;                    ///< polygon floes whose outline was fitted to its neighbours, see pack_field
  int left_out = 0;                  ///< floes dropped because they met a keep-out outline
  std::vector<WeakLine> weak_lines;  ///< along which the floes are weaker, in G
};
/// Overlap relaxation [van den Berg, IceFieldCreator]: random floes start with overlaps and are pushed apart; floes
/// that block each other change places and are shaken. Floes keep their areas. Rectangles, squares, parallelograms and
/// discs keep their shapes; polygons beyond about 86 % are fitted: cut along the line between them and a neighbour and
/// scaled back to their areas, as neighbours in real ice share edges. Ends with gaps between all floes, the region's
/// edge and the keep-out outlines; where that fails, with overlaps of at most overlap_tolerance. Reaches about 95 %
/// with polygons and squares, 92 % rectangles, 88 % parallelograms, 85 % discs, at the default sizes. Same spec, same
/// field, bit for bit. Throws InputError for a wrong parameter, and when the concentration cannot be reached, saying
/// what was.
FieldResult pack_field(const PackedSpec& spec);

/// Cells of a power diagram whose areas follow the size distribution, each made smaller about its centroid until the
/// concentration is the one asked, 1 included; the shape and the overlap tolerance of the spec have no part in it.
/// Drawn areas are scaled by one factor so that the concentration is met exactly. Convex floes, also beside keep-out
/// outlines, where cells lose the wedges beyond an outline's corners. Throws InputError for a wrong parameter, and
/// where those wedges are missed, saying what can be reached.
FieldResult voronoi_field(const PackedSpec& spec);

/// An intact sheet.
struct LevelSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();  ///< region [m]
  std::vector<std::vector<Vec2>> keep_out;       ///< convex, counter-clockwise
  double keep_out_margin = 0;                    ///< [m]
  Vec2 aft = -Vec2::UnitX();                     ///< where a hull came from
};
/// One floe filling the region outside the keep-out outlines, convex or not; several where outlines part it. An outline
/// that stands wholly inside the region has its track open, as wide as itself, from the region's edge on the side of
/// `aft`: a floe has no holes. The concentration counts the track as free water. Throws InputError.
FieldResult level_field(const LevelSpec& spec);

/// The cells of voronoi_field frozen together: the sheet of level_field, whose weak lines are the cells' common edges,
/// with `strength` left on them. The spec's concentration has no part in it. Throws InputError.
FieldResult frozen_field(const PackedSpec& spec, const Vec2& aft, double strength);

/// A channel of broken ice along X between two sheets.
struct ChannelSpec {
  PackedSpec ice;             ///< of the whole region; its concentration is that of the channel
  double width = 1;           ///< of the channel, about the region's middle line [m]
  Vec2 aft = -Vec2::UnitX();  ///< see LevelSpec
};
/// The broken floes as pack_field makes them within the channel, then the sheets on both sides, fixed. Throws
/// InputError.
FieldResult channel_field(const ChannelSpec& spec);

struct GridSpec {
  Vec2 low = Vec2::Zero(), high = Vec2::Ones();
  int rows = 1;      ///< along Y
  int columns = 1;   ///< along X
  double gap = 0;    ///< between neighbours [m]
  double shear = 0;  ///< lines of constant X turned by this angle from Y, mirrored about the region's middle line [rad]
  bool stagger = false;  ///< every second row shifted by half a piece
  std::vector<std::vector<Vec2>> keep_out;
  double keep_out_margin = 0;
};
/// Rectangles filling the region, or parallelograms within it (shear leaves a notch at its ends). Rows are laid out
/// from the region's middle line, so the field is mirror-symmetric about it, bit for bit when the line is y = 0.
/// Positive shear leans the rows' outer ends to larger X. Above and below the line pieces come in mirror pairs, 2k and
/// 2k + 1 when rows is even; of an odd number the middle row is not sheared. Rows shifted by stagger have half pieces
/// at their ends. Throws InputError.
FieldResult grid_field(const GridSpec& spec);

/// GeoJSON FeatureCollection, in metres: a LineString with the property strength per weak line, and one Polygon without
/// holes per floe, its first point repeated at the end;
/// properties thickness_m, density_kg_m3, flexural_strength_Pa, compressive_strength_Pa, fracture_toughness_Pa_sqrt_m
/// where not the scene's, written to the last bit; `fixed` where true. Clockwise rings are turned. worst_overlap is
/// measured on reading. Throws FileError, InputError naming file and feature (counted from 1).
FieldResult read_field(const std::filesystem::path& file);
void write_field(const FieldResult& field, const std::filesystem::path& file);

/// Outlines to draw floes from, counter-clockwise: JSON list of outlines, or an object with such a list "bodies" (as
/// IceFieldCreator's), each a list of numbers x y x y ... or of pairs [x, y] in metres; or a GeoJSON field. Throws
/// FileError, InputError naming file and outline (counted from 1).
std::vector<std::vector<Vec2>> read_outlines(const std::filesystem::path& file);

}  // namespace nilas
