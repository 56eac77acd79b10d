#pragma once
/// Choices of a scene's <vessel> and of its attached bodies.
#include "core/choices/choice.h"

namespace nilas {

/// Kinds of generated hull.
enum class HullKind { icebreaker, wedge };
constexpr ChoiceText choice_text(HullKind value) {
  switch (value) {
    case HullKind::icebreaker:
      return {"icebreaker", "The hull has a sloping stem, flared sides and a run aft."};
    case HullKind::wedge:
      return {"wedge", "The hull has vertical sides and a straight wedge bow."};
  }
  return {};
}

/// How a straight run reaches its speed. Both end at the same place.
enum class RampShape {
  linear,  ///< constant acceleration
  smooth   ///< acceleration that rises from zero and falls back to it: speed V s^2 (3 - 2 s) at the ramp's share s
};
constexpr ChoiceText choice_text(RampShape value) {
  switch (value) {
    case RampShape::linear:
      return {"linear", "The acceleration is constant; its jumps at both ends make load cells oscillate."};
    case RampShape::smooth:
      return {
          "smooth",
          "The acceleration rises from zero to 1.5 times that value and falls back to zero over the same distance."};
  }
  return {};
}

/// How a towed vessel starts.
enum class CarriageStart { equilibrium, as_placed };
constexpr ChoiceText choice_text(CarriageStart value) {
  switch (value) {
    case CarriageStart::equilibrium:
      return {"equilibrium",
              "The vessel starts at rest under weight and buoyancy, with deflected cells. Free axes that the water "
              "balances (heave, roll, pitch) are in equilibrium too."};
    case CarriageStart::as_placed:
      return {"as-placed",
              "The vessel starts upright at its position with unloaded cells. A vessel with <rod> always does."};
  }
  return {};
}

/// The device that holds a towed vessel and measures its load.
enum class BalanceKind { rigid, six_cells, prismatic };
constexpr ChoiceText choice_text(BalanceKind value) {
  switch (value) {
    case BalanceKind::rigid:
      return {"rigid", "The joint is rigid and its reactions are constraint forces."};
    case BalanceKind::six_cells:
      return {"six-cells", "Six uniaxial load cells hold the joint."};
    case BalanceKind::prismatic:
      return {"prismatic", "The joint leaves the vessel free to heave only."};
  }
  return {};
}

/// Axes of a joint between carriage and vessel.
enum class JointAxis { surge, sway, heave, roll, pitch, yaw };
constexpr ChoiceText choice_text(JointAxis value) {
  switch (value) {
    case JointAxis::surge:
      return {"surge"};
    case JointAxis::sway:
      return {"sway"};
    case JointAxis::heave:
      return {"heave"};
    case JointAxis::roll:
      return {"roll"};
    case JointAxis::pitch:
      return {"pitch"};
    case JointAxis::yaw:
      return {"yaw"};
  }
  return {};
}

/// The joint of an attached body.
enum class JointKind { hinge, slider, ball, free, weld };
constexpr ChoiceText choice_text(JointKind value) {
  switch (value) {
    case JointKind::hinge:
      return {"hinge", "The body turns about one axis."};
    case JointKind::slider:
      return {"slider", "The body moves along one axis."};
    case JointKind::ball:
      return {"ball", "The body turns about a point."};
    case JointKind::free:
      return {"free", "Nothing holds the body."};
    case JointKind::weld:
      return {"weld", "The body is fixed to what it hangs on."};
  }
  return {};
}

}  // namespace nilas
