#include "core/sim/build/moored_vessel.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/vessel/mooring/mooring_module.h"
#include "hydro/wetted.h"

namespace nilas::sim {

namespace {

vessel::MooringLine line_with_ends(const scene::MooringLineScene& given, const Vec3& com) {
  vessel::MooringLine line;
  line.name = given.name;
  line.fairlead_B = given.fairlead - com;
  line.anchor = given.anchor;
  line.damping = given.damping;
  line.break_load = given.break_load;
  line.break_time = given.break_time;
  line.on_turret = given.turret;
  return line;
}

vessel::SpringLine spring_of(const scene::SpringLineScene& given, double scale) {
  if (!given.table.empty()) return vessel::tabulated_spring(given.length, given.table, scale);
  NILAS_DEMAND(given.stiffness.has_value());
  const double first = *given.stiffness;
  return vessel::bilinear_spring(given.length, first, given.knee.value_or(scale),
                                 given.second_stiffness.value_or(first));
}

vessel::MooringModel mooring_model(const scene::Scene& scene, const Vec3& com) {
  const scene::MooringScene& given = *scene.vessel->mooring;
  vessel::MooringModel model;
  const double level = scene.water ? scene.water->level : 0;
  if (given.depth)
    model.bed = level - *given.depth;
  else if (scene.tank && scene.tank->floor)
    model.bed = level - scene.tank->depth;
  if (given.turret) model.turret = vessel::Turret{given.turret->at - com, given.turret->friction};
  for (const scene::CatenaryScene& line : given.lines) {
    model.lines.push_back(line_with_ends(line, com));
    model.lines.back().form =
        vessel::CatenaryLine{line.length, line.weight, line.stiffness, line.bed_friction, line.diameter};
  }
  for (const scene::SpringLineScene& line : given.springs) {
    model.lines.push_back(line_with_ends(line, com));
    model.lines.back().form = spring_of(line, scene.scale);
  }
  return model;
}

Pose pose_of_B(const vessel::VesselModel& model) {
  return {model.pose_V.q, model.pose_V.p + model.pose_V.q * model.mass.com};
}

/// Where the fairlead of a line is at the start, in G.
Vec3 fairlead_of(const vessel::MooringModel& mooring, const vessel::MooringLine& line, double turret,
                 const Pose& pose) {
  if (!line.on_turret) return pose.p + pose.q * line.fairlead_B;
  const Vec3& centre = mooring.turret->at_B;
  return pose.p + pose.q * (centre + Eigen::AngleAxisd(turret, Vec3::UnitZ()) * Vec3(line.fairlead_B - centre));
}

/// Refuses lines that are far too short, or whose fairlead is below the bed.
class LineJudge {
 public:
  LineJudge(const scene::Scene& scene, const vessel::MooringModel& mooring) : scene_(scene), mooring_(mooring) {
    for (const auto& line : scene.vessel->mooring->lines) given_.push_back(&line);
    for (const auto& line : scene.vessel->mooring->springs) given_.push_back(&line);
  }

  void judge(const Pose& pose) const {
    // A turret finds its angle only with lines that can be computed, so lines on the hull and at angle 0 go first.
    for (std::size_t k = 0; k < given_.size(); ++k) judge_bed(k, fairlead_of(mooring_, mooring_.lines[k], 0, pose));
    const double turret = vessel::initial_mooring(mooring_, pose).turret_angle;
    for (std::size_t k = 0; k < given_.size(); ++k)
      judge_stretch(k, fairlead_of(mooring_, mooring_.lines[k], turret, pose));
  }

 private:
  [[noreturn]] void refuse(std::size_t k, const std::string& message) const {
    const std::string line = given_[k]->line > 0 ? std::to_string(given_[k]->line) + ":" : "";
    const bool catenary = k < scene_.vessel->mooring->lines.size();
    throw InputError(fmt::format("{}:{} <{} name='{}'>: {}", scene_.file.string(), line,
                                 catenary ? "line" : "spring_line", given_[k]->name, message));
  }
  void judge_bed(std::size_t k, const Vec3& fairlead) const {
    const std::optional<double> resting = vessel::axis_on_bed(mooring_.lines[k], mooring_.bed);
    if (!resting || fairlead.z() >= *resting) return;
    const char* what = *resting > *mooring_.bed ? "the axis of a line on the sea bed" : "the sea bed";
    refuse(k, fmt::format("the fairlead is at the height {:.4g} m at the start, below {} at {:.4g} m", fairlead.z(),
                          what, *resting));
  }
  void judge_stretch(std::size_t k, const Vec3& fairlead) const {
    constexpr double k_most_strain = 0.05, k_percent = 100;  // chains and wires break at 1 to 2 %
    const vessel::MooringLine& line = mooring_.lines[k];
    const vessel::LineForce force = vessel::line_force(line, mooring_.bed, fairlead);
    const double distance = (fairlead - line.anchor).norm(), length = given_[k]->length;
    std::string found = fmt::format("the tension at the start is {:.4g} N, a strain of {:.3g} %", force.tension(),
                                    k_percent * force.strain);
    if (length < distance)
      found = fmt::format("its {:g} m are shorter than the {:.4g} m between fairlead and anchor; {}", length, distance,
                          found);
    if (line.break_load && force.tension() >= *line.break_load)
      refuse(k, fmt::format("{}; allowed: less than its break load of {:.4g} N", found, *line.break_load));
    if (!line.break_load && std::holds_alternative<vessel::CatenaryLine>(line.form) && force.strain > k_most_strain)
      refuse(k, fmt::format("{}; allowed: at most {:g} %, or a break_load that is greater", found,
                            k_percent * k_most_strain));
  }

  const scene::Scene& scene_;
  const vessel::MooringModel& mooring_;
  std::vector<const scene::MooringLineScene*> given_;  ///< in the order of the model's lines
};

/// Search for the pose at which weight, buoyancy and lines balance.
class MooredRest {
 public:
  MooredRest(const scene::Scene& scene, const geometry::TriangleMesh& fluid, const vessel::VesselModel& model,
             const WorldParts& parts)
      : fluid_(fluid), mass_(model.mass), mooring_(*parts.mooring), weight_(model.mass.mass * scene.gravity) {
    if (scene.hydro && scene.hydro->buoyancy && parts.water) water_ = &*parts.water;
    for (const Vec3& p : fluid.vertices) length_ = std::max(length_, (p - mass_.com).norm());
    if (water_)
      motions_ = {0, 1, 2, 3, 4, 5};
    else
      motions_ = {0, 1, 5};
  }

  /// The pose of frame B at rest; empty where the search finds none.
  std::optional<Pose> find(Pose pose) {
    constexpr int k_most_steps = 100, k_most_halvings = 30;
    constexpr double k_tolerance = 1e-10, k_longest = 0.1;
    const vessel::MooringLoads start = loads(pose);
    force_ = std::accumulate(start.tensions.begin(), start.tensions.end(), water_ ? weight_.norm() : 0);
    if (!(force_ > 0)) return pose;
    VecX error = residual(pose);  // of the start, which must be one that can be computed
    for (int step = 0; step < k_most_steps && error.norm() > k_tolerance; ++step) {
      VecX way = direction(pose, error);
      if (way.norm() > k_longest) way *= k_longest / way.norm();
      bool better = false;
      for (int halving = 0; halving < k_most_halvings && !better; ++halving, way *= 0.5) {
        const Pose next = moved(pose, way);
        const std::optional<VecX> left = residual_if_any(next);
        better = left && left->norm() < error.norm();
        if (!better) continue;
        pose = next;
        error = *left;
      }
      if (!better) break;
    }
    // Rounding of large forces can end the search above its tolerance.
    constexpr double k_accepted = 1e-7;
    return error.norm() <= k_accepted ? std::optional(pose) : std::nullopt;
  }

 private:
  vessel::MooringLoads loads(const Pose& pose) const {
    return vessel::mooring_loads(mooring_, vessel::initial_mooring(mooring_, pose), {pose});
  }
  Pose moved(const Pose& pose, const VecX& way) const {
    Pose at = pose;
    Vec3 turn = Vec3::Zero();
    for (std::size_t k = 0; k < motions_.size(); ++k) {
      const double x = way[static_cast<Eigen::Index>(k)];
      if (motions_[k] < 3)
        at.p[motions_[k]] += length_ * x;
      else
        turn[motions_[k] - 3] = x;
    }
    if (turn.norm() > 0) at.q = (Eigen::AngleAxisd(turn.norm(), turn.normalized()) * pose.q).normalized();
    return at;
  }
  /// Unbalanced loads as shares of weight and tensions.
  VecX residual(const Pose& pose) const {
    Wrench sum = loads(pose).on_hull;
    if (water_) {
      const Mat3 R = pose.q.toRotationMatrix();
      const hydro::Submerged wet = hydro::submerged_mesh(fluid_, R, pose.p - R * mass_.com, water_->level);
      const Vec3 lift(0, 0, water_->density * water_->gravity * wet.volume);
      sum += {lift + weight_, (wet.centre - pose.p).cross(lift)};
    }
    Vec6 all;
    all << sum.force / force_, sum.torque / (force_ * length_);
    return all(motions_);
  }
  /// Nothing where the loads cannot be computed, such as with a fairlead below the bed: that pose lies too far.
  std::optional<VecX> residual_if_any(const Pose& pose) const {
    try {
      return residual(pose);
    } catch (const SimulationError&) {
      return std::nullopt;
    }
  }
  /// Newton's step, the shortest where a motion has no stiffness.
  VecX direction(const Pose& pose, const VecX& error) const {
    constexpr double k_difference = 1e-6, k_no_stiffness = 1e-8;
    const auto n = static_cast<Eigen::Index>(motions_.size());
    MatX slopes(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const VecX step = k_difference * VecX::Unit(n, k);
      // At the edge of what can be computed the difference is one-sided.
      const std::optional<VecX> ahead = residual_if_any(moved(pose, step)),
                                behind = residual_if_any(moved(pose, -step));
      if (ahead && behind)
        slopes.col(k) = (*ahead - *behind) / (2 * k_difference);
      else
        slopes.col(k) = ((ahead ? *ahead : error) - (ahead ? error : residual(moved(pose, -step)))) / k_difference;
    }
    Eigen::CompleteOrthogonalDecomposition<MatX> solver;
    solver.setThreshold(k_no_stiffness);
    solver.compute(slopes);
    return -solver.solve(error);
  }

  const geometry::TriangleMesh& fluid_;
  const geometry::MassProperties& mass_;
  const vessel::MooringModel& mooring_;
  Vec3 weight_;
  const hydro::Water* water_ = nullptr;  ///< null where nothing is buoyant
  double length_ = 0, force_ = 0;
  std::vector<int> motions_;  ///< those that are sought: 0 to 2 translations, 3 to 5 rotations
};

}  // namespace

void moor_vessel(const scene::Scene& scene, const geometry::TriangleMesh& fluid, vessel::VesselModel& model,
                 WorldParts& parts) {
  if (!scene.vessel->mooring || scene.vessel->mooring->model == MooringKind::moordyn) return;
  parts.mooring = mooring_model(scene, model.mass.com);
  const LineJudge lines(scene, *parts.mooring);
  lines.judge(pose_of_B(model));
  if (scene.vessel->mooring->start == MooringStart::as_placed || model.is_jointed()) return;
  std::optional<Pose> rest;
  std::string cause;
  try {
    rest = MooredRest(scene, fluid, model, parts).find(pose_of_B(model));
  } catch (const SimulationError& error) {
    cause = std::string(": ") + error.what();
  }
  if (!rest)
    throw InputError(
        fmt::format("{}: <vessel name='{}'>: there is no static equilibrium to start from{}; "
                    "<mooring start=\"as-placed\"> starts without",
                    scene.file.string(), scene.vessel->name, cause));
  model.pose_V.q = rest->q;
  model.pose_V.p = rest->p - rest->q * model.mass.com;
  lines.judge(*rest);
}

MooringAtStart mooring_at_start(const WorldParts& parts) {
  const auto hull = static_cast<std::size_t>(parts.vessel_index);
  const Pose pose{parts.bodies.q_GB[hull], parts.bodies.p_GB[hull]};
  const vessel::MooringState state = vessel::initial_mooring(*parts.mooring, pose);
  const Mat6 K = vessel::mooring_stiffness(*parts.mooring, state, pose);
  return {vessel::mooring_loads(*parts.mooring, state, {pose}), 0.5 * (K + K.transpose()),
          vessel::mooring_damping(*parts.mooring, state, pose)};
}

std::string mooring_reason(const WorldParts& parts) {
  const MooringAtStart start = mooring_at_start(parts);
  const auto [least, most] = std::minmax_element(start.loads.tensions.begin(), start.loads.tensions.end());
  const Vec3& f = start.loads.on_hull.force;
  return fmt::format(
      "<vessel><mooring>: {} lines; at the start tensions of {:.3g} to {:.3g} N, a load of {:.3g} {:.3g} {:.3g} N, and "
      "a stiffness along X, Y, Z of {:.3g} {:.3g} {:.3g} N/m, about Z of {:.3g} N m/rad",
      start.loads.tensions.size(), *least, *most, f.x(), f.y(), f.z(), start.stiffness(0, 0), start.stiffness(1, 1),
      start.stiffness(2, 2), start.stiffness(5, 5));
}

}  // namespace nilas::sim
