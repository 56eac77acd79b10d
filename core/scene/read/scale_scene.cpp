#include "core/scene/read/scale_scene.h"

#include <algorithm>

#include "core/choices/defaults.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/schema/schema.h"
#include "core/scene/spec/ice_presets.h"
#include "core/scene/spec/unit.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

/// The unit of an attribute of this element.
const std::string& unit_of(const SceneElement& element, const AttributeSpec& spec) {
  const auto holds = [&](const OtherUnit& other) {
    const auto decides = text_of(element, other.applies.attribute);
    const auto& values = other.applies.values;
    return decides && std::find(values.begin(), values.end(), *decides) != values.end();
  };
  const auto found = std::find_if(spec.other_units.begin(), spec.other_units.end(), holds);
  return found == spec.other_units.end() ? spec.unit : found->unit;
}

class Scaling {
 public:
  Scaling(double lambda, std::vector<Fault>& faults) : lambda_(lambda), faults_(faults) {}

  void scale(SceneElement& element) {
    const ElementSpec& spec = *find_element(element.name);
    for (SceneAttribute& attribute : element.attributes) {
      if (!attribute.valid) continue;
      const AttributeSpec& of = *find_attribute(spec, attribute.name);
      if (of.type == ValueType::number && of.scaled) scale(element, attribute, of);
      if ((of.type == ValueType::path || of.type == ValueType::hull) && !of.scaled_file)
        faults_.push_back(fault_of(element, attribute.name, "--scale: this kind of file cannot be scaled"));
    }
    for (SceneElement& child : element.children) scale(child);
  }

 private:
  void scale(const SceneElement& element, SceneAttribute& attribute, const AttributeSpec& spec) {
    const std::string& unit = unit_of(element, spec);
    const auto dimension = parse_unit(unit, [&](const std::string& name) { return number_of(element, name); });
    if (!dimension) {
      // An exponent without effect in this element is absent, and so is the effect of the value.
      if (parse_unit(unit, [](const std::string&) { return std::optional(0.0); })) return;
      faults_.push_back(fault_of(element, attribute.name, "--scale: the unit '" + unit + "' is not known"));
      return;
    }
    const double factor = scale_factor(*dimension, lambda_);
    if (factor == 1) return;
    std::string scaled;
    for (const std::string& word : split_words(attribute.value))
      scaled += (scaled.empty() ? "" : " ") + format_number(parse_number(word).value_or(0) * factor);
    attribute.value = scaled;
    if (const auto problem = value_problem(spec, scaled))
      faults_.push_back(fault_of(element, attribute.name, "--scale: after scaling " + *problem));
  }

  double lambda_;
  std::vector<Fault>& faults_;
};

/// Sets an attribute at its place in the order of the table, as in a scene that is read again.
void set_attribute(SceneElement& element, const std::string& name, double value) {
  const std::string text = format_number(value);
  if (SceneAttribute* given = attribute_of(element, name)) {
    given->value = text;
    return;
  }
  element.attributes.push_back({.name = name, .value = text, .place = element.place, .given = false});
  const ElementSpec& spec = *find_element(element.name);
  std::stable_sort(element.attributes.begin(), element.attributes.end(), [&](const auto& one, const auto& other) {
    return find_attribute(spec, one.name) < find_attribute(spec, other.name);
  });
}

/// Writes a default that the program would fill in later, so that it is scaled too.
void write_default(SceneElement& element, const std::string& attribute, double value) {
  if (!attribute_of(element, attribute)) set_attribute(element, attribute, value);
}

void write_hull_length(SceneElement& root) {
  SceneElement* vessel = child_of(root, "vessel");
  if (SceneElement* form = vessel ? child_of(*vessel, "hull") : nullptr)
    write_default(*form, "length", defaults::k_hull_length);
}

/// Without <fracture>, the means of varied strengths are those of the ice's preset.
void write_mean_strengths(SceneElement& root) {
  SceneElement* ice = child_of(root, "ice");
  if (!ice || child_of(root, "fracture")) return;
  const auto name = text_of(*ice, "preset");
  if (!name) return;
  const IcePreset& preset = ice_preset(*name);
  for (SceneElement& vary : ice->children) {
    if (vary.name != "vary") continue;
    const auto property = choice_of<FloeProperty>(vary, "property");
    if (property == FloeProperty::flexural_strength) write_default(vary, "mean", preset.flexural_strength);
    if (property == FloeProperty::compressive_strength) write_default(vary, "mean", preset.compressive_strength);
    if (property == FloeProperty::fracture_toughness) write_default(vary, "mean", preset.fracture_toughness);
  }
}

}  // namespace

void scale_scene(SceneElement& root, double lambda, std::vector<Fault>& faults, SceneNotes& notes) {
  write_hull_length(root);
  write_mean_strengths(root);
  Scaling(lambda, faults).scale(root);
  set_attribute(root, "scale", number_of(root, "scale").value_or(1) * lambda);
  const std::string text = "--scale: lengths are " + format_number(lambda) +
                           " times those of the scene, and all other values follow by Froude's and Cauchy's laws";
  notes.derived.insert(notes.derived.begin(), text + "; defaults are named below as they were before.");
}

}  // namespace nilas::scene
