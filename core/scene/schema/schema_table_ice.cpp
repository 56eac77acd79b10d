#include "core/scene/schema/ice_presets.h"
#include "core/scene/schema/schema_table.h"

namespace nilas::schema_table {

/// What <field> and <floe> share.
static std::vector<AttributeSpec> placement() {
  return {{.name = "fixed", .type = ValueType::boolean, .default_value = "false", .doc = "Fixed sheets never move."},
          {.name = "velocity",
           .min_count = 3,
           .max_count = 3,
           .unit = "m/s",
           .default_value = "0 0 0",
           .doc = "At the start, in the ground frame."},
          {.name = "z", .unit = "m", .default_value = "0", .doc = "Offset from floating equilibrium."},
          {.name = "thickness", .unit = "m", .range = above(0), .default_note = "that of <ice>", .doc = "Thickness."},
          {.name = "breakable",
           .type = ValueType::boolean,
           .default_value = "false",
           .doc = "Whether it may break. No effect without <fracture>: then no ice breaks."}};
}

static ElementSpec ice() {
  return {.name = "ice",
          .parent = "scene",
          .doc = "Ice: fields of floes and single floes, as its children.",
          .attributes = {{.name = "preset",
                          .type = ValueType::choice,
                          .choices = ice_preset_names(),
                          .default_note =
                              "model below 0.2 m of thickness, else full-scale sea ice; of ice that names no thickness "
                              "by the hull's length (30 m) or the field's (100 m)",
                          .doc = "Which sourced values (docs/reference/scales.md) stand in for density, modulus, "
                                 "thickness, strengths, floe "
                                 "sizes and smallest piece that the scene does not give."},
                         {.name = "density",
                          .unit = "kg/m^3",
                          .range = above(0),
                          .default_note = "that of the preset",
                          .doc = "Density."},
                         {.name = "youngs_modulus",
                          .unit = "Pa",
                          .range = above(0),
                          .default_note = "that of the preset",
                          .doc = "Young's modulus. No effect without <fracture>."},
                         {.name = "poisson",
                          .range = within(0, 0.5),
                          .default_note = "that of the preset",
                          .doc = "Poisson's ratio. No effect without <fracture>."},
                         {.name = "thickness",
                          .unit = "m",
                          .range = above(0),
                          .default_note = "that of the preset",
                          .doc = "Thickness of floes that name none."}}};
}

static std::vector<AttributeSpec> packing() {
  return {{.name = "concentration",
           .range = {.min = 0, .max = 1, .min_inclusive = false},
           .default_value = "0.8",
           .applies = {"kind", {"packed", "voronoi", "channel"}},
           .doc = "Area of ice over free area of the region; of a channel, between its sheets."},
          {.name = "overlap_tolerance",
           .range = within(0, 1),
           .default_value = "1e-3",
           .applies = {"kind", {"packed", "channel"}},
           .doc = "Largest overlap left by the packing, as a fraction of the mean floe size; 0: gaps only."},
          {.name = "channel_width",
           .unit = "m",
           .range = above(0),
           .default_note = "half the width of the region",
           .applies = {"kind", {"channel"}},
           .doc = "Of the broken ice along X, about the region's middle line, between two fixed sheets."}};
}

static std::vector<AttributeSpec> grid() {
  const Condition when{"kind", {"grid"}};
  /// More pieces than any machine holds; keeps products of the two within an int.
  const Range pieces = within(1, 10000);
  return {{.name = "rows",
           .type = ValueType::integer,
           .range = pieces,
           .default_value = "1",
           .applies = when,
           .doc = "Pieces along Y."},
          {.name = "columns",
           .type = ValueType::integer,
           .range = pieces,
           .default_value = "1",
           .applies = when,
           .doc = "Pieces along X."},
          {.name = "gap",
           .unit = "m",
           .range = at_least(0),
           .default_value = "0",
           .applies = when,
           .doc = "Between neighbouring pieces."},
          {.name = "stagger",
           .type = ValueType::boolean,
           .default_value = "false",
           .applies = when,
           .doc = "Shift every second row by half a piece."},
          {.name = "shear_deg",
           .unit = "deg",
           .range = inside(-90, 90),
           .default_value = "0",
           .applies = {"kind", {"packed", "channel", "grid"}},
           .doc = "Angle of sheared pieces from a rectangle."}};
}

static ElementSpec field() {
  ElementSpec element{
      .name = "field",
      .parent = "ice",
      .count = Count::many,
      .doc = "Many floes in a region. Ice inside the hull's outline plus a margin is left out and counted.",
      .attributes = {{.name = "kind",
                      .type = ValueType::choice,
                      .choices = {"packed", "voronoi", "grid", "level", "channel", "file"},
                      .default_value = "packed",
                      .doc = "packed (random floes pushed apart), voronoi (cells that share edges, made smaller), grid "
                             "(pre-sawn pieces), level (an intact sheet), channel (packed floes between two fixed "
                             "sheets), file."},
                     {.name = "region",
                      .min_count = 4,
                      .max_count = 4,
                      .unit = "m",
                      .default_note = "none: every kind but file needs it",
                      .applies = {"kind", {"packed", "voronoi", "grid", "level", "channel"}},
                      .doc = "x0 y0 x1 y1."},
                     {.name = "file",
                      .type = ValueType::path,
                      .applies = {"kind", {"file"}},
                      .doc = "GeoJSON file of floes, as `nilas field` writes it."}}};
  for (const auto& group : {packing(), grid(), placement()})
    element.attributes.insert(element.attributes.end(), group.begin(), group.end());
  return element;
}

static ElementSpec size() {
  const auto length = [](const std::string& name, std::vector<std::string> when, const std::string& doc) {
    return AttributeSpec{.name = name,
                         .unit = "m",
                         .range = above(0),
                         .default_note = "that of the ice's preset",
                         .applies = {"distribution", std::move(when)},
                         .doc = doc};
  };
  return {.name = "size",
          .parent = "field",
          .always = true,
          .applies = {"kind", {"packed", "voronoi", "channel"}},
          .doc = "Distribution of the floes' size, the square root of the area.",
          .attributes = {{.name = "distribution",
                          .type = ValueType::choice,
                          .choices = {"fixed", "uniform", "lognormal", "power-law", "as-library"},
                          .default_value = "lognormal",
                          .doc = "fixed takes the mean; uniform lies between min and max; lognormal and power-law are "
                                 "cut at min and max; as-library leaves the outlines of <shape library> as they are."},
                         length("mean", {"fixed", "lognormal"}, "Mean size."),
                         length("sd", {"lognormal"}, "Standard deviation."),
                         length("min", {"uniform", "lognormal", "power-law"}, "Smallest size."),
                         length("max", {"uniform", "lognormal", "power-law"}, "Largest size."),
                         {.name = "exponent",
                          .range = above(0),
                          .default_value = "1.5",
                          .applies = {"distribution", {"power-law"}},
                          .doc = "a in n(D) ~ D^-(1 + a)."}}};
}

static ElementSpec shape() {
  return {
      .name = "shape",
      .parent = "field",
      .always = true,
      .applies = {"kind", {"packed", "channel"}},
      .doc = "Outline of the floes.",
      .attributes = {
          {.name = "kind",
           .type = ValueType::choice,
           .choices = {"polygon", "rectangle", "square", "parallelogram", "disc"},
           .default_value = "polygon",
           .doc = "polygon is a random convex one."},
          {.name = "vertices",
           .type = ValueType::integer,
           .min_count = 2,
           .max_count = 2,
           .range = within(3, 64),
           .default_value = "5 9",
           .applies = {"kind", {"polygon"}},
           .doc = "Fewest and most corners."},
          {.name = "aspect",
           .range = at_least(1),
           .default_value = "1.5",
           .applies = {"kind", {"rectangle", "parallelogram"}},
           .doc = "Long side over short side."},
          {.name = "library",
           .type = ValueType::path,
           .doc = "File of outlines to draw from, whatever the kind: JSON lists of points, or GeoJSON. Concave ones "
                  "are packed as their convex hulls."}}};
}

static ElementSpec floe() {
  ElementSpec element{
      .name = "floe",
      .parent = "ice",
      .count = Count::many,
      .doc = "A single floe.",
      .attributes = {
          {.name = "name", .type = ValueType::name, .default_note = "a running number", .doc = "Name in the outputs."},
          {.name = "outline",
           .min_count = 6,
           .max_count = k_any_count,
           .unit = "m",
           .required = true,
           .doc = "Corners x y x y ... in the ground frame, at least three."}}};
  for (const auto& attribute : placement()) element.attributes.push_back(attribute);
  return element;
}

/// Names of what may vary: strengths are attributes of <fracture>.
static const std::vector<std::string>& strengths() {
  static const std::vector<std::string> names{"flexural_strength", "compressive_strength", "fracture_toughness"};
  return names;
}

static std::vector<AttributeSpec> spread() {
  return {{.name = "distribution",
           .type = ValueType::choice,
           .choices = {"normal", "lognormal", "uniform", "weibull"},
           .default_value = "normal",
           .doc = "Its distribution, cut to physical limits: at least 0.05 of the mean, and a density of at most 0.999 "
                  "of the water's where there is buoyancy. weibull is for strengths."},
          {.name = "cov",
           .range = within(0, 1),
           .default_value = "0",
           .doc = "Coefficient of variation: standard deviation over mean, before the cut."},
          {.name = "mean",
           .unit = "Pa; Pa sqrt(m) for fracture_toughness",
           .range = above(0),
           .default_note = "the default of that attribute of <fracture>",
           .applies = {"property", strengths()},
           .doc = "Mean of a strength. Thickness and density vary about those of the floes."}};
}

static ElementSpec vary() {
  std::vector<std::string> properties{"thickness", "density"};
  properties.insert(properties.end(), strengths().begin(), strengths().end());
  ElementSpec element{
      .name = "vary",
      .parent = "ice",
      .count = Count::many,
      .doc =
          "Random variation of a property over the floes, once per property. What a field's file states stays. "
          "Strengths are drawn and written by `nilas field`; in a run they have an effect with what uses them in "
          "<fracture>.",
      .attributes = {{.name = "property",
                      .type = ValueType::choice,
                      .choices = properties,
                      .required = true,
                      .doc = "The property."}}};
  for (const auto& attribute : spread()) element.attributes.push_back(attribute);
  element.attributes.push_back({.name = "correlation_length",
                                .unit = "m",
                                .range = above(0),
                                .default_note = "none: one value per floe",
                                .doc =
                                    "Makes the property vary from point to point, within floes too, with correlation "
                                    "exp(-(d/length)^2) at distance d. The floe's body has the mean over its area."});
  element.attributes.push_back({.name = "with",
                                .type = ValueType::words,
                                .max_count = k_any_count,
                                .choices = properties,
                                .default_note = "none",
                                .doc = "Other properties that vary and that this one is correlated with. A pair is "
                                       "named once; pairs not named are uncorrelated."});
  element.attributes.push_back({.name = "correlation",
                                .max_count = k_any_count,
                                .range = inside(-1, 1),
                                .default_note = "none",
                                .doc = "With each of them: of the normal scores (Gaussian copula). All correlations "
                                       "together must make a positive definite matrix."});
  return element;
}

/// Of weak lines and bonds.
static AttributeSpec strength_left() {
  return {.name = "strength",
          .range = {.min = 0, .max = 1, .min_inclusive = false},
          .required = true,
          .doc = "Share of flexural strength and fracture toughness that is left there."};
}

static ElementSpec bond() {
  return {.name = "bond",
          .parent = "field",
          .applies = {"kind", {"voronoi"}},
          .doc =
              "The floes are frozen together: one sheet, whose seams between them are weak lines. It needs a "
              "concentration of 1. No effect without <cracks path=\"curved\">.",
          .attributes = {strength_left()}};
}

static ElementSpec weak_line() {
  return {.name = "weak_line",
          .parent = "ice",
          .count = Count::many,
          .doc =
              "A line along which the breakable floes that it crosses at the start are weaker: a refrozen crack, the "
              "flank of a ridge. No effect without <cracks path=\"curved\">.",
          .attributes = {{.name = "points",
                          .min_count = 4,
                          .max_count = k_any_count,
                          .unit = "m",
                          .required = true,
                          .doc = "Points x y x y ... in the ground frame, at least two."},
                         strength_left()}};
}

std::vector<ElementSpec> ice_elements() {
  return {ice(), field(), size(), shape(), bond(), floe(), weak_line(), vary()};
}

}  // namespace nilas::schema_table
