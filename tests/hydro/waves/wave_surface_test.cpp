#include "hydro/waves/wave_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/geometry/shape.h"
#include "hydro/modules.h"
#include "hydro/waves/even_surface.h"
#include "tests/hydro/solids.h"

namespace wave_surface_test {

using namespace nilas;
using namespace nilas::hydro;

/// A box of L x B x D whose bottom is at the depth T, in deep water with the wave number k of its length 2 pi / k.
constexpr double k_length = 4, k_beam = 1.5, k_height = 1, k_draught = 0.6;

Water sea() {
  Water water;
  water.density = 1000;
  water.gravity = 9.81;
  return water;
}

WaveField wave_along_x(double height, double period, double level = 0) {
  WaveTrain train;
  train.height = height;
  train.period = period;
  return {{train}, sea().gravity, level, 0, 1};
}

/// Amplitudes of surge, heave and pitch about the middle of the waterplane, per metre. The pressures
/// rho g e^(kz) cos(wt - kx) over ends, bottom and sides give, with s = sin(kL/2):
///   heave  rho g B e^(-kT) 2 s / k                 in phase with the wave at the middle, Re X
///   surge  rho g B 2 s (1 - e^(-kT)) / k           a quarter period ahead, Im X
///   pitch  rho g B (e^(-kT) (2 s / k^2 - L cos(kL/2) / k) - 2 s (1 - e^(-kT) (1 + kT)) / k^2), Im X
struct BoxLoads {
  double surge, heave, pitch;
};
BoxLoads box_loads(double k) {
  const double weight = sea().density * sea().gravity * k_beam, s = std::sin(0.5 * k * k_length);
  const double fall = std::exp(-k * k_draught);
  return {weight * 2 * s * (1 - fall) / k, weight * fall * 2 * s / k,
          weight * (fall * (2 * s / (k * k) - k_length * std::cos(0.5 * k * k_length) / k) -
                    2 * s * (1 - fall * (1 + k * k_draught)) / (k * k))};
}

const Vec3 k_centre(0, 0, 0.5 * k_height - k_draught);

/// With eight edges per wave the sums agree with the integrals within 1e-3 of the largest load, with sixteen within
/// 2e-4: the rule for a triangle leaves an error of at least the third order.
TEST(WaveSurface, LinearLoadOnABoxIsTheClosedForm) {
  const geometry::Shape box = geometry::box_shape({k_length, k_beam, k_height});
  for (const double number : {0.2, 0.8, 1.5}) {
    const BoxLoads exact = box_loads(number);
    const double length = 2 * k_pi / number;
    double error = 0;
    for (const double edges : {8.0, 16.0}) {
      const ComplexVec6 x = WaveSurface(box.surface, length / edges)
                                .linear_load(Mat3::Identity(), k_centre, sea(), {1, 0}, number, k_deep_water);
      const double scale = std::max({exact.surge, exact.heave, exact.pitch});
      ComplexVec6 expected = ComplexVec6::Zero();
      expected[0] = {0, exact.surge};
      expected[2] = exact.heave;
      expected[4] = {0, exact.pitch};
      const double now = (x - expected).norm() / scale;
      EXPECT_LT(now, edges > 8 ? 2e-4 : 1e-3) << number << " " << edges;
      if (edges > 8) {
        EXPECT_LT(now, error / 8);
      }
      error = now;
    }
  }
}

/// The load on the actual surface of a wave of 2e-6 m is the linear one, at any time, up to second order.
TEST(WaveSurface, LoadInSmallWavesIsTheClosedForm) {
  const geometry::Shape box = geometry::box_shape({k_length, k_beam, k_height});
  const WaveField field = wave_along_x(2e-6, 2.5, 0.3);
  const WaveComponent& wave = field.components().front();
  const BoxLoads exact = box_loads(wave.number);
  const WaveSurface surface(box.surface, field.shortest_length() / 16);
  Water water = sea();
  water.level = 0.3;
  const Vec3 p = k_centre + Vec3(0, 0, 0.3);
  for (double t = 0; t < 2.5; t += 0.4) {
    const double c = 1e-6 * std::cos(wave.frequency * t), s = 1e-6 * std::sin(wave.frequency * t);
    const Wrench load = surface.load(Mat3::Identity(), p, water, field, t);
    const double allowed = 1e-10 * std::max({exact.surge, exact.heave, exact.pitch});
    EXPECT_NEAR(load.force.x(), -exact.surge * s, allowed);
    EXPECT_NEAR(load.force.z(), exact.heave * c, allowed);
    EXPECT_NEAR(load.torque.y() + k_centre.z() * load.force.x(), -exact.pitch * s, allowed);
    EXPECT_NEAR(load.force.y(), 0, allowed);
  }
}

/// A wave of 4000 s is 25000 km long: over a floe it is a change of level, and Archimedes' law holds for the changed
/// level at any height, for any attitude of the floe, and while it rises out of the water. The slope of the surface is
/// below 1e-7, and the pressure falls by less than 1e-6 over the draught.
TEST(WaveSurface, LongWavesChangeTheLevel) {
  const WaveField field = wave_along_x(0.5, 4000);
  const geometry::Shape floe = geometry::prism_shape({{-1, -1}, {1, -1}, {1.2, 0.7}, {0, 1.3}, {-1, 1}}, 0.3);
  const WaveSurface surface(floe.surface, field.shortest_length());
  for (int i = 0; i < 12; ++i) {
    const double t = 333.0 * i;
    const Mat3 R = Eigen::AngleAxisd(0.15 * i, Vec3(0.3, 1, 0.2).normalized()).toRotationMatrix();
    const Vec3 p(0.4, -0.3, 0.05 * (i % 5) - 0.1);
    const double eta = field.elevation(p.head<2>(), t);
    Water still = sea();
    bodies::BodySpec spec;
    spec.kind = bodies::BodyKind::floe;
    spec.shape = std::make_shared<const geometry::Shape>(floe);
    spec.mass = 1;
    spec.pose = {Quat(R), p};
    bodies::Bodies bodies;
    bodies.add(spec);
    const auto buoyancy = [&](double level) {
      still.level = level;
      bodies::Wrenches out(1);
      make_buoyancy(still, 1)->add_forces(bodies, 0, out);
      return out[0];
    };
    const Wrench before = buoyancy(0), after = buoyancy(eta), waves = surface.load(R, p, sea(), field, t);
    const double weight = sea().density * sea().gravity;
    EXPECT_LT((waves.force - (after.force - before.force)).norm(), 2e-6 * weight) << i;
    EXPECT_LT((waves.torque - (after.torque - before.torque)).norm(), 2e-6 * weight) << i;
  }
}

/// A body that is wholly dry or far below all waves takes no load or next to none.
TEST(WaveSurface, ActsWhereTheWavesAre) {
  const geometry::Shape box = geometry::box_shape({k_length, k_beam, k_height});
  const WaveField field = wave_along_x(0.2, 2);
  const WaveSurface surface(box.surface, field.shortest_length() / 8);
  EXPECT_EQ(surface.load(Mat3::Identity(), {0, 0, 1}, sea(), field, 0).force, Vec3(0, 0, 0));
  EXPECT_LT(surface.load(Mat3::Identity(), {0, 0, -20}, sea(), field, 0).force.norm(), 1e-3);
}

/// Cutting keeps the surface closed: in a field of constant pressure, the load is zero.
TEST(WaveSurface, StaysClosedWhenCut) {
  const geometry::Shape box = geometry::box_shape({k_length, k_beam, k_height});
  for (const double edge : {9.0, 1.0, 0.3, 0.11}) {
    const WaveSurface surface(box.surface, edge);
    EXPECT_GE(surface.size(), 12u);
    const ComplexVec6 x = surface.linear_load(Mat3::Identity(), {0, 0, -5}, sea(), {1, 0}, 1e-9, k_deep_water);
    EXPECT_LT(x.norm(), 1e-3) << edge;
  }
}

TEST(WaveSurface, FindsTheLongestWetEdge) {
  const geometry::Shape box = geometry::box_shape({k_length, k_beam, k_height});
  EXPECT_NEAR(longest_wet_edge(box.surface, Mat3::Identity(), k_centre, 0), std::hypot(k_length, k_beam), 1e-12);
  EXPECT_EQ(longest_wet_edge(box.surface, Mat3::Identity(), {0, 0, 3}, 0), 0);
}

/// Waves along x on a hull that is its own image in y = 0, face by face: no load across, to the last bit.
TEST(WaveSurface, KeepsMirrorImages) {
  const WaveField field = wave_along_x(0.2, 2);
  const WaveSurface surface(water_test::lofted_hull(), 100);
  const Wrench load = surface.load(Mat3::Identity(), {0.2, 0, 0.05}, sea(), field, 0.3);
  EXPECT_GT(load.force.norm(), 1);
  EXPECT_EQ(load.force.y(), 0);
  EXPECT_EQ(load.torque.x(), 0);
  EXPECT_EQ(load.torque.z(), 0);
}

/// Outlines with and without diagonals of equal length; the surface of the first is halved at two edges of a triangle.
const std::vector<std::vector<Vec2>> k_outlines{{{-10, -7}, {10, -7}, {10, 7}, {-10, 7}},
                                                {{-10, -9}, {12, -9}, {10, 8}, {2, 11}, {-11, 7}}};

/// The loads on a floe whose outline is turned or mirrored in its own frame are turned or mirrored, to rounding: no
/// diagonal of a face is chosen by the axes.
TEST(WaveSurface, DoesNotDependOnTheAxesOfAFloe) {
  for (const auto& outline : k_outlines)
    for (const double side : {1.0, -1.0})
      for (const double turn : {0.5, 1.3, 2.2, 4.0}) {
        const Eigen::Rotation2Dd level(turn);
        const auto image = [&](const Vec2& x) { return Vec2(level * Vec2(x.x(), side * x.y())); };
        std::vector<Vec2> turned;
        for (const Vec2& x : outline) turned.push_back(image(x));
        if (side < 0) std::reverse(turned.begin(), turned.end());
        WaveTrain train;
        train.height = 1.5;
        train.period = 5;
        train.heading = 0.3;
        const WaveField field({train}, sea().gravity, 0, 0, 1);
        train.heading = turn + side * 0.3;
        const WaveField other({train}, sea().gravity, 0, 0, 1);
        const double longest = field.shortest_length() / 8;
        const WaveSurface one(even_surface(geometry::prism_shape(outline, 1)), longest);
        const WaveSurface two(even_surface(geometry::prism_shape(turned, 1)), longest);
        EXPECT_GT(one.size(), 30u);  // the edges were halved
        const Vec2 place(3, -2), moved = image(place);
        const Wrench a = one.load(Mat3::Identity(), {place.x(), place.y(), -0.4}, sea(), field, 0.7);
        const Wrench b = two.load(Mat3::Identity(), {moved.x(), moved.y(), -0.4}, sea(), other, 0.7);
        const Vec2 force = image(a.force.head<2>()), torque = side * image(a.torque.head<2>());
        EXPECT_LT((Vec3(force.x(), force.y(), a.force.z()) - b.force).norm(), 1e-12 * a.force.norm());
        EXPECT_LT((Vec3(torque.x(), torque.y(), side * a.torque.z()) - b.torque).norm(), 1e-12 * a.torque.norm());
      }
}

/// The surface of a prism encloses its volume and is closed, for convex and concave outlines.
TEST(EvenSurface, EnclosesTheVolume) {
  auto outlines = k_outlines;
  outlines.push_back({{-5, -5}, {5, -5}, {5, 5}, {0, -1}, {-5, 5}});
  for (const auto& outline : outlines) {
    const geometry::Shape prism = geometry::prism_shape(outline, 0.8);
    const geometry::TriangleMesh mesh = even_surface(prism);
    double volume = 0, expected = 0;
    Vec3 area = Vec3::Zero();
    const auto add = [](const geometry::TriangleMesh& m, double& sum, Vec3& vector) {
      for (const auto& [a, b, c] : m.triangles) {
        const Vec3 doubled = (m.vertices[b] - m.vertices[a]).cross(m.vertices[c] - m.vertices[a]);
        EXPECT_GT(doubled.norm(), 0);
        vector += doubled;
        sum += m.vertices[a].dot(doubled) / 6;
      }
    };
    add(mesh, volume, area);
    EXPECT_LT(area.norm(), 1e-11);
    add(prism.surface, expected, area);
    EXPECT_NEAR(volume, expected, 1e-12 * expected);
  }
}

}  // namespace wave_surface_test
