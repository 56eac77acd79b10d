#include "hydro/radiation/radiation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "hydro/radiation/memory_force.h"
#include "hydro/radiation/passivity.h"

namespace nilas::hydro {

namespace {

double yaw_of(const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); }
Mat3 about_z(double yaw) { return Eigen::AngleAxisd(yaw, Vec3::UnitZ()).toRotationMatrix(); }

Vec6 modes_of(const Mat3& R_GD, const Vec3& v, const Vec3& w) {
  Vec6 modes;
  modes << R_GD.transpose() * v, R_GD.transpose() * w;
  return modes;
}

class Radiation : public bodies::ForceModule {
 public:
  Radiation(std::unique_ptr<MemoryForce> memory, const RadiatingBody& body) : memory_(std::move(memory)), body_(body) {
    memory_->advance(body.start, velocity(body.attitude, body.velocity, body.angular_velocity));
  }
  std::string name() const override { return "radiation"; }
  bodies::VesselLoad load_on_vessel() const override { return bodies::VesselLoad::water; }

  void add_forces(const bodies::Bodies& bodies, double t, bodies::Wrenches& out) override {
    const auto b = static_cast<std::size_t>(body_.body);
    const Mat3 R_GD = axes(bodies.R_GB[b]);
    const Vec6 load = memory_->load(t, velocity(bodies));
    const Vec3 force = R_GD * load.head<3>(), moment = R_GD * load.tail<3>();
    out[b] += Wrench{force, moment + (bodies.R_GB[b] * body_.origin_B).cross(force)};
  }

  void end_substep(const bodies::Bodies& bodies, double t, double /*h*/) override {
    memory_->advance(t, velocity(bodies));
  }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override { memory_->save(out); }
  void restore(const StateReader& in) override { memory_->restore(in); }

 private:
  Vec6 velocity(const bodies::Bodies& bodies) const {
    const auto b = static_cast<std::size_t>(body_.body);
    return velocity(bodies.R_GB[b], bodies.v_GB[b], bodies.w_GB[b]);
  }
  Vec6 velocity(const Mat3& R_GB, const Vec3& v, const Vec3& w) const {
    return modes_of(axes(R_GB), v + w.cross(R_GB * body_.origin_B) - body_.current, w);
  }
  Mat3 axes(const Mat3& R_GB) const { return about_z(yaw_of(R_GB) + body_.rotation); }

  std::unique_ptr<MemoryForce> memory_;
  RadiatingBody body_;
};

/// The rigid-body mass about the origin of D, in its axes.
Mat6 mass_about_origin(const RadiatingBody& body) {
  Mat6 to_com = Mat6::Identity(), turn = Mat6::Zero();
  to_com.topRightCorner<3, 3>() = skew(body.origin_B);
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = about_z(body.rotation);
  return turn.transpose() * to_com.transpose() * body.mass_B * to_com * turn;
}

/// Over a step the memory acts as a spring of stiffness K(0) on the newest motion.
void demand_short_step(const RadiatingBody& body, const Mat6& added_mass, const Retardation& kernel) {
  const Mat6 spring = 0.5 * (kernel.K.front() + kernel.K.front().transpose());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> solver(spring, mass_about_origin(body) + added_mass,
                                                              Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
  const double most = solver.eigenvalues().maxCoeff();
  if (most * body.step * body.step > 1)
    throw InputError(
        fmt::format("the step of {:.4g} s is too long for the radiation of a body of this mass; allowed: "
                    "up to {:.3g} s",
                    body.step, 1 / std::sqrt(most)));
}

/// The margin of the passivity test, as a share of the peaks of damping; the damping itself falls to zero at zero and
/// infinite frequency.
constexpr double k_passivity_margin = 1e-6;

struct FittedMemory {
  std::unique_ptr<MemoryForce> memory;
  std::string description;
};

FittedMemory fitted(const RadiationDamping& damping, const Retardation& kernel, const RadiationSettings& settings) {
  const RadiationSamples samples = radiation_samples(damping, kernel);
  std::vector<PassiveFit> fits;
  std::string orders;
  double worst = 0;
  for (const auto& modes : damping.groups) {
    const PassiveFit& fit = fits.emplace_back(chosen_fit(samples, modes, settings.error, settings.order));
    if (!is_passive(fit.model, k_passivity_margin))
      throw InputError(
          fmt::format("the state space of order {} is not passive by the test of its Hamiltonian matrix; "
                      "allowed: another order, or the convolution",
                      fit.model.poles.count()));
    orders += (orders.empty() ? "" : " + ") + std::to_string(fit.model.poles.count());
    worst = std::max(worst, fit.error);
  }
  return {make_state_space(fits, damping.scale),
          fmt::format("state space of {} poles, error {:.2g} %, passive", orders, 1e2 * worst)};
}

}  // namespace

BuiltRadiation make_radiation(const Database& database, const RadiationSettings& settings, const RadiatingBody& body) {
  const RadiationDamping damping = prepare_damping(database, settings.highest_frequency);
  const Retardation kernel = retardation(damping, settings.memory);
  const InfiniteAddedMass added_mass = infinite_added_mass(database, damping, kernel);
  demand_short_step(body, added_mass.value, kernel);
  FittedMemory memory;
  if (settings.model == RadiationModel::state_space)
    memory = fitted(damping, kernel, settings);
  else
    memory = {make_convolution(kernel), fmt::format("convolution over {:.3g} s, {:.2g} % of the retardation function "
                                                    "beyond it",
                                                    kernel.memory, 1e2 * kernel.left)};
  BuiltRadiation built;
  built.module = std::make_unique<Radiation>(std::move(memory.memory), body);
  built.description = fmt::format("{}; added mass of the database within {:.2g} % of Ogilvie's (root mean square)",
                                  memory.description, 1e2 * added_mass.root_mean_square);
  for (const std::string& note : damping.report.notes) built.notes.push_back(database.source + ": " + note);
  constexpr double k_doubtful_share = 0.01;
  if (kernel.unresolved > k_doubtful_share)
    built.notes.push_back(
        fmt::format("{}: The spacing of the frequencies resolves a memory of {:.3g} s; {:.2g} % of the "
                    "retardation function lies beyond it and is that of a spline.",
                    database.source, damping.longest_memory, 1e2 * kernel.unresolved));
  if (!added_mass.from_file)
    built.notes.push_back(
        fmt::format("{}: The file has no added mass at infinite frequency; it follows from Ogilvie's "
                    "relation, with a scatter of {:.3g} kg in heave.",
                    database.source, added_mass.scatter(2, 2)));
  return built;
}

}  // namespace nilas::hydro
