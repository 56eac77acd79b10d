#include <algorithm>

#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static SizeScene build_size(const SceneElement& element) {
  const auto assign_ends = [&](auto size) {
    assign(size.min, element, "min");
    assign(size.max, element, "max");
    return size;
  };
  switch (choice_of<SizeDistribution>(element, "distribution").value_or(SizeDistribution::lognormal)) {
    case SizeDistribution::fixed: {
      FixedSizeScene size;
      assign(size.mean, element, "mean");
      return size;
    }
    case SizeDistribution::uniform:
      return assign_ends(UniformSizeScene{});
    case SizeDistribution::lognormal: {
      auto size = assign_ends(LognormalSizeScene{});
      assign(size.mean, element, "mean");
      assign(size.sd, element, "sd");
      return size;
    }
    case SizeDistribution::power_law: {
      auto size = assign_ends(PowerLawSizeScene{});
      assign(size.exponent, element, "exponent");
      return size;
    }
    case SizeDistribution::as_library:
      return LibrarySizeScene{};
  }
  return {};
}

static PolygonScene build_polygon(const SceneElement& element) {
  PolygonScene polygon;
  if (const auto vertices = numbers_of(element, "vertices")) {
    polygon.vertices_min = static_cast<int>(vertices->at(0));
    polygon.vertices_max = static_cast<int>(vertices->at(1));
  }
  return polygon;
}

/// The shape of floes; a library replaces the kind.
static FloeShapeScene build_floe_shape(const SceneElement& element) {
  if (const auto library = text_of(element, "library")) return LibraryScene{*library};
  const auto assign_aspect = [&](auto shape) {
    assign(shape.aspect, element, "aspect");
    return shape;
  };
  switch (choice_of<FloeShape>(element, "kind").value_or(FloeShape::polygon)) {
    case FloeShape::polygon:
      return build_polygon(element);
    case FloeShape::rectangle:
      return assign_aspect(RectangleScene{});
    case FloeShape::square:
      return SquareScene{};
    case FloeShape::parallelogram:
      return assign_aspect(ParallelogramScene{});
    case FloeShape::disc:
      return DiscScene{};
    case FloeShape::library:
      break;  // has no name
  }
  return {};
}

static RegionScene region_of(const SceneElement& element) {
  RegionScene region{};
  if (const auto given = numbers_of(element, "region")) std::copy_n(given->begin(), region.size(), region.begin());
  return region;
}

static PackedFieldScene build_packed(const SceneElement& element) {
  PackedFieldScene field;
  field.region = region_of(element);
  assign(field.concentration, element, "concentration");
  assign(field.overlap_tolerance, element, "overlap_tolerance");
  assign(field.shear_deg, element, "shear_deg");
  if (const auto* size = child_of(element, "size")) field.size = build_size(*size);
  if (const auto* shape = child_of(element, "shape")) field.shape = build_floe_shape(*shape);
  return field;
}

static VoronoiFieldScene build_voronoi(const SceneElement& element) {
  VoronoiFieldScene field;
  field.region = region_of(element);
  assign(field.concentration, element, "concentration");
  if (const auto* size = child_of(element, "size")) field.size = build_size(*size);
  if (const auto* bond = child_of(element, "bond")) field.bond = number_of(*bond, "strength");
  return field;
}

static GridFieldScene build_grid(const SceneElement& element) {
  GridFieldScene field;
  field.region = region_of(element);
  assign(field.rows, element, "rows");
  assign(field.columns, element, "columns");
  assign(field.gap, element, "gap");
  assign(field.stagger, element, "stagger");
  assign(field.shear_deg, element, "shear_deg");
  return field;
}

static ChannelFieldScene build_channel(const SceneElement& element) {
  ChannelFieldScene field{build_packed(element), {}};
  assign(field.width, element, "channel_width");
  return field;
}

static FieldForm build_form(const SceneElement& element) {
  switch (choice_of<FieldKind>(element, "kind").value_or(FieldScene{}.kind())) {
    case FieldKind::packed:
      return build_packed(element);
    case FieldKind::voronoi:
      return build_voronoi(element);
    case FieldKind::grid:
      return build_grid(element);
    case FieldKind::level:
      return LevelFieldScene{region_of(element)};
    case FieldKind::channel:
      return build_channel(element);
    case FieldKind::file:
      return FileFieldScene{text_of(element, "file").value_or("")};
  }
  return {};
}

void assign_placement(IcePlacement& placement, const SceneElement& element) {
  assign(placement.fixed, element, "fixed");
  assign(placement.velocity, element, "velocity");
  assign(placement.z, element, "z");
  assign(placement.thickness, element, "thickness");
  assign(placement.breakable, element, "breakable");
}

FieldScene build_field_scene(const SceneElement& element) {
  FieldScene field;
  field.form = build_form(element);
  assign_placement(field, element);
  return field;
}

}  // namespace nilas::scene
