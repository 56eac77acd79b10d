#pragma once
/// Motion and loads of a ship in the horizontal plane, in the axes of the manoeuvring literature: the origin is
/// amidships, x points forward, y to starboard and z down. The module of manoeuvring turns them into those of the frame
/// G, whose vertical axis points up.

namespace nilas::hydro {

/// Velocity of the point amidships through the water, and the yaw rate.
struct PlanarMotion {
  double u = 0;  ///< surge, forward [m/s]
  double v = 0;  ///< sway, to starboard [m/s]
  double r = 0;  ///< yaw rate, bow to starboard [rad/s]
};

/// Loads on the ship about the point amidships.
struct PlanarLoads {
  double X = 0;  ///< forward [N]
  double Y = 0;  ///< to starboard [N]
  double N = 0;  ///< bow to starboard [N m]

  PlanarLoads& operator+=(const PlanarLoads& other) {
    X += other.X;
    Y += other.Y;
    N += other.N;
    return *this;
  }
};

/// Added mass in that plane about the point amidships; the matrix is symmetric.
struct PlanarAddedMass {
  double surge = 0;     ///< m_x [kg]
  double sway = 0;      ///< m_y [kg]
  double sway_yaw = 0;  ///< [kg m]
  double yaw = 0;       ///< J_z [kg m^2]
};

}  // namespace nilas::hydro
