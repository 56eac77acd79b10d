#include "core/sim/build/natural_periods.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/sim/build/moored_vessel.h"
#include "core/vessel/model/cells.h"
#include "hydro/restoring/restoring.h"
#include "hydro/wetted.h"

namespace nilas::sim {

namespace {

/// Mass matrix, with the water that moves with the hull. All matrices of this file refer to small motions (translation;
/// rotation) of the centre of mass, in G.
Mat6 mass_matrix(const WorldParts& parts) {
  const bodies::Bodies& bodies = parts.bodies;
  const int vessel = parts.vessel_index;
  Mat6 M = Mat6::Zero();
  M.topLeftCorner<3, 3>() = bodies.mass[vessel] * Mat3::Identity();
  M.bottomRightCorner<3, 3>() = bodies.inertia_G(vessel);
  if (parts.hull_water) M += bodies::turned(parts.hull_water->added_B, bodies.R_GB[vessel]);
  return M;
}

/// Hydrostatic stiffness in heave, roll and pitch (Newman, Marine Hydrodynamics, 6.16), including the vessel's weight,
/// which acts at the centre of mass.
Mat6 water_stiffness(const scene::Scene& scene, const WorldParts& parts) {
  Mat6 K = Mat6::Zero();
  if (scene.hydro && scene.hydro->restoring) {
    const Vec3 com = parts.vessel_model->mass.com;
    const hydro::Database& database = *parts.database->values;
    const Pose& in_V = parts.database->in_V;
    const Mat6 restoring = hydro::restoring_with_weight_at(database, parts.water->density * parts.water->gravity,
                                                           parts.vessel_model->mass.mass * parts.water->gravity,
                                                           in_V.q.conjugate() * (com - in_V.p));
    return bodies::turned(parts.database->about(restoring, com), parts.bodies.R_GB[parts.vessel_index]);
  }
  if (!parts.water || !scene.hydro || !scene.hydro->buoyancy) return K;
  const auto b = static_cast<std::size_t>(parts.vessel_index);
  const geometry::TriangleMesh& mesh = parts.bodies.shape[b]->surface;
  const Mat3& R = parts.bodies.R_GB[b];
  const Vec3& p = parts.bodies.p_GB[b];
  const hydro::Waterplane cut = hydro::waterplane(mesh, R, p, parts.water->level);
  const hydro::Submerged wet = hydro::submerged_mesh(mesh, R, p, parts.water->level);
  const double weight = parts.water->density * parts.water->gravity;
  const Vec2 arm = cut.centroid - p.head<2>();
  const double lift = wet.volume * (wet.centre.z() - p.z());
  K(2, 2) = cut.area;
  K(2, 3) = K(3, 2) = cut.area * arm.y();
  K(2, 4) = K(4, 2) = -cut.area * arm.x();
  K(3, 3) = cut.yy + cut.area * arm.y() * arm.y() + lift;
  K(4, 4) = cut.xx + cut.area * arm.x() * arm.x() + lift;
  K(3, 4) = K(4, 3) = -(cut.xy + cut.area * arm.x() * arm.y());
  return weight * K;
}

/// Matrix from a small motion of the centre of mass to (rotation; translation) of the joint in the carriage's frame.
Mat6 joint_motion(const vessel::CarriageModel& carriage, const WorldParts& parts, double t0) {
  const vessel::CarriageMotion::State start = carriage.motion.at(t0);
  const Mat3 to_carriage = Eigen::AngleAxisd(-start.yaw, Vec3::UnitZ()).toRotationMatrix();
  const Vec3 arm = start.p - parts.bodies.p_GB[parts.vessel_index];
  Mat3 cross;
  cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  Mat6 T = Mat6::Zero();
  T.topRightCorner<3, 3>() = to_carriage;
  T.bottomLeftCorner<3, 3>() = to_carriage;
  T.bottomRightCorner<3, 3>() = -to_carriage * cross;
  return T;
}

/// Entries of (rotation; translation) along which the joint is free.
std::vector<int> free_entries(const vessel::CarriageModel& carriage) {
  if (carriage.balance == BalanceKind::prismatic) return {5};
  static constexpr std::array<int, 6> k_entries{3, 4, 5, 0, 1, 2};  // indices of surge, sway, heave, roll, pitch, yaw
  std::vector<int> entries;
  for (std::size_t k = 0; k < carriage.free.size(); ++k)
    if (carriage.free.at(k)) entries.push_back(k_entries.at(k));
  return entries;
}

std::string motion_name(const Vec6& mode, const Mat6& M) {
  static constexpr std::array<const char*, 6> k_names{"surge", "sway", "heave", "roll", "pitch", "yaw"};
  Eigen::Index largest = 0;
  (mode.cwiseAbs2().cwiseProduct(M.diagonal())).maxCoeff(&largest);
  return k_names.at(static_cast<std::size_t>(largest));
}

}  // namespace

std::string NaturalPeriod::held_by() const {
  if (on_cells) return "the load cells";
  return on_mooring ? "the mooring" : "the water";
}

std::vector<NaturalPeriod> natural_periods(const scene::Scene& scene, const WorldParts& parts) {
  if (!scene.vessel || scene.vessel->fixed || parts.is_jointed()) return {};
  const Mat6 M = mass_matrix(parts), water = water_stiffness(scene, parts);
  Mat6 cells = Mat6::Zero();
  MatX basis = Mat6::Identity();
  if (parts.carriage) {
    const vessel::CarriageModel& carriage = *parts.carriage;
    const Mat6 T = joint_motion(carriage, parts, scene.time.start);
    const std::vector<int> free = free_entries(carriage);
    if (carriage.balance == BalanceKind::six_cells)
      cells = T.transpose() *
              vessel::condensed_stiffness(vessel::cell_wrenches(carriage.cells), carriage.stiffness, free) * T;
    else
      basis = T.inverse()(Eigen::all, free);
  }
  if (basis.cols() == 0) return {};
  // Modes are named along the vessel's own axes.
  Mat6 axes = Mat6::Zero();
  const Mat3& R = parts.bodies.R_GB[parts.vessel_index];
  axes.topLeftCorner<3, 3>() = axes.bottomRightCorner<3, 3>() = R.transpose();
  const Mat6 lines = parts.mooring ? mooring_at_start(parts).stiffness : Mat6::Zero();
  const MatX K = basis.transpose() * (cells + water + lines) * basis, mass = basis.transpose() * M * basis;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatX> modes(K, mass);
  constexpr double k_held = 1e-9;  // share of the stiffest mode; below it the stiffness is rounding
  const double least = k_held * modes.eigenvalues().cwiseAbs().maxCoeff();
  std::vector<NaturalPeriod> periods;
  for (Eigen::Index k = modes.eigenvalues().size() - 1; k >= 0; --k) {
    const double square = modes.eigenvalues()[k];
    if (!(square > least)) continue;
    const Vec6 mode = basis * modes.eigenvectors().col(k);
    const double by_water = mode.dot(water * mode), by_lines = mode.dot(lines * mode);
    periods.push_back({motion_name(axes * mode, axes * M * axes.transpose()), mode.dot(cells * mode) > by_water,
                       by_lines > by_water, 2 * k_pi / std::sqrt(square)});
  }
  return periods;
}

double mooring_damping_rate(const WorldParts& parts) {
  if (!parts.mooring) return 0;
  const Mat6 M = mass_matrix(parts), damping = mooring_at_start(parts).damping;
  return Eigen::GeneralizedSelfAdjointEigenSolver<Mat6>(damping, M, Eigen::EigenvaluesOnly | Eigen::Ax_lBx)
      .eigenvalues()
      .maxCoeff();
}

double floe_heave_period(const scene::Scene& scene, const WorldParts& parts) {
  if (!parts.water || !scene.hydro || !scene.hydro->buoyancy || !(parts.info.ice_thickness > 0)) return 0;
  return 2 * k_pi *
         std::sqrt(scene.ice->density * parts.info.ice_thickness / (parts.water->density * parts.water->gravity));
}

}  // namespace nilas::sim
