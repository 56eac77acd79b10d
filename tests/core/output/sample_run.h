#pragma once
/// A hand-made run for the tests of the outputs.
#include <filesystem>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/sim/account/step_record.h"
#include "tests/support/scratch_folder.h"

namespace nilas::test {

/// A run with every module that has columns.
inline sim::RunInfo full_run() {
  sim::RunInfo info;
  info.scene_name = "sample";
  info.work_names = {"drag", "carriage"};
  info.modules = {{"vessel", "<vessel>"}, {"carriage", "<carriage>"}};
  info.not_built = {"waves"};
  info.floes = 2;
  info.bodies = 3;
  info.ice_mass = 30;
  info.concentration = 0.8;
  info.has_vessel = info.has_carriage = info.has_cells = info.has_hydro = true;
  info.vessel_mass.mass = 1500;
  info.vessel_mass.com = Vec3(2, 0, 0.25);
  info.vessel_mass.inertia << 10, -4, -5, -4, 20, -6, -5, -6, 30;
  info.tare.emplace();
  info.tare->about_joint = {Vec3(0, 0, 7), Vec3(1, -2, 0)};
  info.tare->cells = {3, 2, 0, 1, 2, -0.5};
  return info;
}

/// Step 1 at 0.01 s with small numbers that tell the columns apart.
inline sim::StepRecord full_record() {
  sim::StepRecord record;
  record.step = 1;
  record.t = record.h = 0.01;
  record.floes = 2;
  record.contacts = 3;
  record.islands = 1;
  record.iterations = 17;
  record.residuals.law_map_m_s = 1e-7;
  record.residuals.momentum_sqrtJ = 0.1;
  record.penetration_max = 0.002;
  record.penetration_mean = 0.001;
  record.ledger = {5, -6, {7, -8}, 0.5, 0.25, 0.125, 0, 0, -0.0625, 1e-12};
  record.momentum_imbalance = 1e-13;
  record.momentum_scale = 2;
  record.angular_momentum_imbalance = 2e-13;
  record.angular_momentum_scale = 4;
  record.ms = {1, 2, 3, 4, 5, 6, 7};
  record.state_hash = 0x00ab;
  sim::VesselRecord vessel;
  vessel.contact = {Vec3(1, 2, 3), Vec3(4, 5, 6)};
  vessel.ice = vessel.contact.force;
  vessel.carriage.emplace();
  vessel.carriage->about_joint = {Vec3(11, 12, 13), Vec3(14, 15, 16)};
  vessel.carriage->about_com = {Vec3(21, 22, 23), Vec3(24, 25, 26)};
  vessel.carriage->cells = {31, 32, 33, 34, 35, 36};
  vessel.has_cells = true;
  vessel.hydro = Wrench{Vec3(41, 42, 43), Vec3(44, 45, 46)};
  vessel.state.pose.p = Vec3(51, 52, 53);
  vessel.state.v = Vec3(0.3, -1e-14, 62);
  record.vessel = vessel;
  return record;
}

inline void add_body(bodies::Bodies& bodies, const std::string& name, bodies::BodyKind kind, bodies::Motion motion,
                     const geometry::Shape& shape, double mass, const Vec3& p) {
  const auto b = bodies.id.size();
  bodies.id.push_back(static_cast<std::int64_t>(b) + 1);
  bodies.name.push_back(name);
  bodies.kind.push_back(kind);
  bodies.motion.push_back(motion);
  bodies.materials = {"ice"};
  bodies.material.push_back(0);
  bodies.shape.push_back(std::make_shared<const geometry::Shape>(shape));
  bodies.mass.push_back(mass);
  bodies.inertia_B.emplace_back(Mat3::Identity());
  bodies.inertia_inverse_B.emplace_back(Mat3::Identity());
  bodies.p_GB.push_back(p);
  bodies.q_GB.emplace_back(Quat::Identity());
  bodies.R_GB.emplace_back(Mat3::Identity());
  bodies.v_GB.emplace_back(Vec3::Zero());
  bodies.w_GB.emplace_back(Vec3::Zero());
}

/// Prism over a triangle of 1 m legs.
inline geometry::Shape triangle_floe() {
  geometry::Shape shape;
  shape.kind = geometry::ShapeKind::prism;
  shape.outline = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
  shape.thickness = 0.2;
  return shape;
}

/// Tetrahedron of 1 m legs.
inline geometry::Shape tetrahedron() {
  geometry::Shape shape;
  shape.kind = geometry::ShapeKind::mesh;
  shape.surface.vertices = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
  shape.surface.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return shape;
}

/// A free floe, a fixed floe, a hull and a plane.
inline bodies::Bodies sample_bodies() {
  bodies::Bodies bodies;
  add_body(bodies, "floe-1", bodies::BodyKind::floe, bodies::Motion::free, triangle_floe(), 10, Vec3(1, 2, 0));
  add_body(bodies, "floe-2", bodies::BodyKind::floe, bodies::Motion::fixed, triangle_floe(), 20, Vec3(4, 5, 0));
  add_body(bodies, "hull", bodies::BodyKind::vessel, bodies::Motion::articulated, tetrahedron(), 1500,
           Vec3(-3, 0, 0.5));
  geometry::Shape plane;
  plane.kind = geometry::ShapeKind::plane;
  add_body(bodies, "wall,\"north\"", bodies::BodyKind::wall, bodies::Motion::fixed, plane, 0, Vec3(0, 9, 0));
  bodies.v_GB[0] = Vec3(0.3, 0.4, 0);
  return bodies;
}

}  // namespace nilas::test
