#include "core/vessel/tree/cell_force.h"

#include <utility>

#include "core/base/error.h"

namespace nilas::vessel {

namespace {

/// One load cell as a custom force element. Simbody's own point-to-point springs and its bushing would follow the
/// rotations of the vessel. The balance's law is linear in the joint's coordinates instead, because its deflections are
/// small. Cells may also be coupled where the joint is free.
class CellForce : public SimTK::Force::Custom::Implementation {
 public:
  CellForce(SimTK::MobilizedBody vessel, TreeCell cell) : vessel_(std::move(vessel)), cell_(std::move(cell)) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                 SimTK::Vector& along_speeds) const override {
    double rate = 0;
    for (int i = 0; i < cell_.shortening.size(); ++i) rate += cell_.shortening[i] * vessel_.getOneU(state, i);
    const double tension = -cell_.stiffness * shorter(state) - cell_.damping * rate;
    for (int i = 0; i < cell_.shortening.size(); ++i)
      vessel_.applyOneMobilityForce(state, i, tension * cell_.shortening[i], along_speeds);
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State& state) const override {
    return 0.5 * cell_.stiffness * shorter(state) * shorter(state);
  }

 private:
  double shorter(const SimTK::State& state) const {
    double sum = 0;
    for (int i = 0; i < cell_.shortening.size(); ++i) sum += cell_.shortening[i] * vessel_.getOneQ(state, i);
    return sum;
  }

  SimTK::MobilizedBody vessel_;
  TreeCell cell_;
};

}  // namespace

void CellForces::add(SimTK::GeneralForceSubsystem& forces, const SimTK::MobilizedBody& vessel,
                     const std::vector<TreeCell>& cells) {
  for (const TreeCell& cell : cells)
    cells_.emplace_back(forces, new CellForce(vessel, cell));  // the subsystem takes ownership
}

VecX CellForces::along_speeds(const SimTK::State& state) const {
  VecX sum = VecX::Zero(state.getNU());
  SimTK::Vector_<SimTK::SpatialVec> on_bodies;
  SimTK::Vector_<SimTK::Vec3> on_particles;
  SimTK::Vector along;
  for (const SimTK::Force::Custom& cell : cells_) {
    cell.calcForceContribution(state, on_bodies, on_particles, along);
    for (int i = 0; i < sum.size(); ++i) sum[i] += along[i];
  }
  return sum;
}

double CellForces::energy(const SimTK::State& state) const {
  double sum = 0;
  for (const SimTK::Force::Custom& cell : cells_) sum += cell.calcPotentialEnergyContribution(state);
  return sum;
}

}  // namespace nilas::vessel
