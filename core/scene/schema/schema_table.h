#pragma once
/// The parts of the table, one function per chapter of the scene file.
#include <string>
#include <vector>

#include "core/scene/schema/schema.h"

namespace nilas::schema_table {

inline Range above(double x) { return {.min = x, .min_inclusive = false}; }
inline Range at_least(double x) { return {.min = x}; }
inline Range within(double low, double high) { return {.min = low, .max = high}; }
/// Both ends excluded.
inline Range inside(double low, double high) {
  return {.min = low, .max = high, .min_inclusive = false, .max_inclusive = false};
}

/// Of bodies and of parts of vessels: shape, size, radius, height, mesh and material.
std::vector<AttributeSpec> shape_attributes(const std::vector<std::string>& shapes, const std::string& doc,
                                            const std::string& material);
/// mass, density and inertia. `owner`: "body".
std::vector<AttributeSpec> mass_attributes(const std::string& owner);
/// Three numbers, 0 0 0 by default.
AttributeSpec three(const std::string& name, const std::string& unit, const std::string& doc);

std::vector<ElementSpec> run_elements();
std::vector<ElementSpec> contact_elements();
std::vector<ElementSpec> water_elements();
std::vector<ElementSpec> vessel_elements();
ElementSpec part_element();  ///< a child of the vessel
ElementSpec rod_element();   ///< a child of the vessel
std::vector<ElementSpec> ice_elements();
std::vector<ElementSpec> fracture_elements();
std::vector<ElementSpec> body_elements();
std::vector<ElementSpec> output_elements();

}  // namespace nilas::schema_table
