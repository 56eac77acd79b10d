#pragma once
/// The hydrodynamic database of a scene's vessel.
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "hydro/database/database.h"

namespace nilas::sim {

struct VesselDatabase {
  std::shared_ptr<const hydro::Database> values;
  Pose in_V;                        ///< frame D of the database in V
  std::vector<std::string> doubts;  ///< sentences about it that become warnings

  /// A matrix of added mass, damping or stiffness about the origin of D, in the axes of V and about a point of V [m].
  Mat6 about(const Mat6& matrix, const Vec3& point_V) const {
    const Mat3 R = in_V.q.toRotationMatrix();
    Mat6 turn = Mat6::Zero();
    turn.topLeftCorner<3, 3>() = R;
    turn.bottomRightCorner<3, 3>() = R;
    Mat6 lever = Mat6::Identity();  // takes motions about the point to those about the origin of D
    lever.topRightCorner<3, 3>() = -skew(in_V.p - point_V);
    return lever.transpose() * (turn * matrix * turn.transpose()) * lever;
  }
};

}  // namespace nilas::sim
