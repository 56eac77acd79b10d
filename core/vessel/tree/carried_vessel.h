#pragma once
/// The vessel on its carriage: what both integrators share.
#include <optional>
#include <vector>

#include "core/vessel/tree/stiff_block.h"
#include "core/vessel/tree/vessel_motion.h"
#include "core/vessel/tree/vessel_tree.h"

namespace nilas {

/// How the vessel hangs on its carriage, which model.carriage must name.
TreeJoint carriage_joint(const VesselModel& model);
/// Coordinates of that joint along which it transmits nothing.
std::vector<int> free_coordinates(const CarriageModel& carriage);
/// The cells of its force balance, none but of six-cells. Throws InputError when they cannot hold the vessel.
std::vector<TreeCell> carriage_cells(const CarriageModel& carriage);

/// Axes 0..5 of rotation and translation that the joint leaves free; the scene names translations first.
std::vector<int> free_axes(const CarriageModel& carriage);

/// Coordinates q: those of the tree's joint; u: their rates, along stiff coordinates as the mean over the last step.
class CarriedVessel : public VesselMotion {
 public:
  CarriedVessel(const VesselModel& model, double t0);

  /// The momenta balance between the two ends of the step, so this is the velocity at its end.
  Vec6 velocity_after_impulses() const override;
  void displace(const Vec6&, double) override {}
  VesselRest settle(const RestModel& rest, bool start_there) override;
  double spring_energy() const override { return tree_.cell_energy(); }
  VecX coordinates() const override;

 protected:
  void save_motion(StateWriter& out) const override;
  void restore_motion(const StateReader& in) override;
  /// Throws SimulationError, naming the instant t [s], where q_ has left finite numbers or the joint its range.
  void demand_regular(double t) const;
  /// The tree and the state at q_ with the carriage at `carriage` and speeds u.
  void place(const CarriageMotion::State& carriage, const VecX& u);
  void set_speeds(const VecX& u);
  Vec6 momentum() const;  ///< (m v; I w) of the state
  /// Mean twist of the centre of mass, now at state_, that the carriage imposes while it goes from now_ to `next` in
  /// h_.
  Vec6 mean_carriage_twist(const CarriageMotion::State& next) const;
  /// One end of a step.
  struct StepEnd {
    VecX q, u;
    CarriageMotion::State carriage;
  };
  /// After read_loads(): what Simbody's reaction halfway between both ends says beside it. `given`: mean load of all
  /// but the carriage (force; torque about the centre of mass). Leaves the tree halfway.
  void ask_simbody(const StepEnd& start, const StepEnd& end, const Vec6& given);
  /// `reaction`: mean load (force; torque about the centre of mass); com, carriage: where its torques are taken.
  void read_loads(const Vec6& reaction, const Vec3& com, const CarriageMotion::State& carriage);

  CarriageMotion motion_;
  VesselTree tree_;
  MatX stiffness_;                     ///< n x n, constant: deflections of a force balance are small
  double damping_time_ = 0;            ///< cell damping / cell stiffness [s]
  std::vector<int> free_coordinates_;  ///< along which the joint transmits nothing

  VecX q_, u_;
  CarriageMotion::State now_;  ///< of the carriage where the vessel is
  StiffBlock step_;
  MatX jacobian_;
  VecX u_without_contact_;

 private:
  /// Coordinates that come to rest: those that cells hold, and free ones that water balances.
  std::vector<int> settling_coordinates(bool afloat) const;
  /// Of the coordinates at q, without any motion; leaves the tree there.
  VecX static_force(const RestModel& rest, const VecX& q);
  /// The q at which the settling coordinates carry nothing unbalanced.
  VecX equilibrium(const RestModel& rest);

  std::vector<int> axes_;                           ///< of the coordinates, as of TreeJoint
  std::optional<Eigen::PartialPivLU<Mat6>> cells_;  ///< wrench of unit tensions, six-cells only
  bool has_three_angles_ = false;                   ///< then they are the first three coordinates
};

/// The theta scheme on impulses; model.theta must be given.
std::unique_ptr<VesselMotion> make_moreau_carried_vessel(const VesselModel& model, double t0);

}  // namespace nilas
