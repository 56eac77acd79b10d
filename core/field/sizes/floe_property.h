#pragma once
/// The properties of a floe that a scene may vary.
#include <array>
#include <string_view>

#include "core/field/spec/field_spec.h"

namespace nilas {

enum class FloeProperty { thickness, density, flexural_strength, compressive_strength, fracture_toughness };
constexpr int k_num_floe_properties = 5;
constexpr std::array<FloeProperty, k_num_floe_properties> k_floe_properties{
    FloeProperty::thickness, FloeProperty::density, FloeProperty::flexural_strength, FloeProperty::compressive_strength,
    FloeProperty::fracture_toughness};

/// One value per property, in the order of the enumeration.
using FloeValues = std::array<double, k_num_floe_properties>;

/// As in a scene: "flexural_strength".
std::string_view name_of(FloeProperty property);
/// With its unit, as in files and tables: "flexural_strength_Pa".
std::string_view column_of(FloeProperty property);
/// Throws InputError for a name that is none.
FloeProperty floe_property(std::string_view name);
/// Its value in a floe, 0: the scene's.
double& value_of(FieldFloe& floe, FloeProperty property);
double value_of(const FieldFloe& floe, FloeProperty property);

}  // namespace nilas
