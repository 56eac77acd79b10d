#pragma once
/// The parts of the table, one function per chapter of the scene file.
#include <concepts>
#include <string>
#include <vector>

#include "core/choices/choice.h"
#include "core/scene/scene.h"
#include "core/scene/spec/element_spec.h"

namespace nilas::scene::schema_table {

/// A value in the notation of a scene file. The table's defaults are those of the Scene's members.
std::string written(double x);
std::string written(int x);
std::string written(const Vec3& x);
std::string written(std::same_as<bool> auto x) { return x ? "true" : "false"; }
template <ChoiceEnum Enum>
std::string written(Enum x) {
  return name_of(x);
}

/// Condition that an attribute has one of these choices.
template <ChoiceEnum Enum, class... More>
Condition when(const std::string& attribute, Enum first, More... more) {
  return {attribute, {name_of(first), name_of(more)...}};
}

/// Meanings of the choices, at least one sentence for each that has a text: "`stop`: The run ends."
template <ChoiceEnum Enum>
std::string meanings() {
  std::string text;
  for (const Enum value : all_choices<Enum>())
    if (const ChoiceText of = choice_text(value); !of.doc.empty())
      text += " `" + std::string(of.name) + "`: " + std::string(of.doc);
  return text;
}

template <ChoiceEnum Enum>
std::map<std::string, std::string> old_names() {
  std::map<std::string, std::string> names;
  for (const Enum value : all_choices<Enum>())
    if (const ChoiceText of = choice_text(value); !of.old_name.empty()) names.emplace(of.old_name, of.name);
  return names;
}

/// An attribute without a default that takes one name of an enumeration.
template <ChoiceEnum Enum>
AttributeSpec choice(const std::string& name, const std::string& doc) {
  return {.name = name,
          .type = ValueType::choice,
          .choices = choice_names<Enum>(),
          .old_names = old_names<Enum>(),
          .doc = doc + meanings<Enum>()};
}
/// The same with a default.
template <ChoiceEnum Enum>
AttributeSpec choice(const std::string& name, Enum default_value, const std::string& doc) {
  AttributeSpec attribute = choice<Enum>(name, doc);
  attribute.default_value = written(default_value);
  return attribute;
}

inline Range above(double x) { return {.min = x, .min_inclusive = false}; }
inline Range at_least(double x) { return {.min = x}; }
inline Range within(double low, double high) { return {.min = low, .max = high}; }
/// A range that excludes both ends.
inline Range inside(double low, double high) {
  return {.min = low, .max = high, .min_inclusive = false, .max_inclusive = false};
}

/// Attributes for bodies and for parts of vessels: shape, size, radius, height, mesh and material. `can_be_plane`: the
/// shape plane is allowed.
std::vector<AttributeSpec> shape_attributes(bool can_be_plane, const std::string& material);
/// Attributes mass, density and inertia. `owner`: for example "body".
std::vector<AttributeSpec> mass_attributes(const std::string& owner);
/// An attribute of three numbers, 0 0 0 by default.
AttributeSpec three(const std::string& name, const std::string& unit, const std::string& doc);

std::vector<ElementSpec> run_elements();
std::vector<ElementSpec> contact_elements();
std::vector<ElementSpec> water_elements();
ElementSpec added_mass_element();  ///< a child of <hydro>
ElementSpec waves_element();       ///< a child of <water>
ElementSpec wave_loads_element();  ///< a child of <hydro>
ElementSpec database_element();    ///< a child of <hydro>
ElementSpec radiation_element();   ///< a child of <hydro>
std::vector<ElementSpec> vessel_elements();
std::vector<ElementSpec> wind_elements();         ///< with those of currents of air and water under other chapters
ElementSpec part_element();                       ///< a child of the vessel
ElementSpec rod_element();                        ///< a child of the vessel
std::vector<ElementSpec> manoeuvring_elements();  ///< children of the vessel
std::vector<ElementSpec> thruster_elements();     ///< thrusters and control of the vessel
std::vector<ElementSpec> mooring_elements();      ///< <mooring>, a child of the vessel, and its children
ElementSpec remote_control_element();             ///< a child of the vessel
std::vector<ElementSpec> ice_elements();
ElementSpec vary_element();  ///< a child of the ice
std::vector<ElementSpec> fracture_elements();
std::vector<ElementSpec> body_elements();
std::vector<ElementSpec> output_elements();

}  // namespace nilas::scene::schema_table
