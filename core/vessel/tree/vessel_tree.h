#pragma once
/// The Simbody tree of the vessel, with plain matrices as interface: Ground -> vessel, or Ground -> carriage -> vessel.
/// Frame B: axes of V, origin at the centre of mass. Twists and wrenches are in G at the centre of mass.
#include <memory>
#include <vector>

#include "core/base/math.h"
#include "core/geometry/mass_properties.h"
#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

/// The joint between vessel and carriage. The carriage's frame C has its origin at the joint point and turns with its
/// yaw.
struct TreeJoint {
  Pose in_B;              ///< pose of the joint's outboard frame J, which coincides with C at zero coordinates
  double height = 0;      ///< Z of C's origin in G [m]
  std::vector<int> axes;  ///< in rising order: 0..2 body-fixed X-Y-Z angles of J in C, 3..5 position of J in C
};

/// A load cell between vessel and carriage. Its tension is -stiffness s - damping s' with s = shortening . coordinates.
/// It acts along the coordinates with the weights of `shortening`.
struct TreeCell {
  VecX shortening;       ///< n entries, one per coordinate
  double stiffness = 0;  ///< [N/m]
  double damping = 0;    ///< [N s/m]
};

class VesselTree {
 public:
  /// Free vessel. Coordinates: quaternion (w, x, y, z) and position of B; speeds: angular velocity and velocity in G.
  explicit VesselTree(const geometry::MassProperties& mass);
  /// Vessel on a carriage with prescribed yaw and position. Speeds are the rates of the coordinates. Each of the cells
  /// is a force element of Simbody.
  VesselTree(const geometry::MassProperties& mass, const TreeJoint& joint, const std::vector<TreeCell>& cells = {});
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
  MatX jacobian() const;     ///< 6 x n: twist = jacobian * speeds + prescribed twist of the carriage
  /// Generalised force of `load`, minus Coriolis and centrifugal terms, and minus the inertia forces of the carriage's
  /// acceleration. Of `acceleration` only v [m/s^2] and yaw_rate [rad/s^2] are used. For a free vessel: the load and
  /// its gyroscopic term.
  VecX force(const Wrench& load, const CarriageMotion::State& acceleration) const;
  /// Generalised force of all cells by Simbody at the present coordinates and speeds. n entries.
  VecX cell_force() const;
  double cell_energy() const;  ///< energy of the cells' springs [J]
  /// Simbody's reaction of the vessel's joint to its carriage, on the vessel about its centre of mass, frame G. It
  /// belongs to `load`, these accelerations of the speeds (n) and, as above, the carriage's. It includes loads along
  /// the joint's coordinates: the cells, and whatever else these accelerations require.
  Wrench reaction(const Wrench& load, const VecX& accelerations, const CarriageMotion::State& acceleration);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas::vessel
