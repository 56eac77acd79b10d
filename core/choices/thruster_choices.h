#pragma once
/// Choices of a scene's <thrusters> and <control>.
#include "core/choices/choice.h"

namespace nilas {

/// Kinds of thruster.
enum class ThrusterKind { tunnel, azimuth, propeller, propeller_rudder };
constexpr ChoiceText choice_text(ThrusterKind value) {
  switch (value) {
    case ThrusterKind::tunnel:
      return {"tunnel", "Its thrust acts along the vessel's y axis, positive to port."};
    case ThrusterKind::azimuth:
      return {"azimuth", "It turns about a vertical axis, and its thrust acts at its angle from ahead towards port."};
    case ThrusterKind::propeller:
      return {"propeller", "Its thrust acts along the vessel's x axis, positive ahead."};
    case ThrusterKind::propeller_rudder:
      return {"propeller-rudder",
              "It is a propeller with a rudder in its slipstream. The rudder's angle is positive where it deflects "
              "the thrust to port; aft, that turns the bow to starboard."};
  }
  return {};
}

/// Modes of automatic control.
enum class ControlMode { none, dp };
constexpr ChoiceText choice_text(ControlMode value) {
  switch (value) {
    case ControlMode::none:
      return {"none", "Nothing controls the thrusters, which keep the thrust and angle of their elements."};
    case ControlMode::dp:
      return {"dp", "Dynamic positioning: the thrusters hold position and heading, or follow a path."};
  }
  return {};
}

}  // namespace nilas
