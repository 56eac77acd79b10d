/// Elastic contacts against closed forms: static depth, bounce, stretch, rest on a slope, and the limit of a rigid
/// pair.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/core/sim/scene_rig.h"

namespace elastic_contact_test {

using namespace nilas;

constexpr double k_stiffness = 2e5, k_mass = 3, k_gravity = 9.81;

struct Setting {
  double step = 1e-3, friction = 0.4, stiffness = k_stiffness, damping_ratio = 0.2, tolerance = 1e-13;
  std::string gravity = "0 0 -9.81", attributes = "";
};

/// Elastic between all materials. `attributes`: further ones of <contact>.
std::string elastic(const Setting& s) {
  return "<time step='" + test::text(s.step) + "' end='1000'/><gravity value='" + s.gravity +
         "'/><contact law='coulomb' solver='auto' tolerance='" + test::text(s.tolerance) + "' max_iterations='1000' " +
         s.attributes + "><friction between='* *' kinetic='" + test::text(s.friction) + "' elastic='true' stiffness='" +
         test::text(s.stiffness) + "' damping_ratio='" + test::text(s.damping_ratio) + "'/></contact>";
}

const std::string k_ground = "<body name='ground' shape='plane' fixed='true'/>";
const std::string k_box = "<body shape='box' size='1 0.8 0.2' mass='3' position='0 0 0.1'/>";

std::string ball(double height, double speed) {
  return "<body shape='sphere' radius='0.1' mass='3' position='0 0 " + test::text(height) + "' velocity='0 0 " +
         test::text(speed) + "'/>";
}

struct Rig : test::SceneRig {
  using SceneRig::SceneRig;
  sim::StepRecord run(double seconds) {
    sim::StepRecord record;
    const double end = simulation.time() + seconds;
    while (simulation.time() < end - 1e-9) {
      record = simulation.step();
      EXPECT_LE(std::abs(record.ledger.imbalance),
                1e-11 * (1 + record.ledger.kinetic + std::abs(record.ledger.potential)));
    }
    return record;
  }
  Vec3 p() const { return bodies().p_GB[1]; }
  Vec3 v() const { return bodies().v_GB[1]; }
  double speed() const { return std::max(v().norm(), bodies().w_GB[1].norm()); }
};

TEST(ElasticContact, WeightPressesBoxAndBallInByForceOverStiffness) {
  for (const std::string& body : {k_box, ball(0.1, 0)})
    for (const char* integrator : {"moreau", "semi-implicit-euler"}) {
      Rig rig(elastic({.attributes = "integrator='" + std::string(integrator) + "'"}) + k_ground + body);
      const sim::StepRecord record = rig.run(2);
      const double depth = k_mass * k_gravity / k_stiffness;
      EXPECT_NEAR(0.1 - rig.p().z(), depth, 1e-12) << "the four points of a patch share its stiffness";
      EXPECT_NEAR(record.penetration_max, depth, 1e-12);
      EXPECT_NEAR(record.ledger.elastic, 0.5 * k_stiffness * depth * depth, 1e-12);
      EXPECT_LT(rig.speed(), 1e-12);
    }
}

struct Bounce {
  double restitution = 0, time = 0;
};

/// A ball that meets the plane at 0.5 m/s without weight.
Bounce bounce(double step, double damping_ratio, const std::string& attributes = "") {
  Setting s{.step = step, .damping_ratio = damping_ratio, .gravity = "0 0 0", .attributes = attributes};
  Rig rig(elastic(s) + k_ground + ball(0.1, -0.5));
  Bounce out;
  while (rig.p().z() < 0.1 + 1e-4 && rig.simulation.time() < 1) {
    const double before = rig.v().z();
    rig.run(step);
    if (before < 0.5 && rig.bodies().v_GB[1].z() == before && before > 0) break;
    out.time = rig.simulation.time();
  }
  out.restitution = rig.v().z() / 0.5;
  return out;
}

TEST(ElasticContact, UndampedBallBouncesWithTheSpringsPeriodAndLosesFirstOrderInTheStep) {
  const double w = std::sqrt(k_stiffness / k_mass), half_period = std::numbers::pi / w;
  double last_loss = 0;
  for (const double step : {2e-5, 1e-5, 5e-6}) {
    const Bounce found = bounce(step, 0);
    const double loss = 1 - found.restitution;
    EXPECT_NEAR(found.time, half_period, 3 * step);
    // implicit Euler damps like a damping ratio of w h/2
    EXPECT_NEAR(found.restitution, std::exp(-std::numbers::pi * w * step / 2), 0.05 * loss);
    if (last_loss > 0) {
      EXPECT_NEAR(last_loss / loss, 2, 0.05);
    }
    last_loss = loss;
  }
}

TEST(ElasticContact, DashpotGivesTheRestitutionOfItsClosedForm) {
  // A spring and dashpot that lose contact when their force is zero [Schwager, Poeschel 2007].
  const double ratio = 0.3, w0 = std::sqrt(k_stiffness / k_mass), b = ratio * w0, w = std::sqrt(w0 * w0 - b * b);
  const double exact = std::exp(-b / w * (std::numbers::pi - std::atan2(2 * b * w, w * w - b * b)));
  const double coarse = bounce(1e-5, ratio).restitution, fine = bounce(5e-6, ratio).restitution;
  EXPECT_NEAR(fine, exact, 0.01);
  EXPECT_NEAR(2 * fine - coarse, exact, 5e-4) << "first order in the step";
}

TEST(ElasticContact, StickingBoxIsStretchedByForceOverTangentialStiffness) {
  Rig rig(elastic({.gravity = "2 0 -9.81"}) + k_ground + k_box);
  rig.run(3);
  const double ratio = 2 * (1 - 0.3) / (2 - 0.3), k_t = ratio * k_stiffness, push = k_mass * 2.0;
  // The push acts 0.1 m above the plane: the box also tips on the springs below its ends, 0.5 m from its middle.
  const double arm = 0.1 - 0.5 * k_mass * k_gravity / k_stiffness, tip = push * arm / (k_stiffness * 0.5 * 0.5);
  EXPECT_NEAR(rig.p().x(), push / k_t + arm * tip, 5e-10);
  EXPECT_NEAR(rig.p().y(), 0, 1e-12);
  EXPECT_LT(rig.speed(), 1e-12);
}

TEST(ElasticContact, BoxOnASlopeBelowTheAngleOfFrictionDoesNotCreep) {
  const double angle = std::atan(0.4) - 0.01;
  const std::string gravity = test::text(9.81 * std::sin(angle)) + " 0 " + test::text(-9.81 * std::cos(angle));
  for (const char* solver_tolerance : {"1e-13", "1e-5"}) {
    Rig rig(elastic({.step = 0.01, .tolerance = std::stod(solver_tolerance), .gravity = gravity}) + k_ground + k_box);
    rig.run(5);
    const Vec3 settled = rig.p();
    rig.run(5);
    EXPECT_LT((rig.p() - settled).norm(), 1e-12) << solver_tolerance;
    EXPECT_LT(rig.speed(), 1e-12) << solver_tolerance;
  }
}

TEST(ElasticContact, BoxOnASteeperSlopeSlidesByCoulomb) {
  const double angle = std::atan(0.4) + 0.1, down = 9.81 * std::sin(angle), across = 9.81 * std::cos(angle);
  Rig rig(elastic({.gravity = test::text(down) + " 0 " + test::text(-across)}) + k_ground + k_box);
  rig.run(0.5);
  const double speed = rig.v().x();
  const double lost = rig.run(0.5).ledger.friction;
  EXPECT_NEAR(rig.v().x() - speed, 0.5 * (down - 0.4 * across), 1e-6);
  EXPECT_GT(lost, 0.4 * k_mass * across * 0.5 * speed) << "slip loses mu N v";
}

TEST(ElasticContact, StiffPairsMeetAsRigidOnes) {
  const std::string blocks =
      "<body shape='box' size='1 1 1' mass='3' position='0 0 0' velocity='1 0 0'/>"
      "<body shape='box' size='1 1 1' mass='1' position='1.005 0.1 0'/>";
  const auto speed = [&](const std::string& contact) {
    Rig rig("<time step='0.01' end='10'/><gravity value='0 0 0'/>" + contact + blocks);
    rig.simulation.step();
    return rig.bodies().v_GB[1].x();
  };
  const double rigid = speed(
      "<contact tolerance='1e-12'><friction between='* *' "
      "kinetic='0.2'/></contact>");
  double last = 0;
  for (const double stiffness : {1e8, 1e9, 1e10}) {
    const double off =
        std::abs(speed("<contact tolerance='1e-12'><friction between='* *' kinetic='0.2' elastic='true' stiffness='" +
                       test::text(stiffness) + "'/></contact>") -
                 rigid);
    EXPECT_LT(off, 1e5 / stiffness);
    if (last > 0) {
      EXPECT_NEAR(off, 0.1 * last, 0.01 * last);
    }
    last = off;
  }
}

/// Three boxes that collide, in a frame turned by `angle` about Z; the other order of the bodies where asked.
std::vector<Vec3> collided(double angle, bool other_order) {
  const Mat3 R(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
  const auto box = [&](const Vec3& p, const Vec3& v, double yaw_deg) {
    const Vec3 at = R * p, speed = R * v;
    return "<body shape='box' size='1 0.8 0.4' mass='3' position='" + test::text(at.x()) + " " + test::text(at.y()) +
           " " + test::text(at.z()) + "' velocity='" + test::text(speed.x()) + " " + test::text(speed.y()) +
           " 0' rotation_deg='" + test::text(yaw_deg + angle / k_deg) + " 0 0'/>";
  };
  const std::vector<std::string> boxes{box({0, 0, 0}, {1, 0.2, 0}, 10), box({1.3, 0.3, 0}, {0, 0, 0}, 35),
                                       box({2.5, 0, 0}, {-0.5, 0.1, 0}, -20)};
  Rig rig(elastic({.gravity = "0 0 0"}) +
          (other_order ? boxes[2] + boxes[0] + boxes[1] : boxes[0] + boxes[1] + boxes[2]));
  rig.run(0.8);
  std::vector<Vec3> found;
  for (const std::size_t b : other_order ? std::vector<std::size_t>{1, 2, 0} : std::vector<std::size_t>{0, 1, 2})
    found.push_back(R.transpose() * rig.bodies().v_GB[b]);
  return found;
}

TEST(ElasticContact, DependsNeitherOnTheFrameNorOnTheOrderOfBodies) {
  const std::vector<Vec3> expected = collided(0, false), turned = collided(0.7, false), reordered = collided(0, true);
  for (std::size_t b = 0; b < 3; ++b) {
    EXPECT_GT((expected[b] - Vec3(1, 0.2, 0)).norm(), 0.1) << "all collide";
    EXPECT_LT((turned[b] - expected[b]).norm(), 1e-8);
    EXPECT_LT((reordered[b] - expected[b]).norm(), 1e-8);
  }
}

TEST(ElasticContact, IceTakesItsStiffnessFromModulusAndThickness) {
  const double E = 6e7, h = 0.1;
  const auto run = [&](const std::string& content) {
    Rig rig(
        "<time step='0.002' end='100'/><gravity value='0 0 0'/><water density='1005'/>"
        "<contact tolerance='1e-12'><friction between='* *' kinetic='0.2' elastic='true' damping_ratio='0.5'/>"
        "</contact><ice thickness='0.1' youngs_modulus='6e7'>" +
        content + "</ice>");
    for (int k = 0; k < 10; ++k) rig.simulation.step();
    return rig.simulation.last_problem().problem.compliance;
  };
  const auto pair =
      run("<floe outline='0 0 1 0 1 1 0 1' velocity='0.1 0 0'/><floe outline='1.0001 0 2 0 2 1 1.0001 1'/>");
  ASSERT_EQ(pair.size(), 4u);
  const double mass = 920 * h, k = 0.5 * 0.5 * E * h;
  const double retardation = 2 * 0.5 / std::sqrt(k * 2 / mass), step = 0.002;
  for (const double c : pair) EXPECT_NEAR(c, 4 / (k * step * (step + retardation)), 0.002 * c);
}

TEST(ElasticContact, TheHullMeetsElasticIceNoMoreAsARigidBody) {
  const auto info = [](const std::string& pair) {
    Rig rig("<time step='0.01' end='1'/><water density='1005'/><contact><friction between='" + pair +
            "' kinetic='0.2' elastic='true'/><friction between='* *' kinetic='0.1'/></contact>" +
            test::box_vessel("position='0 0'", "<fixed/>") +
            "<ice thickness='0.1'><floe outline='3 0 4 0 4 1 3 1'/></ice>");
    return std::pair(rig.simulation.info().elastic_contacts, rig.simulation.info().rigid_contacts);
  };
  EXPECT_EQ(info("hull ice"), std::pair(true, false));
  EXPECT_EQ(info("ice ice"), std::pair(true, true));
}

/// Where the impulses of the step before meet the tolerance, a sweep follows in scenes with an elastic pair. In this
/// row of rigid floes, which water drags along ever less, it led out of the tolerance again while the status was
/// `converged`.
TEST(ElasticContacts, NoSweepLeadsOutOfTheToleranceOfAConvergedStep) {
  std::string floes;
  const std::vector<std::string> thicknesses{"0.1", "0.3", "0.5", "0.2"};
  for (std::size_t k = 0; k < thicknesses.size(); ++k) {
    const std::string x0 = std::to_string(k), x1 = std::to_string(k + 1);
    floes += "<floe outline='" + x0 + " 0 " + x1 + " 0 " + x1 + " 1 " + x0 + " 1' thickness='" + thicknesses[k] + "'/>";
  }
  constexpr double k_tolerance = 1e-4;  // [m/s]
  test::SceneRig rig(
      "<time step='0.01' end='10'/><gravity value='0 0 0'/><contact integrator='semi-implicit-euler' "
      "tolerance='1e-4' solver='auto'><friction between='wall wall' static='0' elastic='true' stiffness='1e5'/>"
      "</contact><hydro><virtual_drag coefficient='200' velocity='-1 0 0'/></hydro><ice>" +
      floes + "</ice>");
  int untouched = 0;
  for (int k = 0; k < 60; ++k) {
    const sim::StepRecord record = rig.simulation.step();
    ASSERT_EQ(record.status, contact::SolveStatus::converged);
    EXPECT_LE(record.residuals.law_map_m_s, k_tolerance) << record.t;
    untouched += record.iterations == 0 && record.contacts > 0;
  }
  EXPECT_GT(untouched, 10) << "no step began within the tolerance, so nothing was tested";
}

}  // namespace elastic_contact_test
