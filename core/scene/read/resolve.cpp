#include "core/scene/read/resolve.h"

#include <algorithm>
#include <map>

#include "core/scene/read/scale_defaults.h"
#include "core/scene/scene.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/schema/schema.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

/// The values with which a preset replaces the defaults of <contact>.
std::map<std::string, std::string> values_of(ContactPreset preset) {
  switch (preset) {
    case ContactPreset::metrikin_2014:
      return {{"law", name_of(Law::pyramid)},
              {"solver", name_of(SolverName::pgs)},
              {"tolerance", "0"},
              {"max_iterations", "50"},
              {"stabilisation", name_of(Stabilisation::split_impulse)},
              {"detection", name_of(Detection::discrete)},
              {"integrator", name_of(Integrator::semi_implicit_euler)},
              {"gyroscopic", "false"}};
  }
  return {};
}

class Resolver {
 public:
  Resolver(const SceneElement& root, const std::filesystem::path& file, SceneNotes& notes)
      : folder_(std::filesystem::absolute(file).parent_path()),
        stem_(file.stem().string()),
        scale_(root, folder_),
        notes_(notes) {}

  void resolve_all(SceneElement& root) {
    resolve(root);
    for (const auto& text : scale_.notes()) notes_.derived.push_back(text + ".");
  }

 private:
  void resolve(SceneElement& element) {
    const ElementSpec& spec = *find_element(element.name);
    for (auto& attribute : element.attributes)
      if (attribute.valid) spell(attribute, *find_attribute(spec, attribute.name));
    for (const auto& attribute : spec.attributes) add_default(element, attribute);
    add_derived(element);
    note_without_effect(element, spec);
    sort_attributes(element, spec);
    add_children(element);
    for (auto& child : element.children) resolve(child);
  }

  void note(const std::string& where, const std::string& text) {
    notes_.said_once.push_back(where + ": " + text + ".");
  }

  void spell(SceneAttribute& attribute, const AttributeSpec& spec) const {
    attribute.value = canonical_value(spec, attribute.value);
    if (spec.type == ValueType::path || spec.type == ValueType::hull)
      attribute.value = (folder_ / attribute.value).lexically_normal().string();
  }

  static void add(SceneElement& element, const std::string& name, const std::string& value) {
    element.attributes.push_back({.name = name, .value = value, .place = element.place, .given = false});
  }

  /// Whether steps are cut at impacts, which Moreau's impulses in the middle of a step do not allow.
  static bool cuts_steps(const SceneElement& contact) {
    const SceneAttribute *substeps = attribute_of(contact, "substeps"), *detection = attribute_of(contact, "detection");
    if (detection && detection->valid && detection->value != name_of(Detection::continuous)) return false;
    return substeps && substeps->valid && substeps->value != "0" && substeps->value != "1";
  }

  void add_default(SceneElement& element, const AttributeSpec& spec) {
    if (attribute_of(element, spec.name) || !has_effect(element, spec.applies)) return;
    if (const auto preset = find_choice<ContactPreset>(text_of(element, "preset").value_or(""))) {
      const auto values = values_of(*preset);
      if (const auto set = values.find(spec.name); set != values.end()) return add(element, spec.name, set->second);
    }
    if (const auto scaled = scale_.take(element.name, spec.name)) return add(element, spec.name, *scaled);
    if (spec.name == "integrator")
      return add(element, spec.name,
                 name_of(cuts_steps(element) ? Integrator::semi_implicit_euler : ContactScene{}.integrator));
    if (spec.default_value.empty()) return;
    add(element, spec.name, canonical_value(spec, spec.default_value));
  }

  /// Defaults that depend on other attributes.
  void add_derived(SceneElement& element) {
    const auto absent = [&](const char* name) { return !attribute_of(element, name); };
    const auto valid = [&](const char* name) {
      const SceneAttribute* attribute = attribute_of(element, name);
      return attribute && attribute->valid;
    };
    const std::string default_density = format_number(SolidScene::k_density);
    if (element.is_root && absent("name")) {
      const bool usable = !value_problem(*find_attribute(*find_element("scene"), "name"), stem_);
      add(element, "name", usable ? stem_ : "scene");
    }
    if (element.name == "friction") {
      if (absent("static") && valid("kinetic")) add(element, "static", attribute_of(element, "kinetic")->value);
      if (absent("kinetic") && valid("static")) add(element, "kinetic", attribute_of(element, "static")->value);
    }
    if (element.name == "part" && absent("mass") && absent("density")) add(element, "density", default_density);
    if (element.name == "body") {
      ++num_bodies_;
      if (absent("name")) add(element, "name", "body " + std::to_string(num_bodies_));
      if (absent("mass") && absent("density")) add(element, "density", default_density);
      const bool plane = valid("shape") && attribute_of(element, "shape")->value == name_of(SolidShapeKind::plane);
      if (absent("fixed")) add(element, "fixed", plane ? "true" : "false");
    }
  }

  /// Whether the condition is met; true also where the deciding attribute is faulty.
  static bool has_effect(const SceneElement& element, const Condition& condition) {
    if (condition.values.empty()) return true;
    const SceneAttribute* decides = attribute_of(element, condition.attribute);
    if (!decides || !decides->valid) return true;
    return std::count(condition.values.begin(), condition.values.end(), decides->value) > 0;
  }

  void note_without_effect(const SceneElement& element, const ElementSpec& spec) {
    for (const auto& attribute : element.attributes) {
      const Condition& condition = find_attribute(spec, attribute.name)->applies;
      if (attribute.given && attribute.valid && !has_effect(element, condition))
        note_condition(where_of(element, attribute.name), element, condition);
    }
    for (const auto& child : element.children) {
      const Condition& condition = find_element(child.name)->applies;
      if (!has_effect(element, condition)) note_condition(child.path, element, condition);
    }
    if (element.is_root) note_idle_strengths(element);
    if (element.is_root) note_idle_fracture(element);
    if (element.is_root) note_idle_flows(element);
    if (element.is_root) note_idle_waves(element);
    if (element.name != "carriage" || !child_of(element, "path")) return;
    for (const char* attribute : {"speed", "heading_deg", "ramp"})
      if (is_given_nonzero(element, attribute)) note(where_of(element, attribute), "no effect with <path>");
    if (const SceneAttribute* shape = attribute_of(element, "ramp_shape"); shape && shape->given)
      note(where_of(element, "ramp_shape"), "no effect with <path>");
  }

  /// Notes strengths that no model of the scene uses.
  void note_idle_strengths(const SceneElement& root) {
    static const std::map<std::string, std::vector<std::string>> uses{{"flexural_strength", {"bending", "splitting"}},
                                                                      {"compressive_strength", {"crushing"}},
                                                                      {"fracture_toughness", {"splitting"}}};
    const SceneElement *ice = child_of(root, "ice"), *fracture = child_of(root, "fracture");
    if (!ice) return;
    for (const auto& child : ice->children) {
      const SceneAttribute* property = child.name == "vary" ? attribute_of(child, "property") : nullptr;
      const auto use = property && property->valid ? uses.find(property->value) : uses.end();
      const auto is_used = [&](const std::string& by) {
        const SceneElement* model = fracture ? child_of(*fracture, by) : nullptr;
        return model && (use->first != "fracture_toughness" || has_curved_cracks(fracture) ||
                         choice_of<SplittingModel>(*model, "model") == SplittingModel::lefm);
      };
      if (use == uses.end() || std::any_of(use->second.begin(), use->second.end(), is_used)) continue;
      note(child.path, use->first + " has no effect in a run without <" +
                           (fracture ? use->second.front() : "fracture") + ">; `nilas field` writes it");
    }
  }

  static bool has_curved_cracks(const SceneElement* fracture) {
    const SceneElement* cracks = fracture ? child_of(*fracture, "cracks") : nullptr;
    return cracks && choice_of<CrackPathKind>(*cracks, "path") == CrackPathKind::curved;
  }

  /// Notes weak lines without curved cracks: straight cracks ignore them.
  void note_idle_weak_lines(const SceneElement* ice, const SceneElement* fracture) {
    if (!ice || has_curved_cracks(fracture)) return;
    const std::string without = "no effect without <fracture><cracks path=\"curved\">";
    for (const auto& child : ice->children) {
      if (child.name == "weak_line") note(child.path, without);
      if (const auto* bond = child.name == "field" ? child_of(child, "bond") : nullptr) note(bond->path, without);
    }
  }

  void note_idle_fracture(const SceneElement& root) {
    const SceneElement *ice = child_of(root, "ice"), *fracture = child_of(root, "fracture");
    note_idle_weak_lines(ice, fracture);
    const bool breakable = ice && std::any_of(ice->children.begin(), ice->children.end(),
                                              [](const SceneElement& child) { return is_true(child, "breakable"); });
    if (breakable && !fracture) note(ice->path, "breakable has no effect in a run without <fracture>");
    if (!fracture) return;
    if (!breakable) note(fracture->path, "no effect: no <field> or <floe> is breakable");
    const bool breaks = child_of(*fracture, "bending") || child_of(*fracture, "splitting");
    if (breaks && !child_of(*fracture, "crushing"))
      note(fracture->path, "without <crushing> ice breaks by the peaks of rigid contacts, which depend on the step");
    const SceneElement* cracks = child_of(*fracture, "cracks");
    if (cracks && !breaks) note(cracks->path, "no effect without <bending> or <splitting>");
    const SceneElement* damage = child_of(*fracture, "damage");
    if (damage && !breaks) note(damage->path, "no effect without <bending> or <splitting>");
    if (fracture->children.empty()) note(fracture->path, "no effect: it names no <crushing>, <bending> or <splitting>");
  }

  /// Notes currents and jets that no drag feels, and a wind or a vessel's area that stands alone.
  void note_idle_flows(const SceneElement& root) {
    const SceneElement *water = child_of(root, "water"), *hydro = child_of(root, "hydro");
    const SceneElement *vessel = child_of(root, "vessel"), *wind = child_of(root, "wind");
    const bool drag = hydro && is_named(*hydro, "drag");
    const SceneElement* current = water ? child_of(*water, "current") : nullptr;
    for (const char* table : {"profile", "series"})
      if (current && !drag && attribute_of(*current, table))
        note(where_of(*current, table), "no effect on bodies without <hydro><drag>");
    const SceneElement* wash = hydro ? child_of(*hydro, "propeller_wash") : nullptr;
    if (wash && !drag) note(wash->path, "no effect without <hydro><drag>");
    const SceneElement* area = vessel ? child_of(*vessel, "wind_area") : nullptr;
    if (area && !is_named(root, "wind")) note(area->path, "no effect without <wind>");
    if (wind && !area && !is_named(root, "ice"))
      note(wind->path, "no effect without <ice> or a vessel with <wind_area>");
  }

  /// Notes waves that exert no load of their own.
  void note_idle_waves(const SceneElement& root) {
    const SceneElement *water = child_of(root, "water"), *hydro = child_of(root, "hydro");
    const SceneElement* waves = water ? child_of(*water, "waves") : nullptr;
    if (!waves || (hydro && is_named(*hydro, "wave_loads"))) return;
    const bool drag = hydro && is_named(*hydro, "drag");
    note(waves->path, drag ? "without <hydro><wave_loads> waves act only through drag"
                           : "no effect without <hydro><wave_loads> or <hydro><drag>");
  }

  void note_condition(const std::string& where, const SceneElement& element, const Condition& condition) {
    note(where,
         "no effect with " + condition.attribute + " '" + attribute_of(element, condition.attribute)->value + "'");
  }

  static void sort_attributes(SceneElement& element, const ElementSpec& spec) {
    const auto rank = [&](const SceneAttribute& attribute) { return find_attribute(spec, attribute.name); };
    std::stable_sort(element.attributes.begin(), element.attributes.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  }

  /// Adds the elements whose absence means their defaults.
  static void add_children(SceneElement& element) {
    for (const auto* spec : children_of(element.name))
      if (spec->always && !is_named(element, spec->name) && has_effect(element, spec->applies))
        element.children.push_back(make_element(spec->name, &element, element.place));
    const SceneElement* hydro = element.is_root ? child_of(element, "hydro") : nullptr;
    if (hydro && needs_water(*hydro) && !is_named(element, "water"))
      element.children.push_back(make_element("water", &element, hydro->place));
  }

  std::filesystem::path folder_;
  std::string stem_;
  ScaleDefaults scale_;
  SceneNotes& notes_;
  int num_bodies_ = 0;
};

}  // namespace

void resolve_defaults(SceneElement& root, const std::filesystem::path& file, SceneNotes& notes) {
  Resolver(root, file, notes).resolve_all(root);
}

}  // namespace nilas::scene
