#include "core/bodies/bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"

namespace nilas::bodies {

/// The place of a name in a list, at whose end it is put where it is new.
static int number_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    names.push_back(name);
    return static_cast<int>(names.size()) - 1;
  }
  return static_cast<int>(found - names.begin());
}

int Bodies::add(const BodySpec& spec) {
  NILAS_DEMAND(spec.shape != nullptr);
  NILAS_DEMAND(spec.pose.p.allFinite() && spec.pose.q.coeffs().allFinite() && spec.pose.q.norm() > 0);
  NILAS_DEMAND(spec.v.allFinite() && spec.w.allFinite());
  const bool can_move = spec.motion != Motion::fixed;
  NILAS_DEMAND(std::isfinite(spec.mass) && (!can_move || spec.mass > 0));
  NILAS_DEMAND(spec.inertia_B.allFinite() && (!can_move || geometry::physically_valid_inertia(spec.inertia_B)));
  id.push_back(next_id++);
  name.push_back(spec.name);
  kind.push_back(spec.kind);
  motion.push_back(spec.motion);
  material.push_back(number_of(spec.material, materials));
  shape.push_back(spec.shape);
  mass.push_back(spec.mass);
  inertia_B.push_back(spec.inertia_B);
  inertia_inverse_B.push_back(can_move ? Mat3(spec.inertia_B.inverse()) : Mat3(Mat3::Zero()));
  p_GB.push_back(spec.pose.p);
  q_GB.push_back(spec.pose.q);
  R_GB.push_back(Mat3::Identity());
  v_GB.push_back(spec.v);
  w_GB.push_back(spec.w);
  set_pose(size() - 1, spec.pose.p, spec.pose.q);
  if (added_mass_of_) added_mass_B.push_back(added_mass_of(id.size() - 1));
  return size() - 1;
}

std::size_t Bodies::index_of(std::int64_t body_id) const {
  const auto found = std::lower_bound(id.begin(), id.end(), body_id);
  NILAS_DEMAND(found != id.end() && *found == body_id);
  return static_cast<std::size_t>(found - id.begin());
}

void Bodies::remove(const std::vector<char>& gone) {
  NILAS_DEMAND(gone.size() == id.size());
  const auto drop = [&](auto&... lists) { (remove_marked(gone, lists), ...); };
  if (has_added_mass()) drop(added_mass_B);
  drop(id, name, kind, motion, material, shape, mass, inertia_B, inertia_inverse_B, p_GB, q_GB, R_GB, v_GB, w_GB);
}

void Bodies::set_pose(int b, const Vec3& p, const Quat& q) {
  const auto k = static_cast<std::size_t>(b);
  p_GB[k] = p;
  q_GB[k] = q.normalized();
  R_GB[k] = q_GB[k].toRotationMatrix();
}

Mat6 Bodies::added_mass_of(std::size_t b) const {
  if (motion[b] != Motion::free) return Mat6::Zero();
  const Mat6 added = added_mass_of_(kind[b], *shape[b], mass[b]);
  NILAS_DEMAND(added.allFinite() && added == added.transpose());
  return added;
}

void Bodies::set_added_mass(AddedMassOf of, const Vec3& flow_G) {
  added_mass_of_ = std::move(of);
  flow = flow_G;
  added_mass_B.clear();
  for (std::size_t b = 0; b < id.size(); ++b) added_mass_B.push_back(added_mass_of(b));
}

Mat6 turned(const Mat6& matrix_B, const Mat3& R_GB) {
  Mat6 matrix_G;
  for (const int i : {0, 3})
    for (const int j : {0, 3}) matrix_G.block<3, 3>(i, j) = R_GB * matrix_B.block<3, 3>(i, j) * R_GB.transpose();
  return matrix_G;
}

Mat6 Bodies::added_mass_G(int b) const {
  const auto k = static_cast<std::size_t>(b);
  return turned(added_mass_B[k], R_GB[k]);
}

Mat6 Bodies::whole_mass_B(int b) const {
  const auto k = static_cast<std::size_t>(b);
  Mat6 whole = added_mass_B[k];
  whole.diagonal().head<3>().array() += mass[k];
  whole.bottomRightCorner<3, 3>() += inertia_B[k];
  return whole;
}

Mat3 Bodies::inertia_G(int b) const {
  const auto k = static_cast<std::size_t>(b);
  return R_GB[k] * inertia_B[k] * R_GB[k].transpose();
}

Mat3 Bodies::inertia_inverse_G(int b) const {
  const auto k = static_cast<std::size_t>(b);
  return R_GB[k] * inertia_inverse_B[k] * R_GB[k].transpose();
}

Vec3 Bodies::velocity_at(int b, const Vec3& point_G) const {
  const auto k = static_cast<std::size_t>(b);
  return v_GB[k] + w_GB[k].cross(point_G - p_GB[k]);
}

void Bodies::save(StateWriter out) const {
  out.add("id", id);
  out.add("next_id", next_id);
  out.add("p_GB", p_GB);
  out.add("q_GB", q_GB);
  out.add("R_GB", R_GB);
  out.add("v_GB", v_GB);
  out.add("w_GB", w_GB);
}

void Bodies::restore(const StateReader& in) {
  std::vector<std::int64_t> saved;
  in.get("id", saved);
  if (saved != id) in.refuse("id", "these are not the bodies of this scene");
  in.get("next_id", next_id);
  const std::size_t count = id.size();
  in.get("p_GB", p_GB, count);
  in.get("q_GB", q_GB, count);
  in.get("R_GB", R_GB, count);
  in.get("v_GB", v_GB, count);
  in.get("w_GB", w_GB, count);
}

}  // namespace nilas::bodies
