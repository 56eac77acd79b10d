#pragma once
/// The Simbody tree of a hull and its parts, with plain matrices as interface. Body 0 is the hull, body k + 1 is part
/// k. Each body's frame B has its origin at the body's centre of mass; the hull's has the axes of V. Twists (v; w) and
/// wrenches are in G at the centre of mass. The n speeds and the coordinates are those of the vessel alone, because the
/// carriage's are prescribed.
#include <memory>
#include <utility>
#include <vector>

#include "core/vessel/model/vessel_model.h"

namespace nilas::vessel {

class JointedTree {
 public:
  /// A vessel that is free, fixed or on a carriage, in the model's initial state. Each cell is a force element of
  /// Simbody. Throws InputError naming a part with an impossible mass or inertia, and for cells that cannot hold the
  /// vessel.
  explicit JointedTree(const VesselModel& model);
  ~JointedTree();
  JointedTree(JointedTree&&) noexcept;
  JointedTree& operator=(JointedTree&&) noexcept;

  int num_bodies() const;
  int num_speeds() const;  ///< n
  /// Coordinates. A free hull has a quaternion (w, x, y, z) and a position; a ball or free part also has a quaternion.
  /// Speeds of a free hull: angular velocity and velocity in G. Speeds of a ball: angular velocity in its parent's
  /// axes.
  VecX coordinates() const;
  VecX speeds() const;
  void set_coordinates(const VecX& q);  ///< quaternions need not be exactly unit
  void set_speeds(const VecX& u);
  void normalise_quaternions();
  /// Coordinates displaced by `along` from q. `along` has an angle [rad] or a length [m] per speed, and for a ball the
  /// rotation vector.
  VecX moved(const VecX& q, const VecX& along) const;
  std::pair<int, int> speeds_of(int body) const;  ///< index of the first, and their number
  /// Sets position, yaw and speeds of the carriage; only for a tree with one.
  void set_carriage(const CarriageMotion::State& state);
  bool has_carriage() const;
  bool hull_is_free() const;  ///< true if so; its speeds then come first

  double mass(int body) const;
  Mat3 inertia_G(int body) const;
  Pose pose(int body) const;
  Vec6 twist(int body) const;
  /// (m v; I w) of one body [N s, N m s].
  Vec6 momentum(int body) const;
  MatX mass_matrix() const;         ///< n x n
  MatX jacobian(int body) const;    ///< 6 x n: twist = jacobian * speeds + prescribed twist of the carriage
  Vec6 twist_bias(int body) const;  ///< rate of the twist at constant speeds
  VecX coordinate_rates() const;    ///< rates of the coordinates at the present speeds
  /// Generalised force of the loads (one per body), minus Coriolis and centrifugal terms, and minus the inertia forces
  /// of the carriage's acceleration. Of `acceleration` only v [m/s^2] and yaw_rate [rad/s^2] are used. n entries.
  VecX force(const std::vector<Wrench>& loads, const CarriageMotion::State& acceleration) const;
  /// Generalised force of all cells of the carriage at the present coordinates and speeds. n entries.
  VecX cell_force() const;
  double cell_energy() const;  ///< energy of the cells' springs [J]
  /// Simbody's reaction of each body's joint to its parent, hull first, on the body at its joint point. It belongs to
  /// these accelerations of the speeds (n) and the carriage under these loads; it includes springs, dampers and cells.
  std::vector<Wrench> joint_loads(const VecX& accelerations, const CarriageMotion::State& acceleration,
                                  const std::vector<Wrench>& loads);
  Vec3 joint_point(int body) const;  ///< point where that load acts, frame G
  int parent(int body) const;        ///< -1: ground or the carriage
  /// Net load about each centre of mass from joint loads as above.
  std::vector<Wrench> net_loads(const std::vector<Wrench>& joints) const;

  /// Diagonal stiffness and damping of the joints' springs and dampers, per speed.
  const VecX& stiffness() const;
  const VecX& damping() const;
  /// Deflection of each spring from its rest, per speed; for a ball the rotation vector.
  VecX stretch() const;
  VecX part_coordinates(int part) const;  ///< as in PartState
  VecX part_rates(int part) const;

  int num_rods() const;                ///< m
  double rod_distance(int rod) const;  ///< distance of its ends [m]
  double length_unit() const;          ///< that of the model [m]
  /// Sets the length of a rod [m]. A rod of a new tree has none; call this before the functions below.
  void set_rod_length(int rod, double length);
  VecX rod_errors() const;  ///< distances of the rods' ends minus their lengths, m entries [m]
  /// m x n matrix: rates of the distances = rod_jacobian * speeds + rates that the carriage prescribes.
  MatX rod_jacobian() const;
  VecX rod_rates() const;  ///< rates of the distances at the present speeds, the carriage's included [m/s]
  /// Contribution of the carriage's acceleration to the second rates of the distances; only v and yaw_rate are used.
  VecX rod_rates(const CarriageMotion::State& acceleration) const;
  VecX rod_bias() const;  ///< second rates of the distances at constant speeds [m/s^2]
  /// Loads of m tensions on each body.
  std::vector<Wrench> rod_loads(const VecX& tensions) const;
  /// Displaces the coordinates along the speeds by n entries [m, rad].
  void displace(const VecX& along_speeds);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas::vessel
