#pragma once
/// All rigid bodies of a scene in arrays. The index of a body is its place in the arrays; ids grow with the index and
/// never repeat. The vessel is one entry whose motion comes from core/vessel.
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "core/base/state.h"
#include "core/geometry/mass_properties.h"
#include "core/geometry/shape.h"

namespace nilas::bodies {

enum class BodyKind { floe, rigid, wall, vessel };
/// free: six degrees of freedom here; fixed: never moves; articulated: moved by the vessel system.
enum class Motion { free, fixed, articulated };

/// One body before it joins the arrays.
struct BodySpec {
  std::string name;
  BodyKind kind = BodyKind::rigid;
  Motion motion = Motion::free;
  std::string material = "structure";
  std::shared_ptr<const geometry::Shape> shape;  ///< origin at the centre of mass
  double mass = 0;                               ///< [kg]
  Mat3 inertia_B = Mat3::Identity();             ///< inertia about the centre of mass [kg m^2]
  Pose pose;                                     ///< pose of the centre of mass in G
  Vec3 v = Vec3::Zero();                         ///< velocity of the centre of mass [m/s]
  Vec3 w = Vec3::Zero();                         ///< angular velocity in G [rad/s]
};

/// The added mass of a body that moves freely: 6 x 6 about its centre of mass, in body axes, velocity before rotation
/// [kg, kg m, kg m^2]. Arguments: kind, shape, mass.
using AddedMassOf = std::function<Mat6(BodyKind, const geometry::Shape&, double)>;

struct Bodies {
  std::vector<std::int64_t> id;
  std::vector<std::string> name;
  std::vector<BodyKind> kind;
  std::vector<Motion> motion;
  std::vector<int> material;           ///< its place in `materials`
  std::vector<std::string> materials;  ///< names, each once, in the order in which bodies brought them
  std::vector<std::shared_ptr<const geometry::Shape>> shape;
  std::vector<double> mass;             ///< [kg]
  std::vector<Mat3> inertia_B;          ///< inertia about the centre of mass, body axes [kg m^2]
  std::vector<Mat3> inertia_inverse_B;  ///< zero for a fixed body [1/(kg m^2)]
  std::vector<Vec3> p_GB;               ///< centre of mass [m]
  std::vector<Quat> q_GB;               ///< unit
  std::vector<Mat3> R_GB;               ///< rotation matrix of q_GB, kept in step by set_pose
  std::vector<Vec3> v_GB;               ///< velocity of the centre of mass [m/s]
  std::vector<Vec3> w_GB;               ///< angular velocity, frame G [rad/s]
  std::int64_t next_id = 1;             ///< id of the next added body
  /// Added mass of the water that moves with each free body, as AddedMassOf gives it; empty where the scene names none.
  std::vector<Mat6> added_mass_B;
  Vec3 flow = Vec3::Zero();  ///< velocity of the water to which added mass refers, frame G [m/s]

  int size() const { return static_cast<int>(id.size()); }
  bool is_free(int b) const { return motion[b] == Motion::free; }
  bool moves(int b) const { return motion[b] != Motion::fixed; }
  /// Appends a body, returns its index; the id is `next_id`, which goes up by one. Throws ContractError when the shape
  /// is missing, a number is not finite, or a body that moves has no positive mass and physically valid inertia.
  int add(const BodySpec& spec);
  const std::string& material_name(int b) const { return materials[material[b]]; }
  /// Index of the body with this id. Throws ContractError where there is none.
  std::size_t index_of(std::int64_t body_id) const;
  /// Removes bodies; the others keep their order. `gone`: one entry per body, true for those to remove.
  void remove(const std::vector<char>& gone);
  /// Sets pose and the rotation matrix that belongs to it; q need not be exactly unit, it is normalised.
  void set_pose(int b, const Vec3& p, const Quat& q);
  /// Gives every free body its added mass, and every body that is added later. Throws ContractError where a matrix is
  /// not finite and symmetric.
  void set_added_mass(AddedMassOf of, const Vec3& flow_G);
  bool has_added_mass() const { return !added_mass_B.empty(); }
  /// Added mass in the axes of G. Only where has_added_mass().
  Mat6 added_mass_G(int b) const;
  /// The 6 x 6 mass of body and water in body axes. Only where has_added_mass().
  Mat6 whole_mass_B(int b) const;
  Mat3 inertia_G(int b) const;                         ///< R I R^T
  Mat3 inertia_inverse_G(int b) const;                 ///< R I^-1 R^T
  Vec3 velocity_at(int b, const Vec3& point_G) const;  ///< velocity of the body's point that is now at point_G [m/s]

  /// Ids, poses and velocities.
  void save(StateWriter out) const;
  /// Throws InputError when the state belongs to other bodies.
  void restore(const StateReader& in);

 private:
  Mat6 added_mass_of(std::size_t b) const;
  AddedMassOf added_mass_of_;  ///< empty where the scene names no added mass
};

/// A 6 x 6 matrix of velocities before rotations, taken from the axes of B to those of G by the rotation R_GB.
Mat6 turned(const Mat6& matrix_B, const Mat3& R_GB);

/// Takes the entries that are marked out of a list beside the bodies; the others keep their order.
template <class T>
void remove_marked(const std::vector<char>& gone, std::vector<T>& list) {
  std::size_t k = 0;
  std::erase_if(list, [&](const T&) { return gone[k++] != 0; });
}

}  // namespace nilas::bodies
