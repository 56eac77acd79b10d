#pragma once
/// The Simbody tree of the vessel behind plain matrices: Ground -> vessel, or Ground -> carriage -> vessel.
/// Frame B: axes of V, origin at the centre of mass. Twists and wrenches in G at the centre of mass.
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mass_properties.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas {

/// How the vessel hangs on the carriage. The carriage's frame C has its origin at the joint point and turns with its
/// yaw.
struct TreeJoint {
  Pose in_B;          ///< of the joint's outboard frame J, which coincides with C when all coordinates are zero
  double height = 0;  ///< Z of C's origin in G [m]
  std::vector<int>
      axes;  ///< the coordinates in rising order: 0..2 body-fixed X-Y-Z angles of J in C, 3..5 position of J in C
};

/// A load cell between vessel and carriage: its tension is -stiffness s - damping s', s = shortening . coordinates, and
/// acts along the coordinates with the weights of `shortening`.
struct TreeCell {
  VecX shortening;       ///< per coordinate, n
  double stiffness = 0;  ///< [N/m]
  double damping = 0;    ///< [N s/m]
};

class VesselTree {
 public:
  /// Free vessel. Coordinates: quaternion (w, x, y, z) and position of B; speeds: angular velocity and velocity in G.
  explicit VesselTree(const MassProperties& mass);
  /// On a carriage, whose yaw and position are prescribed. Speeds are the rates of the coordinates.
  /// Each of the cells is a force element of Simbody.
  VesselTree(const MassProperties& mass, const TreeJoint& joint, const std::vector<TreeCell>& cells = {});
  ~VesselTree();
  VesselTree(VesselTree&&) noexcept;
  VesselTree& operator=(VesselTree&&) noexcept;

  int size() const;  ///< n, number of speeds of the vessel
  void set_carriage(const CarriageMotion::State& state);
  void set_coordinates(const VecX& q);
  void set_speeds(const VecX& u);

  Pose pose() const;
  Vec6 twist() const;        ///< (v; w), the carriage's motion included
  MatX mass_matrix() const;  ///< n x n
  MatX jacobian() const;     ///< 6 x n: twist = jacobian * speeds + what the carriage imposes
  /// Generalised force of `load`, less Coriolis and centrifugal terms and the inertia forces of the carriage's
  /// acceleration; in `acceleration` only v [m/s^2] and yaw_rate [rad/s^2] count, as accelerations. For a free vessel:
  /// the load alone and its gyroscopic term.
  VecX force(const Wrench& load, const CarriageMotion::State& acceleration) const;
  /// What all cells do along the speeds, as Simbody evaluates them at these coordinates and speeds. n entries.
  VecX cell_force() const;
  double cell_energy() const;  ///< of their springs [J]
  /// Simbody's reaction of the vessel's joint to its carriage, on the vessel about its centre of mass in G: under
  /// `load`, with these accelerations of the speeds (n) and, as above, of the carriage. What acts along the joint's
  /// coordinates is in it: the cells, and what is missing beside them for these accelerations.
  Wrench reaction(const Wrench& load, const VecX& accelerations, const CarriageMotion::State& acceleration);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas
