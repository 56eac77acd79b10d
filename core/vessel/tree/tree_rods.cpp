#include "core/vessel/tree/tree_rods.h"

#include "core/base/error.h"
#include "core/vessel/tree/simbody_bodies.h"

namespace nilas::vessel {

void TreeRods::add(SimTK::SimbodyMatterSubsystem& matter, SimTK::MobilizedBody& mobilized, int body, const Vec3& at_B,
                   const Vec3& to_G) {
  // The length is set once the tree is complete; Simbody requires one above zero.
  constexpr double k_any_length = 1;
  rods_.push_back(
      {SimTK::Constraint::Rod(mobilized, to_simbody(at_B), matter.updGround(), to_simbody(to_G), k_any_length),
       mobilized, body, at_B, to_G});
}

double TreeRods::distance(int rod, const SimTK::State& state) const {
  const Rod& one = rods_[rod];
  return (from_simbody(one.mobilized.findStationLocationInGround(state, to_simbody(one.at_B))) - one.to_G).norm();
}

void TreeRods::set_length(int rod, double length, SimTK::State& state) const {
  rods_[rod].constraint.setRodLength(state, length);
}

VecX TreeRods::errors(const SimTK::State& state) const {
  VecX errors(size());
  for (int k = 0; k < size(); ++k) errors[k] = rods_[k].constraint.getPositionError(state);
  return errors;
}

MatX TreeRods::jacobian(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const {
  SimTK::Matrix transposed;  // calcP() copies the whole state
  matter.calcPt(state, transposed);
  NILAS_DEMAND(transposed.ncol() == size());
  MatX jacobian(transposed.ncol(), transposed.nrow());
  for (int i = 0; i < jacobian.rows(); ++i)
    for (int j = 0; j < jacobian.cols(); ++j) jacobian(i, j) = transposed(j, i);
  return jacobian;
}

VecX TreeRods::rates(const SimTK::State& state) const {
  VecX rates(size());
  for (int k = 0; k < size(); ++k) rates[k] = rods_[k].constraint.getVelocityError(state);
  return rates;
}

VecX TreeRods::bias(const SimTK::SimbodyMatterSubsystem& matter, const SimTK::State& state) const {
  SimTK::Vector found;
  matter.calcConstraintAccelerationErrors(state, SimTK::Vector(state.getNU(), 0.0), found);
  NILAS_DEMAND(found.size() == size());
  VecX bias(size());
  for (int k = 0; k < size(); ++k) bias[k] = found[k];
  return bias;
}

std::vector<Wrench> TreeRods::loads(const VecX& tensions, std::size_t bodies, const SimTK::State& state) const {
  NILAS_DEMAND(tensions.size() == size());
  std::vector<Wrench> loads(bodies);
  for (int k = 0; k < size(); ++k) {
    const Rod& rod = rods_[k];
    const Vec3 at_G = from_simbody(rod.mobilized.findStationLocationInGround(state, to_simbody(rod.at_B)));
    const Vec3 origin = from_simbody(rod.mobilized.getBodyOriginLocation(state));
    const Vec3 force = tensions[k] * (rod.to_G - at_G).normalized();
    loads[rod.body] += {force, (at_G - origin).cross(force)};
  }
  return loads;
}

}  // namespace nilas::vessel
