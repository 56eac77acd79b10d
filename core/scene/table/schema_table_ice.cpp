#include "core/scene/spec/ice_presets.h"
#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static ElementSpec ice() {
  const auto of_preset = [](const char* name, const char* unit, const Range& range, const char* doc) {
    return AttributeSpec{.name = name, .unit = unit, .range = range, .default_note = "that of the preset", .doc = doc};
  };
  return {
      .name = "ice",
      .parent = "scene",
      .doc = "It holds the ice: fields of floes and single floes.",
      .attributes = {
          {.name = "preset",
           .type = ValueType::choice,
           .choices = ice_preset_names(),
           .default_note = "model below 0.2 m of thickness, else full-scale sea ice. Without a thickness the hull's "
                           "length decides (30 m), or the field's (100 m).",
           .doc = "It selects a set of published values for density, modulus, thickness, strengths, floe sizes and "
                  "smallest piece. They hold where the scene gives none (docs/reference/scales.md)."},
          of_preset("density", "kg/m^3", above(0), "It is the density."),
          of_preset("youngs_modulus", "Pa", above(0), "It is Young's modulus, of bending and of elastic contacts."),
          of_preset("poisson", "", within(0, 0.5), "It is Poisson's ratio, of bending and of elastic contacts."),
          of_preset("thickness", "m", above(0), "It is the thickness of floes that give none.")}};
}

static AttributeSpec field_region() {
  return {.name = "region",
          .min_count = 4,
          .max_count = 4,
          .unit = "m",
          .default_note = "none: every kind but file needs it",
          .applies = when("kind", FieldKind::packed, FieldKind::voronoi, FieldKind::grid, FieldKind::level,
                          FieldKind::channel),
          .doc = "These are x0 y0 x1 y1 of the region."};
}

static std::vector<AttributeSpec> packing() {
  const PackedFieldScene values;
  return {{.name = "concentration",
           .range = {.min = 0, .max = 1, .min_inclusive = false},
           .default_value = written(values.concentration),
           .applies = when("kind", FieldKind::packed, FieldKind::voronoi, FieldKind::channel),
           .doc = "It is the area of ice over the free area of the region; in a channel, between its sheets."},
          {.name = "overlap_tolerance",
           .range = within(0, 1),
           .default_value = written(values.overlap_tolerance),
           .applies = when("kind", FieldKind::packed, FieldKind::channel),
           .doc = "It is the largest overlap that packing may leave, as a fraction of the mean floe size. With 0 there "
                  "are gaps only."},
          {.name = "channel_width",
           .unit = "m",
           .range = above(0),
           .default_note = "half the width of the region",
           .applies = when("kind", FieldKind::channel),
           .doc = "It is the width of the broken ice, which lies along X about the region's middle line."}};
}

static std::vector<AttributeSpec> grid() {
  const GridFieldScene values;
  const Condition of_grid = when("kind", FieldKind::grid);
  /// More pieces than any machine holds; the product of the two still fits an int.
  const Range pieces = within(1, 10000);
  return {{.name = "rows",
           .type = ValueType::integer,
           .range = pieces,
           .default_value = written(values.rows),
           .applies = of_grid,
           .doc = "It is the number of pieces along Y."},
          {.name = "columns",
           .type = ValueType::integer,
           .range = pieces,
           .default_value = written(values.columns),
           .applies = of_grid,
           .doc = "It is the number of pieces along X."},
          {.name = "gap",
           .unit = "m",
           .range = at_least(0),
           .default_value = written(values.gap),
           .applies = of_grid,
           .doc = "It is the gap between neighbouring pieces."},
          {.name = "stagger",
           .type = ValueType::boolean,
           .default_value = written(values.stagger),
           .applies = of_grid,
           .doc = "It shifts every second row by half a piece."},
          {.name = "shear_deg",
           .unit = "deg",
           .range = inside(-90, 90),
           .default_value = written(values.shear_deg),
           .applies = when("kind", FieldKind::packed, FieldKind::channel, FieldKind::grid),
           .doc = "It is the angle by which sheared pieces deviate from a rectangle."}};
}

/// Attributes that <field> and <floe> share.
static std::vector<AttributeSpec> placement() {
  const IcePlacement values;
  return {{.name = "fixed",
           .type = ValueType::boolean,
           .default_value = written(values.fixed),
           .doc = "Fixed ice never moves."},
          three("velocity", "m/s", "It is the velocity at the start, in the ground frame."),
          {.name = "z",
           .unit = "m",
           .default_value = written(values.z),
           .doc = "It is the offset from floating equilibrium."},
          {.name = "thickness",
           .unit = "m",
           .range = above(0),
           .default_note = "that of <ice>",
           .doc = "It is the thickness."},
          {.name = "breakable",
           .type = ValueType::boolean,
           .default_value = written(values.breakable),
           .doc = "It says whether the ice may break. It has no effect without <fracture>."}};
}

static ElementSpec field() {
  ElementSpec element{
      .name = "field",
      .parent = "ice",
      .count = Count::many,
      .doc =
          "It fills a region with floes. They keep clear of the hull at the start, except those of kind file. Kind "
          "grid leaves out and counts the pieces that meet the hull's outline plus a margin; the other kinds are "
          "laid out around it.",
      .attributes = {choice("kind", FieldScene{}.kind(), "It sets how the floes are made."),
                     field_region(),
                     {.name = "file",
                      .type = ValueType::path,
                      .applies = when("kind", FieldKind::file),
                      .scaled_file = true,
                      .doc = "It is a GeoJSON file of floes, as `nilas field` writes it."}}};
  for (const auto& group : {packing(), grid(), placement()})
    element.attributes.insert(element.attributes.end(), group.begin(), group.end());
  return element;
}

static ElementSpec size() {
  using enum SizeDistribution;
  const auto length = [](const char* name, Condition applies, const char* doc) {
    return AttributeSpec{.name = name,
                         .unit = "m",
                         .range = above(0),
                         .default_note = "that of the ice's preset",
                         .applies = std::move(applies),
                         .doc = doc};
  };
  return {.name = "size",
          .parent = "field",
          .always = true,
          .applies = when("kind", FieldKind::packed, FieldKind::voronoi, FieldKind::channel),
          .doc = "It sets the distribution of the floe size, which is the square root of the area.",
          .attributes = {
              choice("distribution", kind_of<SizeDistribution>(PackedFieldScene{}.size), "It sets the distribution."),
              length("mean", when("distribution", fixed, lognormal), "It is the mean size."),
              length("sd", when("distribution", lognormal), "It is the standard deviation."),
              length("min", when("distribution", uniform, lognormal, power_law), "It is the smallest size."),
              length("max", when("distribution", uniform, lognormal, power_law), "It is the largest size."),
              {.name = "exponent",
               .range = above(0),
               .default_value = written(PowerLawSizeScene{}.exponent),
               .applies = when("distribution", power_law),
               .doc = "It is the exponent a in the number density n(D) ~ D^-(1 + a) of the size D."}}};
}

static ElementSpec shape() {
  return {
      .name = "shape",
      .parent = "field",
      .always = true,
      .applies = when("kind", FieldKind::packed, FieldKind::channel),
      .doc = "It sets the outline of the floes.",
      .attributes = {
          choice("kind", kind_of<FloeShape>(PackedFieldScene{}.shape), "It sets the kind of outline."),
          {.name = "vertices",
           .type = ValueType::integer,
           .min_count = 2,
           .max_count = 2,
           .range = within(3, 64),
           .default_value = written(PolygonScene{}.vertices_min) + " " + written(PolygonScene{}.vertices_max),
           .applies = when("kind", FloeShape::polygon),
           .doc = "These are the smallest and the largest number of corners."},
          {.name = "aspect",
           .range = at_least(1),
           .default_value = written(RectangleScene{}.aspect),
           .applies = when("kind", FloeShape::rectangle, FloeShape::parallelogram),
           .doc = "It is the long side over the short side."},
          {.name = "library",
           .type = ValueType::path,
           .scaled_file = true,
           .doc =
               "Outlines are drawn from this file, whatever the kind: JSON lists of points, or GeoJSON. Concave ones "
               "are packed as their convex hulls."}}};
}

static ElementSpec floe() {
  ElementSpec element{
      .name = "floe",
      .parent = "ice",
      .count = Count::many,
      .doc = "It is a single floe.",
      .attributes = {{.name = "name",
                      .type = ValueType::name,
                      .default_note = "a running number",
                      .doc = "The outputs use this name."},
                     {.name = "outline",
                      .min_count = 6,
                      .max_count = k_any_count,
                      .unit = "m",
                      .required = true,
                      .doc = "These are the corners x y x y ... in the ground frame, at least three."}}};
  for (const auto& attribute : placement()) element.attributes.push_back(attribute);
  return element;
}

/// The strength attribute of weak lines and bonds.
static AttributeSpec strength_left() {
  return {.name = "strength",
          .range = {.min = 0, .max = 1, .min_inclusive = false},
          .required = true,
          .doc = "It is the share of flexural strength and fracture toughness that the ice has there."};
}

static ElementSpec bond() {
  return {.name = "bond",
          .parent = "field",
          .applies = when("kind", FieldKind::voronoi),
          .doc =
              "It freezes the floes together into one sheet, whose seams are weak lines. It needs a concentration of "
              "1. It has no effect without <cracks path=\"curved\">.",
          .attributes = {strength_left()}};
}

static ElementSpec weak_line() {
  return {.name = "weak_line",
          .parent = "ice",
          .count = Count::many,
          .doc =
              "Breakable floes are weaker along this line at the start, such as a refrozen crack or the flank of a "
              "ridge. It has no effect without <cracks path=\"curved\">.",
          .attributes = {{.name = "points",
                          .min_count = 4,
                          .max_count = k_any_count,
                          .unit = "m",
                          .required = true,
                          .doc = "These are the points x y x y ... in the ground frame, at least two."},
                         strength_left()}};
}

std::vector<ElementSpec> ice_elements() {
  return {ice(), field(), size(), shape(), bond(), floe(), weak_line(), vary_element()};
}

}  // namespace nilas::scene::schema_table
