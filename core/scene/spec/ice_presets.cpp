#include "core/scene/spec/ice_presets.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/scene/scene.h"

namespace nilas::scene {

const std::vector<IcePreset>& ice_presets() {
  const IceScene ice;
  const FractureScene fracture;
  const LognormalSizeScene size;
  static const std::vector<IcePreset> presets{
      // These values lie in the middle of the ranges at which model basins aim: flexural strength 20 to 60 kPa, modulus
      // 10 to 150 MPa, toughness 1 to 5 kPa sqrt(m), compressive over flexural strength 1 to 4. They are also the
      // defaults of a scene.
      {.name = "model",
       .density = ice.density,
       .youngs_modulus = ice.youngs_modulus,
       .poisson = ice.poisson,
       .thickness = ice.thickness,
       .flexural_strength = fracture.flexural_strength,
       .compressive_strength = fracture.compressive_strength,
       .fracture_toughness = fracture.fracture_toughness,
       .pressure_coefficient = CrushingScene{}.coefficient,
       .floe_mean = size.mean,
       .floe_sd = size.sd,
       .floe_min = size.min,
       .floe_max = size.max,
       .min_area = fracture.min_area},
      // First-year sea ice, from the sources of docs/reference/scales.md. Measured forces support the exponent -0.7
      // that a scene gives the pressure on an area of up to 10 m^2. The pressure on 1 m^2 is a value of this program.
      {.name = "full-scale sea ice",
       .density = 920,
       .youngs_modulus = 5e9,
       .poisson = 0.33,
       .thickness = 1,
       .flexural_strength = 5e5,
       .compressive_strength = 2.5e6,
       .fracture_toughness = 1.15e5,
       .pressure_coefficient = 7.4e6,
       .floe_mean = 20,
       .floe_sd = 7.5,
       .floe_min = 7.5,
       .floe_max = 40,
       .min_area = 0.1},
      // The same formulas without brine give 1.76 MPa (Timco and O'Brien 1994) and a modulus of 9 GPa.
      {.name = "full-scale freshwater ice",
       .density = 917,
       .youngs_modulus = 9e9,
       .poisson = 0.33,
       .thickness = 1,
       .flexural_strength = 1.76e6,
       .compressive_strength = 5e6,
       .fracture_toughness = 1.15e5,
       .pressure_coefficient = 7.4e6,
       .floe_mean = 20,
       .floe_sd = 7.5,
       .floe_min = 7.5,
       .floe_max = 40,
       .min_area = 0.1}};
  return presets;
}

const IcePreset& ice_preset(const std::string& name) {
  const auto found =
      std::find_if(ice_presets().begin(), ice_presets().end(), [&](const IcePreset& p) { return p.name == name; });
  NILAS_DEMAND(found != ice_presets().end());
  return *found;
}

std::vector<std::string> ice_preset_names() {
  std::vector<std::string> names;
  for (const IcePreset& preset : ice_presets()) names.push_back(preset.name);
  return names;
}

}  // namespace nilas::scene
