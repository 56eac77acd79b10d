#pragma once
/// Values of <field>, separately for each kind of field.
#include <array>
#include <optional>
#include <string>
#include <variant>

#include "core/base/math.h"
#include "core/choices/defaults.h"
#include "core/choices/ice_choices.h"
#include "core/choices/variant_kind.h"

namespace nilas::scene {

// Distributions of the floe size, the square root of the area [m].
struct FixedSizeScene {
  double mean = defaults::k_floe_mean;

  bool operator==(const FixedSizeScene&) const = default;
};
struct UniformSizeScene {
  double min = defaults::k_floe_min, max = defaults::k_floe_max;

  bool operator==(const UniformSizeScene&) const = default;
};
struct LognormalSizeScene {
  double mean = defaults::k_floe_mean, sd = defaults::k_floe_sd;
  double min = defaults::k_floe_min, max = defaults::k_floe_max;

  bool operator==(const LognormalSizeScene&) const = default;
};
struct PowerLawSizeScene {
  double min = defaults::k_floe_min, max = defaults::k_floe_max;
  double exponent = defaults::k_size_exponent;

  bool operator==(const PowerLawSizeScene&) const = default;
};
struct LibrarySizeScene {
  bool operator==(const LibrarySizeScene&) const = default;
};
/// The distributions, in the order of SizeDistribution.
using SizeScene =
    std::variant<FixedSizeScene, UniformSizeScene, LognormalSizeScene, PowerLawSizeScene, LibrarySizeScene>;

// Outlines of packed floes.
struct PolygonScene {
  int vertices_min = defaults::k_vertices_min, vertices_max = defaults::k_vertices_max;

  bool operator==(const PolygonScene&) const = default;
};
struct RectangleScene {
  double aspect = defaults::k_aspect;

  bool operator==(const RectangleScene&) const = default;
};
struct SquareScene {
  bool operator==(const SquareScene&) const = default;
};
struct ParallelogramScene {
  double aspect = defaults::k_aspect;

  bool operator==(const ParallelogramScene&) const = default;
};
struct DiscScene {
  bool operator==(const DiscScene&) const = default;
};
struct LibraryScene {
  std::string file;  ///< absolute path

  bool operator==(const LibraryScene&) const = default;
};
/// The shapes, in the order of FloeShape.
using FloeShapeScene =
    std::variant<PolygonScene, RectangleScene, SquareScene, ParallelogramScene, DiscScene, LibraryScene>;

// Kinds of field.
using RegionScene = std::array<double, 4>;  ///< x0 y0 x1 y1 [m]

struct PackedFieldScene {
  RegionScene region{0, 0, 1, 1};
  double concentration = defaults::k_concentration;
  double overlap_tolerance = defaults::k_overlap_tolerance;
  double shear_deg = 0;
  SizeScene size = LognormalSizeScene{};
  FloeShapeScene shape;

  bool operator==(const PackedFieldScene&) const = default;
};
struct VoronoiFieldScene {
  RegionScene region{0, 0, 1, 1};
  double concentration = defaults::k_concentration;
  SizeScene size = LognormalSizeScene{};
  std::optional<double> bond;  ///< share of strength left on the seams of bonded floes

  bool operator==(const VoronoiFieldScene&) const = default;
};
struct GridFieldScene {
  RegionScene region{0, 0, 1, 1};
  int rows = 1, columns = 1;
  double gap = 0;  ///< [m]
  bool stagger = false;
  double shear_deg = 0;

  bool operator==(const GridFieldScene&) const = default;
};
struct LevelFieldScene {
  RegionScene region{0, 0, 1, 1};

  bool operator==(const LevelFieldScene&) const = default;
};
struct ChannelFieldScene {
  PackedFieldScene ice;         ///< values for the whole region, but the concentration of the channel
  std::optional<double> width;  ///< [m]; default: half the region's

  bool operator==(const ChannelFieldScene&) const = default;
};
struct FileFieldScene {
  std::string file;  ///< absolute path of a GeoJSON field

  bool operator==(const FileFieldScene&) const = default;
};
/// The kinds of field, in the order of FieldKind.
using FieldForm = std::variant<PackedFieldScene, VoronoiFieldScene, GridFieldScene, LevelFieldScene, ChannelFieldScene,
                               FileFieldScene>;

/// Initial state of ice, and whether it may move and break.
struct IcePlacement {
  bool fixed = false, breakable = false;
  Vec3 velocity = Vec3::Zero();     ///< [m/s]
  double z = 0;                     ///< offset from floating equilibrium [m]
  std::optional<double> thickness;  ///< [m]; default: that of the ice

  bool operator==(const IcePlacement&) const = default;
};

struct FieldScene : IcePlacement {
  FieldForm form;

  FieldKind kind() const { return kind_of<FieldKind>(form); }
  /// The region; null for a field from a file.
  const RegionScene* region() const;
  /// The size distribution; null where no floes are drawn.
  const SizeScene* size() const;

  bool operator==(const FieldScene&) const = default;
};

}  // namespace nilas::scene
