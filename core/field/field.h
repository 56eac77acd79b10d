#pragma once
/// Ice fields: outlines of many floes inside a region.
#include <filesystem>
#include <vector>

#include "core/base/math.h"
#include "core/field/spec/field_spec.h"

namespace nilas {

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

/// One floe filling the region outside the keep-out outlines, convex or not; several where outlines part it. An outline
/// that stands wholly inside the region has its track open, as wide as itself, from the region's edge on the side of
/// `aft`: a floe has no holes. The concentration counts the track as free water. Throws InputError.
FieldResult level_field(const LevelSpec& spec);

/// The cells of voronoi_field frozen together: the sheet of level_field, whose weak lines are the cells' common edges,
/// with `strength` left on them. The spec's concentration has no part in it. Throws InputError.
FieldResult frozen_field(const PackedSpec& spec, const Vec2& aft, double strength);

/// The broken floes as pack_field makes them within the channel, then the sheets on both sides, fixed. Throws
/// InputError.
FieldResult channel_field(const ChannelSpec& spec);

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

}  // namespace nilas
