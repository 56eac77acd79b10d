#include <algorithm>

#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/ice_presets.h"

namespace nilas::scene {

static std::vector<Vec2> points_of(const SceneElement& element, const std::string& attribute) {
  const auto numbers = numbers_of(element, attribute).value_or(std::vector<double>{});
  std::vector<Vec2> points;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) points.emplace_back(numbers[i], numbers[i + 1]);
  return points;
}

static WeakLineScene build_weak_line(const SceneElement& element) {
  WeakLineScene line;
  line.points = points_of(element, "points");
  assign(line.strength, element, "strength");
  return line;
}

static FloeScene build_floe(const SceneElement& element) {
  FloeScene floe;
  floe.line = element.place.line;
  assign(floe.name, element, "name");
  floe.outline = points_of(element, "outline");
  assign_placement(floe, element);
  return floe;
}

/// The mean of a strength when <vary> gives none: that of <fracture>, or of the ice's preset.
static double strength_of(FloeProperty property, const IcePreset& preset, const SceneElement* fracture) {
  const auto given_or = [&](double strength) {
    if (fracture) assign(strength, *fracture, name_of(property));
    return strength;
  };
  switch (property) {
    case FloeProperty::thickness:
    case FloeProperty::density:
      return 0;
    case FloeProperty::flexural_strength:
      return given_or(preset.flexural_strength);
    case FloeProperty::compressive_strength:
      return given_or(preset.compressive_strength);
    case FloeProperty::fracture_toughness:
      return given_or(preset.fracture_toughness);
  }
  return 0;
}

static VaryScene build_vary(const SceneElement& element, const IcePreset& preset, const SceneElement* fracture) {
  VaryScene vary;
  vary.line = element.place.line;
  assign(vary.property, element, "property");
  assign(vary.distribution, element, "distribution");
  assign(vary.cov, element, "cov");
  vary.mean = strength_of(vary.property, preset, fracture);
  if (vary.mean > 0) assign(vary.mean, element, "mean");
  assign(vary.correlation_length, element, "correlation_length");
  const auto partners = words_of(element, "with");
  const auto correlations = numbers_of(element, "correlation").value_or(std::vector<double>{});
  for (std::size_t k = 0; k < partners.size(); ++k)
    vary.correlations.emplace_back(choice_named<FloeProperty>(partners[k]), correlations.at(k));
  return vary;
}

IceScene build_ice_scene(const SceneElement& element, const SceneElement* fracture) {
  IceScene ice;
  const IcePreset& preset = ice_preset(text_of(element, "preset").value());
  assign(ice.density, element, "density");
  assign(ice.youngs_modulus, element, "youngs_modulus");
  assign(ice.poisson, element, "poisson");
  assign(ice.thickness, element, "thickness");
  for (const auto& child : element.children) {
    if (child.name == "field") ice.fields.push_back(build_field_scene(child));
    if (child.name == "vary") ice.vary.push_back(build_vary(child, preset, fracture));
    if (child.name == "floe") ice.floes.push_back(build_floe(child));
    if (child.name == "weak_line") ice.weak_lines.push_back(build_weak_line(child));
  }
  return ice;
}

}  // namespace nilas::scene
