#pragma once
/// Choices of <wind> and <wind_area>.
#include "core/choices/choice.h"

namespace nilas {

namespace defaults {

constexpr double k_air_density = 1.225;    ///< at 15 deg C and sea level [kg/m^3]
constexpr double k_wind_exponent = 0.12;   ///< of a power law over open sea [DNV-RP-C205, table 2-1]
constexpr double k_floe_air_drag = 0.002;  ///< of pack ice, by the wind at 10 m [Guest, Davidson 1991]

}  // namespace defaults

/// How the mean wind grows with height.
enum class WindProfileKind { uniform, power, log };
constexpr ChoiceText choice_text(WindProfileKind value) {
  switch (value) {
    case WindProfileKind::uniform:
      return {"uniform", "The wind is the same at every height."};
    case WindProfileKind::power:
      return {"power", "The speed is `speed * (z / 10 m)^exponent` at the height z above still water."};
    case WindProfileKind::log:
      return {"log",
              "The speed grows with the logarithm of the height, as ISO 19901-1 states it for the mean over an hour."};
  }
  return {};
}

enum class GustSpectrum { none, npd };
constexpr ChoiceText choice_text(GustSpectrum value) {
  switch (value) {
    case GustSpectrum::none:
      return {"none", "The wind is steady."};
    case GustSpectrum::npd:
      return {"npd", "Gusts along the wind have the spectrum of ISO 19901-1, from periods of 2 s to 600 s."};
  }
  return {};
}

/// Where the coefficients of the wind load on a vessel come from.
enum class WindAreaModel { blendermann, coefficients };
constexpr ChoiceText choice_text(WindAreaModel value) {
  switch (value) {
    case WindAreaModel::blendermann:
      return {"blendermann", "They follow from the kind of ship by the formulas of Blendermann (1994)."};
    case WindAreaModel::coefficients:
      return {"coefficients", "They stand in a file, over the angle of the relative wind."};
  }
  return {};
}

/// The ships of Blendermann's table.
enum class BlendermannShip {
  car_carrier,
  cargo_loaded,
  cargo_container_on_deck,
  container_loaded,
  destroyer,
  diving_support,
  drilling,
  ferry,
  fishing,
  lng_tanker,
  offshore_supply,
  passenger_liner,
  research,
  speed_boat,
  tanker_loaded,
  tanker_in_ballast,
  tender,
};
constexpr ChoiceText choice_text(BlendermannShip value) {
  switch (value) {
    case BlendermannShip::car_carrier:
      return {"car-carrier"};
    case BlendermannShip::cargo_loaded:
      return {"cargo-loaded"};
    case BlendermannShip::cargo_container_on_deck:
      return {"cargo-container-on-deck"};
    case BlendermannShip::container_loaded:
      return {"container-loaded"};
    case BlendermannShip::destroyer:
      return {"destroyer"};
    case BlendermannShip::diving_support:
      return {"diving-support"};
    case BlendermannShip::drilling:
      return {"drilling"};
    case BlendermannShip::ferry:
      return {"ferry"};
    case BlendermannShip::fishing:
      return {"fishing"};
    case BlendermannShip::lng_tanker:
      return {"lng-tanker"};
    case BlendermannShip::offshore_supply:
      return {"offshore-supply"};
    case BlendermannShip::passenger_liner:
      return {"passenger-liner"};
    case BlendermannShip::research:
      return {"research"};
    case BlendermannShip::speed_boat:
      return {"speed-boat"};
    case BlendermannShip::tanker_loaded:
      return {"tanker-loaded"};
    case BlendermannShip::tanker_in_ballast:
      return {"tanker-in-ballast"};
    case BlendermannShip::tender:
      return {"tender"};
  }
  return {};
}

}  // namespace nilas
