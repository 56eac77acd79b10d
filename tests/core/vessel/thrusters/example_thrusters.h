#pragma once
/// Thrusters that several tests fit to their vessels.
#include <string>
#include <vector>

#include "core/vessel/thrusters/thruster.h"

namespace nilas::test {

/// A thruster at x, y [m] with equal limits ahead and astern [N], and its power [W].
inline vessel::Thruster thruster(const std::string& name, ThrusterKind kind, double x, double y, double most,
                                 double power) {
  vessel::Thruster t;
  t.name = name;
  t.kind = kind;
  t.at_V = {x, y, 0};
  t.most_ahead = t.most_astern = most;
  t.power = power;
  return t;
}

/// The reference vessel of Fossen's toolbox (76.2 m, 6000 t): four tunnels of 200 kN and two propellers of 799 kN.
inline std::vector<vessel::Thruster> supply_thrusters() {
  return {thruster("bow1", ThrusterKind::tunnel, 30, 0, 2e5, 1.5e6),
          thruster("bow2", ThrusterKind::tunnel, 22, 0, 2e5, 1.5e6),
          thruster("stern1", ThrusterKind::tunnel, -22, 0, 2e5, 1.5e6),
          thruster("stern2", ThrusterKind::tunnel, -30, 0, 2e5, 1.5e6),
          thruster("port", ThrusterKind::propeller, -35, 8, 7.99e5, 5e6),
          thruster("starboard", ThrusterKind::propeller, -35, -8, 7.99e5, 5e6)};
}

}  // namespace nilas::test
