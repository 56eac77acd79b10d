#include "core/scene/table/schema_table.h"

namespace nilas::scene::schema_table {

static std::vector<AttributeSpec> spread() {
  using enum FloeProperty;
  return {
      choice("distribution", VaryScene{}.distribution,
             "It sets the distribution. It is cut to physical limits: at least 0.05 of the mean and, with buoyancy, "
             "a density of at most 0.999 of the water's."),
      {.name = "cov",
       .range = within(0, 1),
       .default_value = written(VaryScene{}.cov),
       .doc = "It is the coefficient of variation before the cut: the standard deviation over the mean."},
      {.name = "mean",
       .unit = "Pa",
       .other_units = {{when("property", fracture_toughness), "Pa sqrt(m)"}},
       .range = above(0),
       .default_note = "the default of that attribute of <fracture>",
       .applies = when("property", flexural_strength, compressive_strength, fracture_toughness),
       .doc = "It is the mean of a strength. Thickness and density vary about those of the floes."}};
}

static std::vector<AttributeSpec> correlations() {
  return {
      {.name = "correlation_length",
       .unit = "m",
       .range = above(0),
       .default_note = "none: one value per floe",
       .doc = "The property varies from point to point, within floes too. The correlation at distance d is "
              "exp(-(d/length)^2). The floe's body has the mean over its area."},
      {.name = "with",
       .type = ValueType::words,
       .max_count = k_any_count,
       .choices = choice_names<FloeProperty>(),
       .default_note = "none",
       .doc = "It names other varying properties with which this one is correlated. Each pair is named once; other "
              "pairs are uncorrelated."},
      {.name = "correlation",
       .max_count = k_any_count,
       .range = inside(-1, 1),
       .default_note = "none",
       .doc = "It gives the correlation with each of them, of the normal scores (Gaussian copula). The matrix of all "
              "correlations must be positive definite."}};
}

ElementSpec vary_element() {
  AttributeSpec property = choice<FloeProperty>("property", "It sets the property.");
  property.required = true;
  ElementSpec element{.name = "vary",
                      .parent = "ice",
                      .count = Count::many,
                      .doc =
                          "It varies one property randomly over the floes. Each property may be varied once. Values "
                          "from a field's file stay. `nilas field` draws and writes strengths too; in a run they act "
                          "with the models of <fracture> that use them.",
                      .attributes = {property}};
  for (const auto& group : {spread(), correlations()})
    element.attributes.insert(element.attributes.end(), group.begin(), group.end());
  return element;
}

}  // namespace nilas::scene::schema_table
