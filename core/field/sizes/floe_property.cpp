#include "core/field/sizes/floe_property.h"

namespace nilas::field {

namespace {

struct PropertyColumn {
  std::string_view column;
  double FieldFloe::*value;
};

PropertyColumn row_of(FloeProperty property) {
  switch (property) {
    case FloeProperty::thickness:
      return {"thickness_m", &FieldFloe::thickness};
    case FloeProperty::density:
      return {"density_kg_m3", &FieldFloe::density};
    case FloeProperty::flexural_strength:
      return {"flexural_strength_Pa", &FieldFloe::flexural_strength};
    case FloeProperty::compressive_strength:
      return {"compressive_strength_Pa", &FieldFloe::compressive_strength};
    case FloeProperty::fracture_toughness:
      return {"fracture_toughness_Pa_sqrt_m", &FieldFloe::fracture_toughness};
  }
  return {};
}

}  // namespace

std::string_view column_of(FloeProperty property) { return row_of(property).column; }

double& value_of(FieldFloe& floe, FloeProperty property) { return floe.*row_of(property).value; }

double value_of(const FieldFloe& floe, FloeProperty property) { return floe.*row_of(property).value; }

}  // namespace nilas::field
