#pragma once
/// Choices of a scene's <mooring>.
#include "core/choices/choice.h"

namespace nilas {

/// How a moored vessel starts.
enum class MooringStart { equilibrium, as_placed };
constexpr ChoiceText choice_text(MooringStart value) {
  switch (value) {
    case MooringStart::equilibrium:
      return {"equilibrium",
              "The vessel is moved to where weight, buoyancy and lines balance. Without buoyancy only its place and "
              "heading are sought. A vessel with <part> or <rod> starts as placed."};
    case MooringStart::as_placed:
      return {"as-placed", "The vessel starts at its position, and the lines may set it in motion."};
  }
  return {};
}

/// The model of the mooring lines.
enum class MooringKind { quasi_static, moordyn };
constexpr ChoiceText choice_text(MooringKind value) {
  switch (value) {
    case MooringKind::quasi_static:
      return {"quasi-static", "Each line is at rest at each instant, as a catenary or a spring."};
    case MooringKind::moordyn:
      return {"moordyn",
              "MoorDyn 2 moves the lines, which `file` describes in its own form. The library must be installed. The "
              "vessel starts as placed."};
  }
  return {};
}

}  // namespace nilas
