#pragma once
/// A scene that is its own image in the plane y = 0: finds the image of each body, and the stage of a step in which the
/// two sides first differ.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/sim/simulation.h"
#include "tests/support/mirrored.h"

namespace nilas::test {

/// Differences between the two sides of one step, stage by stage. Each is zero where every bit is the mirrored one.
struct StepAsymmetry {
  double loads = 0;      ///< Momenta of the motion without contact, of bodies that touch [N s, N m s].
  bool contacts = true;  ///< Points, normals, gaps and pairs are images of each other to the last bit.
  double impulses = 0;   ///< Impulses of contacts that are images of each other [N s]; 0 unless `contacts`.
  double poses = 0;      ///< Positions of centres at the step's end [m].
  double attitudes = 0;  ///< Largest difference between entries of the rotation matrices.
  double velocities = 0;

  bool none() const {
    return loads == 0 && contacts && impulses == 0 && poses == 0 && attitudes == 0 && velocities == 0;
  }
  /// The first stage of the step whose two sides differ; empty where none does.
  std::string first_stage() const {
    if (loads != 0) return "loads";
    if (!contacts) return "contacts";
    if (impulses != 0) return "impulses";
    if (velocities != 0) return "velocities";
    return poses != 0 || attitudes != 0 ? "poses" : "";
  }
};

class MirrorImages {
 public:
  /// Finds the image of each body from the initial poses, to within `near` [m]. paired() is false when a body has none.
  explicit MirrorImages(const bodies::Bodies& bodies, double near = 1e-9) : image_(bodies.p_GB.size(), -1) {
    for (int a = 0; a < bodies.size(); ++a)
      for (int b = 0; b < bodies.size(); ++b)
        if (bodies.kind[a] == bodies.kind[b] && bodies.motion[a] == bodies.motion[b] &&
            (bodies.p_GB[a] - mirrored(bodies.p_GB[b])).norm() <= near)
          image_[a] = b;
  }

  bool paired() const { return std::find(image_.begin(), image_.end(), -1) == image_.end(); }
  int image(int body) const { return image_[body]; }

  /// Whether every body has the mirrored surface, convex pieces, mass and inertia of its image, to the last bit.
  bool built_as_images(const bodies::Bodies& bodies) const {
    for (int b = 0; b < bodies.size(); ++b) {
      const std::size_t i = b, k = image(b);
      const Vec3 signs(1, -1, 1);
      const Mat3 inertia = signs.asDiagonal() * bodies.inertia_B[k] * signs.asDiagonal();
      const bool moves = bodies.motion[i] != bodies::Motion::fixed;
      if (moves && (bodies.mass[i] != bodies.mass[k] || bodies.inertia_B[i] != inertia)) return false;
      if (corners(*bodies.shape[i], 1) != corners(*bodies.shape[k], -1)) return false;
    }
    return true;
  }

  /// The asymmetry of the present state and of the contacts of the last step.
  StepAsymmetry measure(const sim::Simulation& simulation) const {
    StepAsymmetry found;
    const bodies::Bodies& bodies = simulation.bodies();
    for (int b = 0; b < bodies.size(); ++b) {
      const std::size_t i = b, k = image(b);
      const auto raise = [](double& worst, double difference) { worst = std::max(worst, difference); };
      raise(found.poses, (bodies.p_GB[i] - mirrored(bodies.p_GB[k])).norm());
      const Mat3 turned = Vec3(1, -1, 1).asDiagonal() * bodies.R_GB[k] * Vec3(1, -1, 1).asDiagonal();
      if (bodies.motion[i] == bodies::Motion::free)
        raise(found.attitudes, (bodies.R_GB[i] - turned).cwiseAbs().maxCoeff());
      raise(found.velocities, (bodies.v_GB[i] - mirrored(bodies.v_GB[k])).norm());
      raise(found.velocities, (bodies.w_GB[i] - mirrored_axial(bodies.w_GB[k])).norm());
    }
    const contact::SolvedProblem& last = simulation.last_problem();
    found.loads = load_difference(last);
    compare_contacts(last, found);
    return found;
  }

 private:
  /// A contact: a, b, p, n and gap identify it in both halves of the scene.
  struct Touch {
    std::array<double, 9> what;
    Vec3 impulse;
  };

  /// The vertices of the surface and of all convex pieces, sorted. Their y is multiplied by `sign`.
  static std::vector<std::array<double, 3>> corners(const geometry::Shape& shape, double sign) {
    std::vector<std::array<double, 3>> all;
    const auto add = [&](const std::vector<Vec3>& vertices) {
      for (const Vec3& x : vertices) all.push_back({x.x(), sign * x.y(), x.z()});
    };
    add(shape.surface.vertices);
    for (const geometry::ConvexPolytope& part : shape.parts) add(part.vertices);
    std::sort(all.begin(), all.end());
    return all;
  }

  double load_difference(const contact::SolvedProblem& last) const {
    const contact::ContactProblem& problem = last.problem;
    std::vector<int> block(image_.size(), -1);
    for (std::size_t c = 0; c < last.points.size(); ++c) {
      block[last.points[c].a] = problem.pairs[c].a;
      block[last.points[c].b] = problem.pairs[c].b;
    }
    double worst = 0;
    for (std::size_t b = 0; b < image_.size(); ++b) {
      const int own = block[b], other = block[image_[b]];
      if (own < 0 || other < 0 || problem.block_size(own) != 6) continue;
      const auto f = problem.f.segment<6>(problem.block_offset[own]);
      const auto g = problem.f.segment<6>(problem.block_offset[other]);
      worst = std::max(worst, (Vec3(f.head<3>()) - mirrored(g.head<3>())).norm());
      worst = std::max(worst, (Vec3(f.tail<3>()) - mirrored_axial(g.tail<3>())).norm());
    }
    return worst;
  }

  std::vector<Touch> touches(const contact::SolvedProblem& last, bool in_the_mirror) const {
    std::vector<Touch> all;
    for (std::size_t c = 0; c < last.points.size(); ++c) {
      const detect::ContactPoint& point = last.points[c];
      int a = point.a, b = point.b;
      Vec3 p = point.p, n = point.n, impulse = last.impulses[c];
      if (in_the_mirror) {
        a = image(a), b = image(b);
        p = mirrored(p), n = mirrored(n), impulse = mirrored(impulse);
      }
      if (a > b) {
        std::swap(a, b);
        n = -n, impulse = -impulse;
      }
      all.push_back({{double(a), double(b), p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), point.gap}, impulse});
    }
    std::sort(all.begin(), all.end(), [](const Touch& p, const Touch& q) { return p.what < q.what; });
    return all;
  }

  void compare_contacts(const contact::SolvedProblem& last, StepAsymmetry& found) const {
    const std::vector<Touch> own = touches(last, false), images = touches(last, true);
    for (std::size_t c = 0; c < own.size(); ++c) found.contacts = found.contacts && own[c].what == images[c].what;
    if (!found.contacts) return;
    for (std::size_t c = 0; c < own.size(); ++c)
      found.impulses = std::max(found.impulses, (own[c].impulse - images[c].impulse).norm());
  }

  std::vector<int> image_;
};

}  // namespace nilas::test
