#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/geometry/mass_properties.h"
#include "core/hull/hull.h"
#include "tests/support/mentions.h"
#include "tests/support/refusal.h"

namespace nilas::hull {
namespace hull_generate_test {

Vec3 normal_of(const geometry::TriangleMesh& mesh, const std::array<int, 3>& t) {
  const auto vertex = [&](int k) { return mesh.vertices[t[k]]; };
  return (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)).normalized();
}

bool mirror_symmetric(const geometry::TriangleMesh& mesh) {
  std::set<std::array<double, 3>> points;
  for (const auto& p : mesh.vertices) points.insert({p.x(), p.y(), p.z()});
  return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Vec3& p) {
    return points.count({p.x(), 0.0 - p.y(), p.z()}) == 1;
  });
}

double longest_side(const geometry::TriangleMesh& mesh) {
  Vec3 low = mesh.vertices.front(), high = low;
  for (const auto& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

/// How far any vertex stands outside the plane of any triangle, as a share of what rounding to float32 explains:
/// vertices move by up to e = 2^-24 of the length L, which tilts the plane of a triangle of height d by 2 e/d, so at a
/// distance L a vertex may stand e + 2 e L/d outside.
double furthest_outside(const geometry::TriangleMesh& mesh) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(mesh.vertices.size()));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) points.col(static_cast<Eigen::Index>(i)) = mesh.vertices[i];
  const double length = longest_side(mesh), rounding = std::ldexp(length, -24);
  double furthest = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.vertices[t[k]]; };
    const Vec3 n = normal_of(mesh, t);
    const double area2 = (at(1) - at(0)).cross(at(2) - at(0)).norm();
    const double longest = std::max({(at(1) - at(0)).norm(), (at(2) - at(1)).norm(), (at(0) - at(2)).norm()});
    const double allowed = rounding * (1 + 2 * length / (area2 / longest));
    furthest = std::max(furthest, ((n.transpose() * points).maxCoeff() - n.dot(at(0))) / allowed);
  }
  return furthest;
}

/// Closed, outward, symmetric bit for bit, float32 coordinates, and convex to rounding.
void expect_sound(const geometry::TriangleMesh& mesh) {
  const geometry::MeshDefects defects = geometry::find_defects(mesh);
  EXPECT_TRUE(defects.sound()) << defects.text();
  EXPECT_TRUE(mirror_symmetric(mesh));
  EXPECT_LE(furthest_outside(mesh), 1);
  for (const auto& p : mesh.vertices)
    for (const double x : p) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
}

void expect_sound(const Hull& hull) {
  expect_sound(hull.fluid);
  for (const auto& part : hull.parts) {
    expect_sound(part);
    EXPECT_NO_THROW(geometry::make_polytope(part, 5e-6 * longest_side(part)));
  }
}

double volume(const geometry::TriangleMesh& mesh) { return geometry::mesh_properties(mesh, 1.0).mass; }

HullForm form_of(const std::map<std::string, double>& parameters, const std::string& kind = "icebreaker") {
  return hull_form(kind, parameters);
}

/// Point of the surface furthest forward on the centre plane at height z.
double stem_at(const geometry::TriangleMesh& mesh, double z) {
  double furthest = -1e300;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if ((a.z() - z) * (b.z() - z) > 0 || a.z() == b.z()) continue;
      furthest = std::max(furthest, a.x() + (b.x() - a.x()) * (z - a.z()) / (b.z() - a.z()));
    }
  return furthest;
}

class HullFinenessLevel : public testing::TestWithParam<int> {};

TEST_P(HullFinenessLevel, IcebreakerIsSoundAndHasTheWantedTriangles) {
  const Hull hull = generate_hull(form_of({{"triangles", GetParam()}}));
  EXPECT_NEAR(static_cast<double>(hull.fluid.triangles.size()), GetParam(), 0.05 * GetParam());
  expect_sound(hull);
}

TEST_P(HullFinenessLevel, WedgeIsSoundAndHasTheWantedTriangles) {
  const Hull hull = generate_hull(form_of({{"triangles", GetParam()}}, "wedge"));
  EXPECT_NEAR(static_cast<double>(hull.fluid.triangles.size()), GetParam(), 0.05 * GetParam());
  expect_sound(hull);
}

INSTANTIATE_TEST_SUITE_P(Levels, HullFinenessLevel, testing::Values(1000, 6000, 18000));

TEST(HullGenerate, LevelsAgreeInVolumeAndPartsWithTheSurface) {
  const double fine = volume(generate_hull(form_of({{"triangles", 18000}})).fluid);
  for (const int triangles : {1000, 6000}) {
    const Hull hull = generate_hull(form_of({{"triangles", static_cast<double>(triangles)}}));
    EXPECT_NEAR(volume(hull.fluid), fine, 0.005 * fine);
    double parts = 0;
    for (const auto& part : hull.parts) parts += volume(part);
    EXPECT_NEAR(parts, volume(hull.fluid), 1e-5 * fine);
  }
}

TEST(HullGenerate, MainDimensionsAreAsAsked) {
  const HullForm form = form_of({{"length", 6}, {"beam", 1.1}, {"draught", 0.3}, {"depth", 0.55}});
  const geometry::TriangleMesh mesh = generate_hull(form).fluid;
  Vec3 low = mesh.vertices.front(), high = low;
  double beam_at_draught = 0;
  for (const auto& p : mesh.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 &a = mesh.vertices[t[k]], &b = mesh.vertices[t[(k + 1) % 3]];
      if ((a.z() - 0.3) * (b.z() - 0.3) > 0 || a.z() == b.z()) continue;
      beam_at_draught = std::max(beam_at_draught, 2 * (a.y() + (b.y() - a.y()) * (0.3 - a.z()) / (b.z() - a.z())));
    }
  EXPECT_NEAR(low.x(), 0, 1e-6);
  EXPECT_NEAR(high.x(), 6, 1e-6);
  EXPECT_NEAR(low.z(), 0, 1e-6);
  EXPECT_NEAR(high.z(), 0.55, 1e-6);
  EXPECT_NEAR(beam_at_draught, 1.1, 1e-5);
}

/// The stem leans by the requested angle, and its neighbouring faces meet the still water plane in lines at the
/// requested angle.
TEST(HullGenerate, StemAndEntranceAnglesAreAsAsked) {
  for (const double stem : {20.0, 45.0, 90.0})
    for (const double entrance : {19.0, 24.0, 30.0, 33.5, 34.0, 50.0}) {
      const HullForm form = form_of({{"stem_angle_deg", stem}, {"entrance_angle_deg", entrance}, {"triangles", 1000}});
      const geometry::TriangleMesh mesh = generate_hull(form).fluid;
      const double low = stem_at(mesh, 0.1), high = stem_at(mesh, 0.5);
      EXPECT_NEAR(std::atan2(0.4, high - low) / k_deg, stem, 0.01);
      const double at_waterline = stem_at(mesh, form.draught);
      double measured = -1;
      for (const auto& t : mesh.triangles) {
        const Vec3 n = normal_of(mesh, t);
        for (const int v : t) {
          const Vec3& p = mesh.vertices[v];
          // the port face at the stem near the waterline: its horizontal line runs at atan(n_x / n_y) from the centre
          // plane
          const bool at_stem = p.y() == 0 && std::abs(p.x() - stem_at(mesh, p.z())) < 1e-5;
          if (at_stem && n.y() > 0.1 && std::abs(p.x() - at_waterline) < 0.3) measured = std::atan2(n.x(), n.y());
        }
      }
      EXPECT_NEAR(measured / k_deg, entrance, 0.05) << "stem " << stem;
    }
}

TEST(HullGenerate, EveryFormOfASweepIsSound) {
  int made = 0;
  for (const double length : {1.0, 6.0, 100.0})
    for (const double stem : {10.0, 15.0, 25.0, 60.0, 90.0})
      for (const double entrance : {19.0, 30.0, 60.0, 80.0})
        for (const double flare : {0.0, 8.0, 30.0}) {
          const std::map<std::string, double> parameters{
              {"length", length},         {"stem_angle_deg", stem},     {"entrance_angle_deg", entrance},
              {"flare_angle_deg", flare}, {"bow_length", 0.3 * length}, {"triangles", 1000}};
          try {
            const Hull hull = generate_hull(form_of(parameters));
            expect_sound(hull);
            ++made;
          } catch (const InputError& error) {
            // a stem this flat leaves no room for bow and run
            EXPECT_EQ(stem, 10.0) << error.what();
            EXPECT_NE(std::string(error.what()).find("bow_length + stern_length"), std::string::npos) << error.what();
          }
        }
  EXPECT_GE(made, 3 * 4 * 4 * 3);
}

TEST(HullGenerate, EveryCountIsMadeWithinFivePercent) {
  for (const char* kind : {"icebreaker", "wedge"})
    for (const double triangles : {200., 237., 300., 377., 500., 811., 1300., 2222., 4000., 9999., 50000., 200000.}) {
      const auto mesh = generate_hull(form_of({{"triangles", triangles}}, kind)).fluid;
      EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), triangles, 0.05 * triangles) << kind;
    }
}

/// Full beam from the aft end to the shoulder, then straight to the stem: volume by hand.
TEST(HullGenerate, WedgeIsAPrism) {
  const HullForm form =
      form_of({{"length", 5}, {"beam", 1}, {"bow_length", 2}, {"depth", 0.5}, {"draught", 0.3}}, "wedge");
  const Hull hull = generate_hull(form);
  expect_sound(hull);
  EXPECT_NEAR(volume(hull.fluid), 0.5 * (3 * 1 + 0.5 * 2 * 1), 1e-6);
  for (const auto& t : hull.fluid.triangles) {
    const Vec3 n = normal_of(hull.fluid, t);
    EXPECT_TRUE(std::abs(n.z()) < 1e-6 || std::abs(n.z()) > 1 - 1e-6);
  }
}

std::string refusal(const std::map<std::string, double>& parameters, const std::string& kind = "icebreaker") {
  return test::refusal([&] { generate_hull(form_of(parameters, kind)); });
}

TEST(HullGenerate, WrongParametersAreNamedWithWhatIsAllowed) {
  EXPECT_PRED2(test::mentions, refusal({{"length", -1}}), "length");
  EXPECT_PRED2(test::mentions, refusal({{"beam", 0}}), "beam is 0");
  EXPECT_PRED2(test::mentions, refusal({{"depth", 0.2}}), "depth is 0.2");
  EXPECT_PRED2(test::mentions, refusal({{"stem_angle_deg", 120}}), "stem_angle_deg is 120");
  EXPECT_PRED2(test::mentions, refusal({{"entrance_angle_deg", 10}}), "entrance_angle_deg is 10");
  EXPECT_PRED2(test::mentions, refusal({{"flare_angle_deg", -5}}), "flare_angle_deg is -5");
  EXPECT_PRED2(test::mentions, refusal({{"flare_angle_deg", 44}, {"draught", 0.7}, {"depth", 1}}),
               "flare_angle_deg is 44");
  EXPECT_PRED2(test::mentions, refusal({{"bow_length", 4}, {"stern_length", 3}}), "bow_length + stern_length is 7");
  EXPECT_PRED2(test::mentions, refusal({{"triangles", 10}}), "triangles is 10");
  EXPECT_PRED2(test::mentions, refusal({{"length", std::nan("")}}), "length is nan");
  EXPECT_PRED2(test::mentions, refusal({{"bow_length", 7}}, "wedge"), "bow_length is 7");
}

TEST(HullForm, LengthsThatAreNotNamedScaleWithTheLength) {
  const HullForm small = hull_form("icebreaker", {{"length", 3}, {"depth", 0.4}}), whole;
  EXPECT_DOUBLE_EQ(small.beam, 0.5 * whole.beam);
  EXPECT_DOUBLE_EQ(small.draught, 0.5 * whole.draught);
  EXPECT_DOUBLE_EQ(small.bow_length, 0.5 * whole.bow_length);
  EXPECT_DOUBLE_EQ(small.stern_length, 0.5 * whole.stern_length);
  EXPECT_EQ(small.depth, 0.4);
  EXPECT_EQ(small.stem_angle, whole.stem_angle);
}

TEST(HullForm, UnknownNamesAreRefusedWithTheNearest) {
  const auto text = [](const std::string& kind, const std::map<std::string, double>& parameters) {
    return test::refusal([&] { hull_form(kind, parameters); });
  };
  EXPECT_PRED2(test::mentions, text("icebreaker", {{"beem", 1}}), "'beam'");
  EXPECT_PRED2(test::mentions, text("icebreaker", {{"stem_angle", 25}}), "'stem_angle_deg'");
  EXPECT_PRED2(test::mentions, text("icebraker", {}), "'icebreaker'");
  EXPECT_PRED2(test::mentions, text("wedge", {{"flare_angle_deg", 5}}), "flare_angle_deg");
}

}  // namespace hull_generate_test
}  // namespace nilas::hull
