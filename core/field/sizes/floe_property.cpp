#include "core/field/sizes/floe_property.h"

#include <string>

#include "core/base/error.h"

namespace nilas {

namespace {

struct Row {
  std::string_view name, column;
  double FieldFloe::*value;
};

constexpr std::array<Row, k_num_floe_properties> k_rows{{
    {"thickness", "thickness_m", &FieldFloe::thickness},
    {"density", "density_kg_m3", &FieldFloe::density},
    {"flexural_strength", "flexural_strength_Pa", &FieldFloe::flexural_strength},
    {"compressive_strength", "compressive_strength_Pa", &FieldFloe::compressive_strength},
    {"fracture_toughness", "fracture_toughness_Pa_sqrt_m", &FieldFloe::fracture_toughness},
}};

const Row& row_of(FloeProperty property) { return k_rows[static_cast<std::size_t>(property)]; }

}  // namespace

std::string_view name_of(FloeProperty property) { return row_of(property).name; }

std::string_view column_of(FloeProperty property) { return row_of(property).column; }

FloeProperty floe_property(std::string_view name) {
  for (const FloeProperty property : k_floe_properties)
    if (name_of(property) == name) return property;
  throw InputError("property of a floe: found '" + std::string(name) + "'");
}

double& value_of(FieldFloe& floe, FloeProperty property) { return floe.*row_of(property).value; }

double value_of(const FieldFloe& floe, FloeProperty property) { return floe.*row_of(property).value; }

}  // namespace nilas
