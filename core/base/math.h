#pragma once
/// Linear-algebra names used throughout. SI units and radians inside; ground frame G has Z up and
/// still water at z = 0. Monogram letters as in docs/reference/conventions.md (p_GB, R_GB, v_GB, w_GB).
#include <Eigen/Dense>
#include <cmath>

namespace nilas {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using MatX = Eigen::MatrixXd;
using VecX = Eigen::VectorXd;
using Quat = Eigen::Quaterniond;

/// Cross-product matrix: skew(a) * b == a.cross(b).
inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Vertical component of the cross product of two horizontal vectors.
inline double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The horizontal unit vector at this angle from X towards Y.
inline Vec2 direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Position and orientation of a body frame B in G.
struct Pose {
  Quat q = Quat::Identity();
  Vec3 p = Vec3::Zero();  ///< [m]
};

/// Force and torque about a stated point (the centre of mass unless said), expressed in G.
struct Wrench {
  Vec3 force = Vec3::Zero();   ///< [N]
  Vec3 torque = Vec3::Zero();  ///< [N m]
  Wrench& operator+=(const Wrench& o) {
    force += o.force;
    torque += o.torque;
    return *this;
  }
};

constexpr double k_pi = 3.14159265358979323846;
constexpr double k_deg = k_pi / 180.0;  ///< radians per degree, for the XML and CSV edges only

}  // namespace nilas
