#pragma once
/// The Simbody tree of a hull and the parts that hang on it, behind plain matrices. Bodies: the hull is 0, part k is
/// k + 1. Each body's frame B has its origin at the body's centre of mass; the hull's has the axes of V. Twists (v; w)
/// and wrenches are in G at the centre of mass. The n speeds and the coordinates are those of the vessel alone: the
/// carriage's are given.
#include <memory>
#include <utility>
#include <vector>

#include "core/vessel/model/vessel_model.h"

namespace nilas {

class JointedTree {
 public:
  /// Free, fixed, or on a carriage, at the model's start; each of its cells is a force element of Simbody. Throws
  /// InputError naming the part whose mass or inertia cannot be, and for cells that cannot hold the vessel.
  explicit JointedTree(const VesselModel& model);
  ~JointedTree();
  JointedTree(JointedTree&&) noexcept;
  JointedTree& operator=(JointedTree&&) noexcept;

  int num_bodies() const;
  int num_speeds() const;  ///< n
  /// Of a free hull: quaternion (w, x, y, z) and position; of a ball or free part a quaternion too. Speeds of a free
  /// hull: angular velocity and velocity in G; of a ball: angular velocity along its parent's axes.
  VecX coordinates() const;
  VecX speeds() const;
  void set_coordinates(const VecX& q);  ///< quaternions need not be exactly unit
  void set_speeds(const VecX& u);
  void normalise_quaternions();
  /// Coordinates that are `along` away from q: per speed an angle or a way, of a ball the rotation vector.
  VecX moved(const VecX& q, const VecX& along) const;
  std::pair<int, int> speeds_of(int body) const;  ///< the first, and how many
  /// Position, yaw and speeds of the carriage; a tree without one has none.
  void set_carriage(const CarriageMotion::State& state);
  bool has_carriage() const;
  bool hull_is_free() const;  ///< then its speeds come first

  double mass(int body) const;
  Mat3 inertia_G(int body) const;
  Pose pose(int body) const;
  Vec6 twist(int body) const;
  /// (m v; I w) of one body [N s, N m s].
  Vec6 momentum(int body) const;
  MatX mass_matrix() const;         ///< n x n
  MatX jacobian(int body) const;    ///< 6 x n: twist = jacobian * speeds + what the carriage imposes
  Vec6 twist_bias(int body) const;  ///< rate of the twist where no speed changes
  VecX coordinate_rates() const;    ///< of the coordinates at these speeds
  /// Generalised force of the loads (one per body), less Coriolis and centrifugal terms and the inertia forces of the
  /// carriage's acceleration, of which only v [m/s^2] and yaw_rate [rad/s^2] count, as accelerations. n entries.
  VecX force(const std::vector<Wrench>& loads, const CarriageMotion::State& acceleration) const;
  /// What all cells of the carriage do along the speeds at these coordinates and speeds. n entries.
  VecX cell_force() const;
  double cell_energy() const;  ///< of their springs [J]
  /// Simbody's reaction of each body's joint to its parent, hull first, on the body at its joint point: with these
  /// accelerations of the speeds (n) and the carriage under these loads; springs, dampers and cells included.
  std::vector<Wrench> joint_loads(const VecX& accelerations, const CarriageMotion::State& acceleration,
                                  const std::vector<Wrench>& loads);
  Vec3 joint_point(int body) const;  ///< where that load acts, in G
  int parent(int body) const;        ///< -1: ground or the carriage
  /// Net load about each centre of mass of joint loads as above.
  std::vector<Wrench> net_loads(const std::vector<Wrench>& joints) const;

  /// Per speed, diagonal: of the joints' springs and dampers.
  const VecX& stiffness() const;
  const VecX& damping() const;
  /// Per speed: how far each spring is out of rest; a ball's is its rotation vector.
  VecX stretch() const;
  VecX part_coordinates(int part) const;  ///< as of PartState
  VecX part_rates(int part) const;

  int num_rods() const;                ///< m
  double rod_distance(int rod) const;  ///< of its ends [m]
  /// Before the first use of the errors below: a rod of a new tree has no length of its own [m].
  void set_rod_length(int rod, double length);
  VecX rod_errors() const;  ///< distances of the rods' ends less their lengths, m entries [m]
  /// m x n: rates of the distances = rod_jacobian * speeds + what the carriage imposes.
  MatX rod_jacobian() const;
  VecX rod_rates() const;  ///< of the distances, at these speeds and those of the carriage [m/s]
  /// What the carriage's acceleration adds to the second rates of the distances; only v and yaw_rate count.
  VecX rod_rates(const CarriageMotion::State& acceleration) const;
  VecX rod_bias() const;  ///< second rates of the distances where no speed changes [m/s^2]
  /// What tensions (m) do to each body.
  std::vector<Wrench> rod_loads(const VecX& tensions) const;
  /// Moves the coordinates along the speeds by n entries [m, rad].
  void displace(const VecX& along_speeds);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas
