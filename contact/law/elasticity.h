#pragma once
/// Elastic contact between two materials.

namespace nilas::contact {

/// A patch of contact has a normal and a tangential spring, each with a dashpot beside it.
struct Elasticity {
  double stiffness = 0;         ///< normal stiffness of a patch; 0: that of the ice edges that meet there [N/m]
  double edge_factor = 0;       ///< stiffness of an ice edge over Young's modulus times thickness
  double tangential_ratio = 0;  ///< tangential over normal stiffness
  double damping_ratio = 0;     ///< of the masses of both bodies on the normal spring; 1 is critical
};

}  // namespace nilas::contact
