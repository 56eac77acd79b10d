#pragma once
/// The properties of a floe that a scene may vary.
#include <array>
#include <string_view>

#include "core/field/spec/field_spec.h"

namespace nilas::field {

constexpr int k_num_floe_properties = static_cast<int>(num_choices<FloeProperty>());
constexpr std::array<FloeProperty, k_num_floe_properties> k_floe_properties = all_choices<FloeProperty>();

/// One value per property, in the order of FloeProperty.
using FloeValues = std::array<double, k_num_floe_properties>;

/// Name of a property with its unit, as in files and tables: "flexural_strength_Pa".
std::string_view column_of(FloeProperty property);
/// The value of a property in a floe; 0: the scene's.
double& value_of(FieldFloe& floe, FloeProperty property);
double value_of(const FieldFloe& floe, FloeProperty property);

}  // namespace nilas::field
