#pragma once
/// Choices of a scene's <manoeuvring> and <manoeuvre>.
#include "core/choices/choice.h"

namespace nilas {

/// The model of the hull's forces in the horizontal plane.
enum class ManoeuvringModel { mmg, derivatives };
constexpr ChoiceText choice_text(ManoeuvringModel value) {
  switch (value) {
    case ManoeuvringModel::mmg:
      return {"mmg", "The hull, the propeller and the rudder have the forces of the MMG standard method."};
    case ManoeuvringModel::derivatives:
      return {"derivatives", "The forces on the hull are sums of given derivatives times powers of the velocities."};
  }
  return {};
}

/// Ships whose coefficients are built in.
enum class ManoeuvringPreset { kvlcc2, supply };
constexpr ChoiceText choice_text(ManoeuvringPreset value) {
  switch (value) {
    case ManoeuvringPreset::kvlcc2:
      return {"kvlcc2", "It is the tanker KVLCC2 of 320 m, for the model `mmg`."};
    case ManoeuvringPreset::supply:
      return {"supply", "It is a supply vessel of 76.2 m at low speed, for the model `derivatives`, without a rudder."};
  }
  return {};
}

/// What drives the vessel ahead.
enum class PropulsionKind { open_water, thrust_curve };
constexpr ChoiceText choice_text(PropulsionKind value) {
  switch (value) {
    case PropulsionKind::open_water:
      return {"open-water", "The thrust follows from the propeller's open-water curve, its wake and thrust deduction."};
    case PropulsionKind::thrust_curve:
      return {"thrust-curve",
              "The net thrust falls from the bollard pull to zero at the open-water speed. The resistance of the hull "
              "on a straight course is in it, so the hull has none of its own."};
  }
  return {};
}

/// How given derivatives are made without dimension.
enum class DerivativeScaling { si, bis, prime, prime_draught };
constexpr ChoiceText choice_text(DerivativeScaling value) {
  switch (value) {
    case DerivativeScaling::si:
      return {"si", "They have SI units."};
    case DerivativeScaling::bis:
      return {"bis", "Mass, length and the time sqrt(L/g) are the units."};
    case DerivativeScaling::prime:
      return {"prime", "Forces are divided by 0.5 rho L^2 U^2."};
    case DerivativeScaling::prime_draught:
      return {"prime-draught", "Forces are divided by 0.5 rho L d U^2."};
  }
  return {};
}

/// What the steering does.
enum class ManoeuvreKind { straight, turning_circle, zigzag, course };
constexpr ChoiceText choice_text(ManoeuvreKind value) {
  switch (value) {
    case ManoeuvreKind::straight:
      return {"straight", "The rudder stays amidships."};
    case ManoeuvreKind::turning_circle:
      return {"turning-circle", "The rudder is laid to `angle_deg` at `start` and stays there."};
    case ManoeuvreKind::zigzag:
      return {
          "zigzag",
          "The rudder is laid to `angle_deg` at `start`, and to the other side each time the heading has changed by "
          "`heading_deg` to the side of the rudder."};
    case ManoeuvreKind::course:
      return {"course", "An autopilot holds heading and speed by rudder and propeller."};
  }
  return {};
}

}  // namespace nilas
