/// A scene at another scale moves as the scene itself, by Froude's and Cauchy's laws. With a scale of 16 all factors
/// are powers of two, so that every number of the two runs must have the same bits once it is scaled back.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "core/scene/read/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace scaled_run_test {

using namespace nilas;

/// A towed icebreaker that meets floes within its first steps: its stem is at x = 5.5 m in the water. `ice` is the
/// content of <ice>, `more` further elements.
std::string towed_scene(const std::string& ice, const std::string& more, const std::string& contact) {
  return "<scene version='1'><time step='0.01' end='2'/>" + contact +
         "<water density='1005'/><hydro><buoyancy/><drag/></hydro>"
         "<vessel position='0 0'><hull generate='icebreaker' length='6' triangles='400'/><mass draught='0.35'/>"
         "<carriage speed='0.8' ramp='0.1' free='heave'><force_balance kind='six-cells'/></carriage></vessel>"
         "<ice thickness='0.04'>" +
         ice + "</ice>" + more + "</scene>";
}

const char* const k_friction =
    "<friction between='ice ice' static='0.4' kinetic='0.3' restitution='0.2'/>"
    "<friction between='hull ice' static='0.1'/>";

std::string contact_of(const std::string& solver, const std::string& more = "") {
  return "<contact solver='" + solver + "' tolerance='1e-4' " + more + ">" + k_friction + "</contact>";
}

/// The factors of the run at the larger scale.
struct Factors {
  explicit Factors(double lambda)
      : length(lambda),
        time(std::sqrt(lambda)),
        mass(lambda * lambda * lambda),
        inertia(mass * lambda * lambda),
        moment(mass * lambda) {}
  double length, time, mass, inertia, moment;
};

/// Two runs of one scene, the second at another scale.
class ScaledRun : public testing::Test {
 protected:
  void build(const std::string& text, double lambda, const scene::Overrides& overrides = {}) {
    const auto file = folder_.write("scene.xml", text);
    model_ = std::make_unique<sim::Simulation>(scene::read_scene(file, overrides), 1, warnings_);
    scaled_ = std::make_unique<sim::Simulation>(scene::read_scene(file, overrides, lambda), 1, warnings_);
  }

  /// Demands the same bits of all states, after scaling.
  void expect_same_states(const Factors& by) const {
    const bodies::Bodies &a = model_->bodies(), &b = scaled_->bodies();
    ASSERT_EQ(a.size(), b.size());
    for (int i = 0; i < a.size(); ++i) {
      if (a.motion[i] == bodies::Motion::fixed) continue;
      EXPECT_EQ(Vec3(by.length * a.p_GB[i]), b.p_GB[i]) << a.name[i];
      EXPECT_EQ(a.q_GB[i].coeffs(), b.q_GB[i].coeffs()) << a.name[i];
      EXPECT_EQ(seen(by.time * a.v_GB[i]), seen(b.v_GB[i])) << a.name[i];
      EXPECT_EQ(seen(a.w_GB[i] / by.time), seen(b.w_GB[i])) << a.name[i];
      EXPECT_EQ(by.mass * a.mass[i], b.mass[i]) << a.name[i];
      EXPECT_EQ(Mat3(by.inertia * a.inertia_B[i]), b.inertia_B[i]) << a.name[i];
    }
  }

  static void expect_same(const Wrench& a, const Wrench& b, const Factors& by) {
    EXPECT_EQ(Vec3(by.mass * a.force), b.force);
    EXPECT_EQ(Vec3(by.moment * a.torque), b.torque);
  }

  /// Steps both and demands the same bits. Returns the sum of contacts of all steps.
  int expect_same_steps(int steps, double lambda) {
    const Factors by(lambda);
    expect_same_states(by);
    int contacts = 0;
    for (int k = 0; k < steps && !HasFailure(); ++k) {
      SCOPED_TRACE("step " + std::to_string(k + 1));
      const sim::StepRecord a = model_->step(), b = scaled_->step();
      contacts += a.contacts;
      EXPECT_EQ(a.contacts, b.contacts);
      EXPECT_EQ(a.iterations, b.iterations);
      EXPECT_EQ(by.time * a.residuals.law_map_m_s, b.residuals.law_map_m_s);
      EXPECT_EQ(by.moment * a.ledger.kinetic, b.ledger.kinetic);
      EXPECT_EQ(by.moment * a.ledger.potential, b.ledger.potential);
      EXPECT_EQ(by.moment * a.ledger.friction, b.ledger.friction);
      expect_same(a.vessel->contact, b.vessel->contact, by);
      expect_same(a.vessel->hydro.value(), b.vessel->hydro.value(), by);
      expect_same(a.vessel->carriage->about_joint, b.vessel->carriage->about_joint, by);
      EXPECT_EQ(a.broken.size(), b.broken.size());
      expect_same_states(by);
    }
    return contacts;
  }

  /// Squares and products of numbers below this leave the range of doubles, so their bits may differ.
  static Vec3 seen(const Vec3& x) {
    constexpr double k_least = 1e-100;
    return x.unaryExpr([](double number) { return std::abs(number) < k_least ? 0 : number; });
  }

  test::ScratchFolder folder_;
  WarningCounts warnings_{make_logger("off", "")};
  std::unique_ptr<sim::Simulation> model_, scaled_;
};

const char* const k_floes =
    "<field kind='packed' region='5 -1.2 8 1.2' concentration='0.7'>"
    "<size mean='0.5' sd='0.15' min='0.25' max='0.9'/></field>";

TEST_F(ScaledRun, HasTheSameBitsAmongFloes) {
  build(towed_scene(k_floes, "", contact_of("nsgs")), 16);
  EXPECT_GT(expect_same_steps(60, 16), 20);
}

TEST_F(ScaledRun, HasTheSameBitsWithTheDefaultSolver) {
  build(towed_scene(k_floes, "", contact_of("auto")), 16);
  EXPECT_GT(expect_same_steps(60, 16), 20);
}

TEST_F(ScaledRun, HasTheSameBitsWithTheOrderFreeSolver) {
  build(towed_scene(k_floes, "", contact_of("newton-order-free")), 16);
  EXPECT_GT(expect_same_steps(60, 16), 20);
}

/// Also where ice crushes, bends and splits, and to a scale below 1. The pieces jam, where this solver would take most
/// of the time of all tests; whatever it has reached after 100 sweeps must have the same bits.
TEST_F(ScaledRun, HasTheSameBitsInIceThatBreaks) {
  const std::string breaking = "<fracture><crushing/><bending/><splitting/></fracture>";
  build(towed_scene("<field kind='level' region='5 -2 9 2' fixed='true' breakable='true'/>", breaking,
                    contact_of("nsgs", "max_iterations='100'")),
        1.0 / 16);
  EXPECT_GT(expect_same_steps(24, 1.0 / 16), 200);
  EXPECT_GT(model_->bodies().size(), 20) << "the sheet has broken";
}

/// Random waves that ice weakens by the measured rates of Meylan et al., there and back.
TEST_F(ScaledRun, HasTheSameBitsInWavesUnderIce) {
  const std::string water =
      "<water density='1005'><waves kind='jonswap' height='0.05' period='2' components='12' attenuation='meylan' "
      "ice_edge='5 0'/></water>";
  std::string text = towed_scene(k_floes, "", contact_of("nsgs"));
  const std::string calm = "<water density='1005'/><hydro>";
  text.replace(text.find(calm), calm.size(), water + "<hydro><wave_loads vessel='none'/>");
  for (const double lambda : {16.0, 1.0 / 16}) {
    build(text, lambda);
    EXPECT_GT(expect_same_steps(40, lambda), 0) << lambda;
  }
}

/// Hull folders are files; their lengths are scaled on reading.
TEST_F(ScaledRun, ScalesFiles) {
  folder_.write("path.csv", "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.1,0.05,0,0\n2,1.5,0.1,2\n");
  folder_.write(
      "floes.geojson",
      R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"thickness_m":0.05},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[5.6,-0.5],[7,-0.5],[7,0.5],[5.6,0.5],[5.6,-0.5]]]}}]})");
  folder_.write("floes.json", "[[0,0,1,0,1,1,0,1],[0,0,2,0,1,1]]");
  folder_.write("cells.csv",
                "x_m,y_m,z_m,ax,ay,az\n0,0,0,1,0,0\n1,0,0,0,1,0\n-1,0,0,0,1,0\n1,0,0,0,0,1\n"
                "-1,1,0,0,0,1\n-1,-1,0,0,0,1\n");
  const std::string hull = std::string(NILAS_SOURCE_DIR) + "/apps/scenes/hulls/icebreaker";
  build("<scene version='1'><time step='0.01' end='2'/>" + contact_of("nsgs") +
            "<water/><hydro><buoyancy/><drag/></hydro><vessel hull='" + hull +
            "' position='0 0'><mass draught='0.35'/><carriage free='heave'><path file='path.csv'/>"
            "<force_balance kind='six-cells' layout='cells.csv'/></carriage></vessel>"
            "<ice thickness='0.04'><field kind='file' file='floes.geojson'/>"
            "<field kind='packed' region='7.2 -1 9 1' concentration='0.3'><size distribution='as-library'/>"
            "<shape library='floes.json'/></field></ice></scene>",
        16);
  EXPECT_EQ(model_->bodies().size(), scaled_->bodies().size());
  EXPECT_GT(expect_same_steps(40, 16), 0);
}

/// A vessel on a spring line with a table of tensions: lengths grow by 16, tensions by 16^3.
TEST_F(ScaledRun, ScalesTablesOfSpringLines) {
  folder_.write("spring.csv", "stretch_m,tension_N\n0,0\n0.5,30\n1.5,400\n");
  build("<scene version='1'><time step='0.01' end='2'/>" + contact_of("nsgs") +
            "<water/><hydro><buoyancy/><drag/></hydro><vessel position='0 0' velocity='0.2 0 0'><hull "
            "generate='icebreaker' length='6' triangles='400'/><mass draught='0.35'/><mooring "
            "start='as-placed'><spring_line name='a' fairlead='0 0 0' anchor='-9 1 0' length='8' "
            "table='spring.csv'/></mooring></vessel></scene>",
        16);
  const Factors by(16);
  expect_same_states(by);
  const double start = model_->bodies().v_GB[0].x();
  for (int k = 0; k < 50 && !HasFailure(); ++k) {
    const sim::StepRecord a = model_->step(), b = scaled_->step();
    EXPECT_EQ(by.mass * a.module_values.at(0), b.module_values.at(0));
    EXPECT_GT(a.module_values.at(0), 30) << "beyond the first row";
    expect_same_states(by);
  }
  EXPECT_LT(model_->bodies().v_GB[0].x(), start);
}

/// A ship of 1e8 kg in ice of 2 m: 40 times the model. No factor is a power of two then, so the runs agree to rounding
/// while their contacts are the same, and the accounts close to the same share.
TEST_F(ScaledRun, OfAShipKeepsItsAccountsToTheSameShare) {
  const double lambda = 40;
  build(towed_scene("<field kind='grid' region='5.2 -1 8.2 1' rows='4' columns='6' gap='0.01'/>", "",
                    contact_of("newton")),
        lambda, {{"ice/@thickness", "0.05"}});
  const Factors by(lambda);
  EXPECT_NEAR(scaled_->bodies().mass[scaled_->vessel_index()], 1e8, 1e7);
  EXPECT_DOUBLE_EQ(scaled_->info().ice_thickness, 2);
  int contacts = 0;
  double largest = 1;  // [N]
  for (int k = 0; k < 50; ++k) {
    const sim::StepRecord a = model_->step(), b = scaled_->step();
    contacts += b.contacts;
    EXPECT_FALSE(b.solver_short);
    EXPECT_LE(b.residuals.law_map_m_s, by.time * 1e-4);
    EXPECT_LE(b.momentum_imbalance, 1e-11 * b.momentum_scale);
    EXPECT_LE(std::abs(b.ledger.imbalance), 1e-9 * (b.ledger.kinetic + std::abs(b.ledger.potential)));
    // The solver stops at its tolerance, not at rounding.
    const double force = a.vessel->carriage->about_joint.force.x();
    largest = std::max(largest, std::abs(force));
    EXPECT_NEAR(b.vessel->carriage->about_joint.force.x() / by.mass, force, 1e-5 * largest);
  }
  EXPECT_GT(contacts, 5);
}

}  // namespace scaled_run_test
