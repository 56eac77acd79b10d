#pragma once
/// Generators of ice fields: outlines of many floes inside a region.
#include <filesystem>
#include <vector>

#include "core/base/math.h"
#include "core/field/spec/field_spec.h"

namespace nilas::field {

/// A field of random floes by overlap relaxation [van den Berg, IceFieldCreator]: they start with overlaps and are
/// pushed apart. Floes that block each other exchange places and are shaken. Floes keep their areas. Rectangles,
/// squares, parallelograms and discs keep their shapes. Beyond a concentration of about 86 %, polygons are fitted as
/// neighbours in real ice share edges: each is cut along the line between it and a neighbour and scaled back to its
/// area. The result has gaps between all floes, the region's edge and the keep-out outlines; where that fails, overlaps
/// of at most overlap_tolerance. At the default sizes it reaches about 95 % with polygons and squares, 92 % with
/// rectangles, 88 % with parallelograms, 85 % with discs. The same spec gives the same field, bit for bit. Throws
/// InputError for a wrong parameter, and for a concentration that cannot be reached, naming the one that can.
FieldResult pack_field(const PackedSpec& spec);

/// Cells of a power diagram whose areas follow the size distribution. Each cell is shrunk about its centroid to the
/// requested concentration, which may be 1. The spec's shape and overlap tolerance are not used. Drawn areas are scaled
/// by one factor so that the concentration is met exactly. Floes are convex, also next to keep-out outlines, where
/// cells lose the wedges beyond an outline's corners. Throws InputError for a wrong parameter, and where these wedges
/// are too large, naming the concentration that can be reached.
FieldResult voronoi_field(const PackedSpec& spec);

/// One floe that fills the region outside the keep-out outlines, convex or not; several where outlines divide it. Floes
/// have no holes: an outline wholly inside the region gets an open track of its own width to the region's edge in the
/// direction of `aft`. The concentration counts the track as free water. Throws InputError.
FieldResult level_field(const LevelSpec& spec);

/// The cells of voronoi_field bonded together: the sheet of level_field, whose weak lines are the cells' common edges,
/// with the share `strength` of strength left. The spec's concentration is not used. Throws InputError.
FieldResult frozen_field(const PackedSpec& spec, const Vec2& aft, double strength);

/// Broken floes by pack_field within the channel, then the fixed sheets on both sides. Throws InputError.
FieldResult channel_field(const ChannelSpec& spec);

/// Rectangles that fill the region, or parallelograms within it (shear leaves a notch at its ends). Rows are laid out
/// from the region's middle line, so the field is mirror-symmetric about it, bit for bit when the line is y = 0.
/// Positive shear leans the rows' outer ends to larger X. With an even number of rows, the pieces 2k and 2k + 1 are a
/// mirror pair. With an odd number, the middle row is not sheared. Rows shifted by stagger have half pieces at their
/// ends. Throws InputError.
FieldResult grid_field(const GridSpec& spec);

/// Most corners of an outline in a file: each of its sides is held against all others.
constexpr std::size_t k_most_corners = 10000;

/// Reads and writes a field as a GeoJSON FeatureCollection, in metres. It has a LineString with the property strength
/// per weak line, and one Polygon without holes per floe, its first point repeated at the end. Properties, where they
/// differ from the scene's and written to the last bit: thickness_m, density_kg_m3, flexural_strength_Pa,
/// compressive_strength_Pa, fracture_toughness_Pa_sqrt_m; `fixed` where true. Clockwise rings are reversed.
/// worst_overlap is measured on reading. Throws FileError, and InputError naming file and feature (counted from 1).
FieldResult read_field(const std::filesystem::path& file);
/// Multiplies the lengths and strengths of a field by `scale`, its toughness by the power 1.5, as Froude's and Cauchy's
/// laws have it.
void scale_field(FieldResult& field, double scale);
void write_field(const FieldResult& field, const std::filesystem::path& file);

}  // namespace nilas::field
