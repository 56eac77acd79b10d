/// Fast thin bodies and their impacts within a step, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/collision/thin_plates.h"
#include "tests/support/mirrored.h"

namespace swept_test {

using namespace nilas;
using namespace nilas::sim;

constexpr double k_thickness = 0.01;
constexpr double k_step = 0.01;
constexpr double k_fast = 100 * k_thickness / k_step;  ///< 100 thicknesses per step [m/s]
constexpr double k_exact = 1e-9 * k_fast;              ///< parts of a step end within 1e-9 of it [m/s]

struct Rig : test::SceneRig {
  explicit Rig(const std::string& body, int threads = 1) : SceneRig(test::steps_of(k_step) + body, threads) {}
  StepRecord step() {
    const StepRecord record = simulation.step();
    double momentum = 0, angular = 0;  // The rounding of these momenta bounds the accuracy of the balance.
    for (std::size_t b = 0; b < bodies().mass.size(); ++b) {
      if (bodies().motion[b] == bodies::Motion::fixed) continue;
      const double own = bodies().mass[b] * bodies().v_GB[b].norm();
      momentum += own;
      angular += own * bodies().p_GB[b].norm() + bodies().inertia_B[b].norm() * bodies().w_GB[b].norm();
    }
    EXPECT_LE(record.momentum_imbalance, 1e-12 * (record.momentum_scale + momentum));
    EXPECT_LE(record.angular_momentum_imbalance, 1e-12 * (record.angular_momentum_scale + angular));
    const Ledger& ledger = record.ledger;
    EXPECT_LE(std::abs(ledger.imbalance), 1e-11 * (ledger.kinetic + std::abs(ledger.potential) + ledger.impact));
    return record;
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
};

std::string contact(const std::string& attributes, double restitution = 0, double mu = 0) {
  return "<gravity value='0 0 0'/><contact solver='newton' tolerance='1e-12' " + attributes +
         "><friction between='* *' kinetic='" + std::to_string(mu) + "' restitution='" + std::to_string(restitution) +
         "'/></contact>";
}

std::string text(const Vec3& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

/// Plates across x: `size` wide, k_thickness thick.
std::string plate(const std::string& name, double mass, double x, const Vec3& velocity, const std::string& more = "") {
  return "<body name='" + name + "' shape='box' size='" + std::to_string(k_thickness) + " 1 1' mass='" +
         std::to_string(mass) + "' position='" + std::to_string(x) + " 0 0' velocity='" + text(velocity) + "' " + more +
         "/>";
}

std::string bullet_on_target(double heavier = 2) {
  return plate("target", heavier, 0, Vec3::Zero()) + plate("bullet", 1, -0.37, {k_fast, 0, 0});
}

/// Impulses act half through a step of moreau, so that without continuous detection its first half can be flown
/// through.
TEST(Swept, DiscreteLosesWhatTheOthersHold) {
  struct Choice {
    const char *detection, *integrator;
    bool passes;
  };
  for (const auto& [detection, integrator, passes] :
       {Choice{"discrete", "semi-implicit-euler", true}, Choice{"speculative", "semi-implicit-euler", false},
        Choice{"continuous", "semi-implicit-euler", false}, Choice{"discrete", "moreau", true},
        Choice{"speculative", "moreau", true}, Choice{"continuous", "moreau", false}}) {
    SCOPED_TRACE(std::string(detection) + " " + integrator);
    Rig rig(contact("detection='" + std::string(detection) + "' integrator='" + integrator + "'") + bullet_on_target());
    rig.run(3);
    EXPECT_EQ(rig.bodies().p_GB[1].x() > rig.bodies().p_GB[0].x(), passes);
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), passes ? 0 : k_fast / 3, 1e-9);
    EXPECT_NEAR(rig.bodies().v_GB[1].x(), passes ? k_fast : k_fast / 3, 1e-9);
  }
}

/// v_a+ = (1 + e) v/(1 + m_a/m_b) ..., at the instant of the hit to the last digits of the step when it is cut there.
TEST(Swept, ACutStepHitsAtTheInstant) {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    SCOPED_TRACE(restitution);
    Rig rig(contact("substeps='4' gyroscopic='false'", restitution) + bullet_on_target());
    const StepRecord record = rig.step();
    EXPECT_EQ(record.parts, 2);
    const double hit = (0.37 - k_thickness) / k_fast, left = k_step - hit;
    const double target = (1 + restitution) * k_fast / 3, bullet = k_fast - 2 * target;
    EXPECT_NEAR(rig.bodies().v_GB[0].x(), target, k_exact);
    EXPECT_NEAR(rig.bodies().v_GB[1].x(), bullet, k_exact);
    EXPECT_NEAR(rig.bodies().p_GB[0].x(), left * target, 1e-8);
    EXPECT_NEAR(rig.bodies().p_GB[1].x(), -k_thickness + left * bullet, 1e-8);
    EXPECT_NEAR(record.ledger.impact, 0.5 * (1 - restitution * restitution) * 2.0 / 3 * k_fast * k_fast, 1e-5);
    EXPECT_NEAR(rig.simulation.time(), k_step, 1e-15);
  }
}

/// Three plates in a row: the second hits the third within the step in which the first hit it.
TEST(Swept, ARowOfPlatesHitsInTurnWithinOneStep) {
  Rig rig(contact("substeps='10'", 1) + plate("a", 1, -0.3, {k_fast, 0, 0}) + plate("b", 1, 0, Vec3::Zero()) +
          plate("c", 1, 0.3, Vec3::Zero()));
  const StepRecord record = rig.step();
  EXPECT_EQ(record.parts, 3);
  EXPECT_NEAR(rig.bodies().p_GB[0].x(), -k_thickness, 1e-8);
  EXPECT_NEAR(rig.bodies().p_GB[1].x(), 0.3 - k_thickness, 1e-8);
  EXPECT_NEAR(rig.bodies().p_GB[2].x(), 0.3 + (k_step - (0.6 - 2 * k_thickness) / k_fast) * k_fast, 1e-8);
  EXPECT_NEAR(rig.bodies().v_GB[2].x(), k_fast, k_exact);
}

/// A solution for the whole step would give the second body a velocity that carries it through the third. Substeps
/// prevent that.
TEST(Swept, WhatIsHitDoesNotPassTheNextInTheSameStep) {
  Rig rig(contact("substeps='0'", 1) + plate("a", 10, -0.3, {k_fast, 0, 0}) + plate("b", 0.1, 0, Vec3::Zero()) +
          plate("c", 1, 0.9, Vec3::Zero()));
  for (int k = 0; k < 10; ++k) {
    rig.step();
    EXPECT_LT(rig.bodies().p_GB[0].x(), rig.bodies().p_GB[1].x());
    EXPECT_LT(rig.bodies().p_GB[1].x(), rig.bodies().p_GB[2].x());
  }
}

/// A plate that flies past another at a hand's breadth is left alone, although an axis between them could be closed.
TEST(Swept, WhatPassesBesideIsNotTouched) {
  for (const auto& [detection, touched] : {std::pair{"speculative", true}, {"continuous", false}}) {
    SCOPED_TRACE(detection);
    Rig rig(contact("integrator='semi-implicit-euler' detection='" + std::string(detection) + "'") +
            plate("target", 1, 0, Vec3::Zero()) +
            "<body name='bullet' shape='box' size='0.01 0.2 0.2' mass='1' position='-0.5 0.65 0' velocity='100 0 0'/>");
    rig.run(2);
    EXPECT_EQ(rig.bodies().v_GB[0].norm() > 1e-6, touched);
  }
}

/// A rod of length 2 turns by 0.6 rad per step towards a fixed plate and does not get through.
TEST(Swept, ASpinningRodDoesNotPassAPlate) {
  for (const char* substeps : {"0", "8"})
    for (const double spin : {20.0, 60.0, 150.0}) {
      SCOPED_TRACE(std::string(substeps) + " parts, " + std::to_string(spin) + " rad/s");
      Rig rig(contact("substeps='" + std::string(substeps) + "'") +
              "<body name='plate' shape='box' size='0.5 0.01 1' position='0.8 0.55 0' fixed='true'/>"
              "<body name='rod' shape='box' size='2 0.01 0.01' mass='1' angular_velocity='0 0 " +
              std::to_string(spin) + "'/>");
      for (int k = 0; k < 40; ++k) {
        rig.step();
        const Vec3 along = rig.bodies().R_GB[1].col(0);
        const Vec3 tip = rig.bodies().p_GB[1] + along;
        // its end stays below the plate's middle while it is in front of it
        if (tip.x() > 0.6 && tip.x() < 1) {
          EXPECT_LT(tip.y(), 0.551) << "step " << k;
        }
      }
    }
}

/// Plates that fly and spin at random inside a closed box of six plates never leave it.
TEST(Swept, NothingLeavesABoxOfThinPlates) {
  for (const char* substeps : {"0", "20"}) {
    SCOPED_TRACE(substeps);
    std::string scene = contact("substeps='" + std::string(substeps) + "'", 0.5, 0.2);
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        Vec3 size = Vec3::Constant(2.2), p = Vec3::Zero();
        size[axis] = 0.02;
        p[axis] = side * 1.05;
        scene += "<body shape='box' size='" + text(size) + "' position='" + text(p) + "' fixed='true'/>";
      }
    constexpr int k_plates = 4;
    for (int k = 0; k < k_plates; ++k)
      scene += "<body shape='box' size='0.3 0.2 0.01' mass='1' position='0 0 " + std::to_string(-0.6 + 0.4 * k) +
               "' velocity='" + text({40.0 - 25 * k, -30.0 + 20 * k, 50.0 - 30 * k}) + "' angular_velocity='" +
               text({30.0 * k, 50.0 - 30 * k, 20.0}) + "'/>";
    Rig rig(scene);
    for (int step = 0; step < 200; ++step) {
      rig.step();
      for (int k = 6; k < 6 + k_plates; ++k)
        ASSERT_LT(rig.bodies().p_GB[k].cwiseAbs().maxCoeff(), 1.04) << "step " << step;
    }
  }
}

/// `./dev bench collision plates` flies 1e5 of each. Before, 1 in 100 got through, alone and in crowds.
TEST(Swept, ThinPlatesDoNotPassAloneOrInCrowds) {
  for (const int per_scene : {1, 100}) {
    SCOPED_TRACE(std::to_string(per_scene) + " pairs in a scene");
    RandomStream random(26, "thin plates");
    plates::Tally sum;
    while (sum.flights < 300) {
      std::vector<plates::Flight> flights;
      for (int k = 0; k < per_scene; ++k) flights.push_back(plates::draw(random));
      sum += plates::fly(flights, "");
    }
    EXPECT_EQ(sum.passed, 0);
    EXPECT_EQ(sum.refused, 0);
    EXPECT_EQ(sum.warnings, 0);
    EXPECT_GT(sum.parts, 4 * sum.flights / per_scene);  // steps are halved for those that need it
  }
}

/// A step of moreau is taken back before it is halved.
TEST(Swept, ThinPlatesDoNotPassWithMoreau) {
  RandomStream random(27, "thin plates");
  plates::Tally sum;
  for (int k = 0; k < 200; ++k) sum += plates::fly({plates::draw(random)}, "integrator='moreau'");
  EXPECT_EQ(sum.passed, 0);
  EXPECT_EQ(sum.refused, 0);
  EXPECT_EQ(sum.warnings, 0);
  EXPECT_GT(sum.parts, 4 * sum.flights);
}

/// Slow scenes are not followed: the same bits.
TEST(Swept, AStackThatFallsIsUnchanged) {
  std::string stack = "<body shape='plane'/>";
  for (int k = 0; k < 5; ++k)
    stack += "<body shape='box' size='1 1 0.2' mass='1' position='0 0 " + std::to_string(0.2 + 0.25 * k) + "'/>";
  const auto hash = [&](const std::string& attributes) {
    Rig rig("<contact integrator='semi-implicit-euler' " + attributes +
            "><friction between='* *' kinetic='0.3'/></contact>" + stack);
    StepRecord record;
    for (int k = 0; k < 100; ++k) record = rig.step();
    EXPECT_GT(record.contacts, 0);
    return record.state_hash;
  };
  const std::uint64_t expected = hash("detection='discrete'");
  EXPECT_EQ(hash("detection='speculative'"), expected);
  EXPECT_EQ(hash("detection='continuous'"), expected);
  EXPECT_EQ(hash("detection='continuous' substeps='5'"), expected);
}

/// Two bullets from both sides of y = 0 on a plate across it.
TEST(Swept, AMirroredHitStaysMirrored) {
  for (const char* substeps : {"0", "6"}) {
    std::string scene =
        "<gravity value='0 0 0'/><contact solver='eg-order-free' tolerance='1e-10' "
        "max_iterations='100000' substeps='" +
        std::string(substeps) + "'><friction between='* *' kinetic='0.2' restitution='0.3'/></contact>" +
        plate("target", 5, 0, Vec3::Zero());
    for (const char* y : {"-", ""})
      scene += "<body shape='box' size='0.01 0.2 0.2' mass='1' position='-0.37 " + std::string(y) +
               "0.3 0.1' velocity='90 " + y + "4 3' angular_velocity='" + (*y ? "2 3 -5" : "-2 3 5") + "'/>";
    Rig rig(scene);
    rig.run(5);
    const bodies::Bodies& bodies = rig.bodies();
    EXPECT_GT(bodies.v_GB[0].x(), 1);
    EXPECT_NEAR(bodies.v_GB[0].y(), 0, 1e-9);
    EXPECT_NEAR((bodies.p_GB[1] - test::mirrored(bodies.p_GB[2])).norm(), 0, 1e-9);
    EXPECT_NEAR((bodies.w_GB[1] - test::mirrored_axial(bodies.w_GB[2])).norm(), 0, 1e-7);
  }
}

/// Bullets on plates in many places: the number of threads does not show.
TEST(Swept, ThreadsGiveTheSameBits) {
  std::string scene = contact("substeps='5'", 0.4, 0.2);
  for (int k = 0; k < 8; ++k) {
    const std::string y = std::to_string(1.2 * k);
    scene += "<body shape='box' size='0.01 1 1' mass='3' position='0 " + y + " 0'/>" +
             "<body shape='box' size='0.01 0.4 0.4' mass='1' position='-" + std::to_string(0.2 + 0.07 * k) + " " + y +
             " 0.1' velocity='" + std::to_string(100 - k) + " 0 5' angular_velocity='0 " + std::to_string(3 * k) +
             " 4'/>";
  }
  const auto hash = [&](int threads) {
    Rig rig(scene, threads);
    StepRecord record;
    for (int k = 0; k < 3; ++k) record = rig.step();
    return record.state_hash;
  };
  EXPECT_EQ(hash(1), hash(2));
}

/// The instant of the hit depends on the substep's length when weight acts. Height and speed are those of the scheme.
TEST(Swept, ACutUnderLoadEndsAtTheInstant) {
  Rig rig(
      "<gravity value='0 0 -1000'/><contact solver='newton' tolerance='1e-12' substeps='3'>"
      "<friction between='* *' kinetic='0' restitution='1'/></contact><body shape='plane'/>"
      "<body shape='box' size='1 1 0.02' mass='1' position='0 0 0.51' velocity='0 0 -60'/>");
  rig.step();
  // 0.5 = (60 + 1000 t) t, the velocity being the one after the load; a part that begins with a bounce ends with its
  // speed
  const double t = (-60 + std::sqrt(60 * 60 + 4 * 1000 * 0.5)) / 2000, up = 60 + 1000 * t;
  EXPECT_NEAR(rig.bodies().v_GB[1].z(), up, 1e-6);
  EXPECT_NEAR(rig.bodies().p_GB[1].z(), 0.01 + (k_step - t) * up, 1e-7);
}

TEST(Swept, MoreauCannotBeCut) {
  EXPECT_THROW(Rig(contact("substeps='3' integrator='moreau'") + bullet_on_target()), SceneError);
  Rig uncut(contact("integrator='moreau'") + plate("target", 2, 0, Vec3::Zero()) +
            plate("bullet", 1, -0.87, {k_fast, 0, 0}));
  uncut.run(4);
  EXPECT_LT(uncut.bodies().p_GB[1].x(), uncut.bodies().p_GB[0].x());
  EXPECT_NEAR(uncut.bodies().v_GB[1].x(), k_fast / 3, 1e-9);
}

TEST(Swept, ACutRunGoesOnFromAnyStep) {
  const std::string scene = contact("substeps='5'", 0.6, 0.2) + bullet_on_target();
  Rig whole(scene), first(scene), second(scene);
  first.run(2);
  State state;
  first.simulation.save(StateWriter(state));
  second.simulation.restore(StateReader(state));
  whole.run(2);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(whole.step().state_hash, second.step().state_hash);
}

}  // namespace swept_test
