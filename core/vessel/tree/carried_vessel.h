#pragma once
/// The vessel on its carriage: the code that both integrators share.
#include <optional>
#include <vector>

#include "core/vessel/tree/stiff_block.h"
#include "core/vessel/tree/vessel_motion.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas::vessel {

/// The joint between vessel and carriage. model.carriage must be present.
TreeJoint carriage_joint(const VesselModel& model);
/// Coordinates of that joint along which it transmits no load.
std::vector<int> free_coordinates(const CarriageModel& carriage);
/// The cells of its force balance; empty unless it is of kind six-cells. Throws InputError when they cannot hold the
/// vessel.
std::vector<TreeCell> carriage_cells(const CarriageModel& carriage);

/// Axes 0..5 of a carriage's joint: three of rotation, then three of translation.
constexpr int k_roll = 0, k_pitch = 1, k_heave = 5;
constexpr int k_first_translation = 3;
/// Share of the weight along a free axis above which the vessel falls or swings instead of resting.
constexpr double k_unbalanced = 0.01;

/// Axes that the joint leaves free; the scene names translations first.
std::vector<int> free_axes(const CarriageModel& carriage);

/// A vessel on a carriage. Coordinates q: those of the tree's joint. Speeds u: their rates; along stiff coordinates the
/// means over the last step.
class CarriedVessel : public VesselMotion {
 public:
  CarriedVessel(const VesselModel& model, double t0);

  /// The velocity at the step's end, because the momenta are balanced between both ends of the step.
  Vec6 velocity_after_impulses() const override;
  void displace(const Vec6&, double) override {}
  VesselRest settle(const RestModel& rest, bool start_there) override;
  double spring_energy() const override { return tree_.cell_energy(); }
  VecX coordinates() const override;

 protected:
  void save_motion(StateWriter& out) const override;
  void restore_motion(const StateReader& in) override;
  /// Throws SimulationError naming the instant t [s] when q_ is not finite or the joint has left its range.
  void demand_regular(double t) const;
  /// Moves the tree and the state to q_, with the carriage at `carriage` and the speeds u.
  void place(const CarriageMotion::State& carriage, const VecX& u);
  void set_speeds(const VecX& u);
  Vec6 momentum() const;  ///< (m v; I w) of the state [N s, N m s]
  /// Mean twist of the centre of mass (at state_) that the carriage prescribes on its motion from now_ to `next` in h_.
  Vec6 mean_carriage_twist(const CarriageMotion::State& next) const;
  /// One end of a step.
  struct StepEnd {
    VecX q, u;
    CarriageMotion::State carriage;
  };
  /// Compares the load of read_loads() with Simbody's reaction halfway between both ends. `given`: mean load of
  /// everything but the carriage (force; torque about the centre of mass). Leaves the tree halfway. Call after
  /// read_loads().
  void ask_simbody(const StepEnd& start, const StepEnd& end, const Vec6& given);
  /// Writes the carriage's loads. `reaction`: mean load (force; torque about the centre of mass). `com`, `carriage`:
  /// the points about which torques are taken.
  void read_loads(const Vec6& reaction, const Vec3& com, const CarriageMotion::State& carriage);

  CarriageMotion motion_;
  VesselTree tree_;
  MatX stiffness_;                     ///< n x n, constant: deflections of a force balance are small
  double damping_time_ = 0;            ///< cell damping / cell stiffness [s]
  std::vector<int> free_coordinates_;  ///< where the joint transmits no load

  VecX q_, u_;
  CarriageMotion::State now_;  ///< the carriage at the vessel's present instant
  StiffBlock step_;
  MatX jacobian_;
  VecX u_without_contact_;

 private:
  /// Coordinates along which the balance is sought: those that cells hold, and free ones that water balances.
  std::vector<int> settling_coordinates(bool afloat) const;
  /// Generalised force of the coordinates at q, without any motion. Leaves the tree there.
  VecX static_force(const RestModel& rest, const VecX& q);
  /// The q at which the settling coordinates are in balance.
  VecX equilibrium(const RestModel& rest);

  std::vector<int> axes_;  ///< axis of each coordinate, as in TreeJoint
  std::optional<Eigen::PartialPivLU<Mat6>>
      cells_;                      ///< factorised matrix whose columns are wrenches of unit tensions; six-cells only
  bool has_three_angles_ = false;  ///< true if the first three coordinates are angles
};

/// The vessel on its carriage in the theta scheme on impulses. model.theta must be present.
std::unique_ptr<VesselMotion> make_moreau_carried_vessel(const VesselModel& model, double t0);

}  // namespace nilas::vessel
