#include "nilas/schema.h"

#include "core/scene/schema/schema.h"

namespace nilas {

static const char* type_name(scene::ValueType type) {
  switch (type) {
    case scene::ValueType::number:
      return "number";
    case scene::ValueType::integer:
      return "integer";
    case scene::ValueType::boolean:
      return "boolean";
    case scene::ValueType::text:
      return "text";
    case scene::ValueType::name:
      return "name";
    case scene::ValueType::words:
      return "words";
    case scene::ValueType::choice:
      return "choice";
    case scene::ValueType::path:
      return "path";
    default:
      return "hull";
  }
}

static AttributeInfo info_of(const scene::AttributeSpec& spec) {
  AttributeInfo info;
  info.name = spec.name;
  info.type = type_name(spec.type);
  info.min_count = spec.min_count;
  info.max_count = spec.max_count == scene::k_any_count ? -1 : spec.max_count;
  info.unit = scene::unit_text(spec);
  info.default_value = spec.default_value;
  info.default_note = spec.default_note;
  info.allowed = scene::allowed_text(spec);
  info.choices = spec.choices;
  info.required = spec.required;
  info.doc = spec.doc;
  return info;
}

std::vector<ElementInfo> scene_schema() {
  std::vector<ElementInfo> all;
  for (const scene::ElementSpec& spec : scene::scene_schema()) {
    if (!spec.built) continue;
    ElementInfo info{spec.name, spec.parent, spec.count == scene::Count::many, spec.doc, {}};
    for (const scene::AttributeSpec& attribute : spec.attributes)
      if (attribute.built) info.attributes.push_back(info_of(attribute));
    all.push_back(std::move(info));
  }
  return all;
}

}  // namespace nilas
