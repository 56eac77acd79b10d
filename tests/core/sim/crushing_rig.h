#pragma once
/// Hulls of closed form driven into sheets.
#include <algorithm>
#include <string>
#include <vector>

#include "tests/core/sim/scene_rig.h"
#include "tests/core/sim/stl_text.h"

namespace nilas::test {

inline constexpr double k_strength = 1e5, k_thickness = 0.25;

/// Its edge at x = 0 at mid height, opening to x = -2 at half angle atan 1/2; the sides lean out by `lean` of the trace
/// per height, and the edge by twice that.
inline std::string wedge(double lean) {
  std::vector<Vec3> vertices;
  for (const double z : {-1.0, 1.0})
    vertices.insert(vertices.end(), {Vec3(2 * lean * z, 0, z), Vec3(-2, 1 + lean * z, z), Vec3(-2, -1 - lean * z, z)});
  return stl(vertices, {{1, 4, 3, 0}, {3, 5, 2, 0}, {2, 1, 0}, {4, 5, 3}, {2, 5, 4, 1}});
}

/// Its tip at x = 0 and the square of side 2 that it opens to at x = -2.
inline std::string pyramid() {
  return stl({Vec3(0, 0, 0), Vec3(-2, 1, 1), Vec3(-2, -1, 1), Vec3(-2, -1, -1), Vec3(-2, 1, -1)},
             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {4, 3, 2, 1}});
}

/// An upright pile of square section, 0.6 m wide, its front at x = 0.
inline std::string pile() {
  std::vector<Vec3> vertices;
  for (const double z : {-1.0, 1.0})
    vertices.insert(vertices.end(), {Vec3(0, -0.3, z), Vec3(0, 0.3, z), Vec3(-0.6, 0.3, z), Vec3(-0.6, -0.3, z)});
  return stl(vertices, {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

inline std::string crushing(const std::string& model, double strength = k_strength) {
  return "<fracture compressive_strength='" + text(strength) + "'><crushing " + model + "/></fracture>";
}
inline const std::string k_seed = "model='explicit'", k_compliant = "model='compliant'";

/// Unless `contact` names another, the integrator is semi-implicit Euler: sums over its steps have closed forms.
struct Rig : SceneRig {
  Rig(const std::string& content, double step, int threads = 1, const std::string& contact = "", double friction = 0,
      const Vec3& gravity = Vec3::Zero())
      : SceneRig(
            "<time step='" + text(step) + "' end='1000'/><gravity value='" + text(gravity.x()) + " " +
                text(gravity.y()) + " " + text(gravity.z()) +
                "'/><contact solver='auto' tolerance='1e-12' max_iterations='10000' " + by_euler(contact) +
                "><friction between='* *' static='" + text(friction) + "'/></contact>" + content,
            threads,
            {{"wedge.stl", wedge(0)},
             {"flared.stl", wedge(0.25)},
             {"pyramid.stl", pyramid()},
             {"pile.stl", pile()},
             {"track.csv", "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.2,0.1,0,0\n0.4,0.2,0,0\n0.8,0.1,0,0\n1.6,0.5,0,0\n"}}) {}

  static std::string by_euler(const std::string& contact) {
    return contact.find("integrator") == std::string::npos ? contact + " integrator='semi-implicit-euler'" : contact;
  }

  sim::StepRecord step() { return simulation.step(); }
  /// Largest x of the surface of a body.
  double front(std::size_t b) const {
    double x = -1e300;
    for (const Vec3& v : bodies().shape[b]->surface.vertices)
      x = std::max(x, (bodies().p_GB[b] + bodies().R_GB[b] * v).x());
    return x;
  }
  /// Index of the only body that is not a floe.
  std::size_t hull() const {
    const auto found = std::find_if(bodies().kind.begin(), bodies().kind.end(),
                                    [](bodies::BodyKind k) { return k != bodies::BodyKind::floe; });
    return static_cast<std::size_t>(found - bodies().kind.begin());
  }
};

inline Vec2 turned(double angle_deg, double x, double y) {
  const double c = std::cos(angle_deg * k_deg), s = std::sin(angle_deg * k_deg);
  return {c * x - s * y, s * x + c * y};
}

inline std::string outline(double angle_deg, const std::vector<Vec2>& corners) {
  std::string s;
  for (const Vec2& x : corners) {
    const Vec2 p = turned(angle_deg, x.x(), x.y());
    s += text(p.x()) + " " + text(p.y()) + " ";
  }
  return s;
}

/// A vessel of the given mesh at speed 0.5 m/s along x, its tip at x0, towards a fixed breakable sheet from x = 0 on;
/// all turned about z.
inline std::string towed(const std::string& mesh, double x0, double angle_deg = 0, double y0 = 0) {
  const Vec2 start = turned(angle_deg, x0, y0);
  const std::string angle = text(angle_deg);
  return "<vessel hull='" + mesh + "' heading_deg='" + angle + "' position='" + text(start.x()) + " " +
         text(start.y()) + " 0'><mass value='1000'/><carriage speed='0.5' heading_deg='" + angle +
         "'/></vessel><ice thickness='" + text(k_thickness) + "'><floe fixed='true' breakable='true' outline='" +
         outline(angle_deg, {{0, -3}, {4, -3}, {4, 3}, {0, 3}}) + "'/></ice>";
}

}  // namespace nilas::test
