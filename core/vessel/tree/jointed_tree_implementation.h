#pragma once
/// The Simbody system behind JointedTree.
#include <vector>

#include "core/vessel/tree/cell_force.h"
#include "core/vessel/tree/jointed_tree.h"
#include "core/vessel/tree/simbody_bodies.h"
#include "core/vessel/tree/tree_rods.h"

namespace nilas::vessel {

/// Whether a joint has one coordinate.
inline bool has_one_coordinate(JointKind kind) { return kind == JointKind::hinge || kind == JointKind::slider; }

struct JointedTree::Implementation {
  struct Body {
    SimTK::MobilizedBody mobilized;
    double mass = 0;
    Mat3 inertia = Mat3::Identity();
    Pose in_V;
    int parent = -1;
    PartModel part;                ///< only for a part
    int first_q = 0, first_u = 0;  ///< indices among all coordinates and speeds of the tree
  };

  const SimTK::State& at(const SimTK::Stage& stage) const {
    system.realize(state, stage);
    return state;
  }
  const Body& body(int k) const { return bodies[k]; }
  SimTK::Vector_<SimTK::SpatialVec> spatial(const std::vector<Wrench>& loads) const;
  SimTK::Vector all_accelerations(const VecX& accelerations, const CarriageMotion::State& carriage_acceleration) const;
  SimTK::Vector residual(const SimTK::Vector& accelerations, const SimTK::Vector_<SimTK::SpatialVec>& loads) const;

  // the steps of building a tree, in their order
  void add_hull(const VesselModel& model, const Pose& hull_in_G);
  void add_parts(const VesselModel& model);
  void add_rods(const VesselModel& model);
  void begin_state();
  void place_parts();
  void place_free_hull(const VesselModel& model, const Pose& hull_in_G);

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::DiscreteForces applied{forces, matter};
  CellForces cells;
  TreeRods rods;
  SimTK::MobilizedBody::Planar carriage;
  std::vector<Body> bodies;
  SimTK::State state;
  int carried = 0;  ///< number of the carriage's speeds, which come first
  bool free_hull = false;
  int speeds = 0;
  double length_unit = 1;  ///< of the model [m]
  VecX stiffness, damping;
};

}  // namespace nilas::vessel
