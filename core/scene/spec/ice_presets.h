#pragma once
/// Values of ice by kind, with sources, which replace values that a scene does not give. Sources:
/// docs/reference/scales.md.
#include <string>
#include <vector>

namespace nilas::scene {

struct IcePreset {
  std::string name;                                                    ///< name in <ice preset>
  double density = 0, youngs_modulus = 0, poisson = 0, thickness = 0;  ///< [kg/m^3], [Pa], -, [m]
  double flexural_strength = 0, compressive_strength = 0;              ///< [Pa]
  double fracture_toughness = 0;                                       ///< [Pa sqrt(m)]
  double pressure_coefficient = 0;                                     ///< pressure on 1 m^2 of contact [Pa]
  double floe_mean = 0, floe_sd = 0, floe_min = 0, floe_max = 0;       ///< floe sizes [m]
  double min_area = 0;                                                 ///< smallest piece [m^2]
};

/// All presets: "model" first, then kinds of full-scale ice.
const std::vector<IcePreset>& ice_presets();
/// The preset with this name. Throws ContractError for an unknown name.
const IcePreset& ice_preset(const std::string& name);
std::vector<std::string> ice_preset_names();

}  // namespace nilas::scene
