#pragma once
/// Newton's systems on the bodies of an island. With K = a U + U C + R per contact, C its scaled compliance,
///
///   (1 + sum J'^T K^-1 U J') dz = -sum J'^T K^-1 F,   dr' = -K^-1 (F + U J' dz),   J' = e J
///
/// gives the same step as the system between contacts with a quarter to an eighth of the work, since a body of k
/// contacts is one node of six coordinates and not k(k + 1)/2 blocks. Open contacts, dr' = -r', are taken out.
///
/// Limit: the condition is about 1/a, so a must not fall below about 1e-9; where contacts are redundant a smaller one
/// would only decide how the impulses are split among them.
#include "contact/problem/prepared_problem.h"
#include "contact/solvers/bodies/body_island.h"
#include "contact/solvers/bodies/node_lu.h"
#include "contact/solvers/newton/newton_system.h"

namespace nilas::solvers {

class BodySystem final : public NewtonSystem {
 public:
  /// All must outlive the system.
  BodySystem(const contact::PreparedProblem& island, const BodyIsland& bodies, const NodePlan& plan);

  VecX product(const VecX& r) const override;
  bool step(double weight, const VecX& r, VecX& dr) override;

 private:
  void moved(const VecX& r, NodeVector& z) const;
  VecX seen(const NodeVector& z) const;
  Vec3 compliance(int c) const;

  const contact::PreparedProblem& island_;
  const BodyIsland& bodies_;
  NodeLu lu_;
  std::vector<Mat3> g_, by_motion_;  ///< U and K^-1 U of each contact in impulses and scaled, zero where it is open
};

}  // namespace nilas::solvers
