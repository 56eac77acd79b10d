/// The reference integrator with a vessel on a carriage: against closed forms, independent equations and the stepping
/// schemes.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/geometry/mesh.h"
#include "core/numerics/event_ode.h"
#include "core/sim/simulation.h"
#include "tests/core/sim/scene_rig.h"

namespace reference_towed_test {

using namespace nilas;
using namespace nilas::sim;

constexpr double k_mass = 800, k_gravity = 9.81;

struct Rig : test::SceneRig {
  explicit Rig(const std::string& body)
      : SceneRig(body, 1, {{"track.csv", "t_s,x_m,y_m,yaw_deg\n0.25,0,0,0\n1.25,1.5,0,0\n"}}) {}
  StepRecord step() {
    const StepRecord record = simulation.step();
    double scale = 1 + record.ledger.kinetic + std::abs(record.ledger.potential);
    for (const double work : record.ledger.works) scale += std::abs(work);
    if (scene.contact.integrator == Integrator::reference) {
      EXPECT_LT(std::abs(record.ledger.imbalance), 1e-9 * scale) << record.t;
      // The load of the carriage is Simbody's; it must explain the momentum that hull and parts gain.
      EXPECT_LT(record.momentum_imbalance, 1e-9 * (1 + record.momentum_scale)) << record.t;
      EXPECT_LT(record.angular_momentum_imbalance, 1e-9 * (1 + record.angular_momentum_scale)) << record.t;
    }
    return record;
  }
  StepRecord run(double t) {
    StepRecord record;
    while (simulation.time() < t - 1e-9) record = step();
    return record;
  }
  /// Pitch of the hull about y, from X towards -Z [rad].
  double pitch() const { return std::atan2(-bodies().R_GB[0](2, 0), bodies().R_GB[0](0, 0)); }
};

std::string settings(const std::string& integrator, double step, double friction = 0, double restitution = 0) {
  return "<time step='" + std::to_string(step) + "' end='1000'/><contact law='coulomb' solver='newton' " +
         "tolerance='1e-12' detection='speculative' stabilisation='none' integrator='" + integrator +
         "'><friction between='* *' static='" + std::to_string(friction) + "' kinetic='" + std::to_string(friction) +
         "' restitution='" + std::to_string(restitution) + "'/></contact>";
}

const std::string k_weightless = "<gravity value='0 0 0'/>";

/// The joint is at the centre of mass unless `carriage` moves it.
std::string towed(const std::string& carriage, const std::string& inside = "", const std::string& position = "0 0 3") {
  return "<vessel name='hull' hull='box.stl' position='" + position + "'><mass value='800'/><carriage " + carriage +
         "</carriage>" + inside + "</vessel>";
}

const std::string k_cells = "<force_balance kind='six-cells' stiffness='";

/// Loads are m a on the ramp, the weight in addition, and m V^2 / 2 of work. A step across the ramp's end has a share
/// of it.
TEST(ReferenceTowed, TheRampTakesMassTimesAcceleration) {
  const double speed = 0.6, ramp = 0.75, heading = 25 * k_deg;
  const Vec3 along(std::cos(heading), std::sin(heading), 0);
  for (const std::string shape : {"linear", "smooth"})
    for (const std::string balance : {"rigid", "prismatic"}) {
      const bool heaves = balance == "prismatic";
      Rig rig(settings("reference", 0.1) + (heaves ? k_weightless : "") +
              towed("speed='0.6' ramp='0.75' heading_deg='25' ramp_shape='" + shape + "'><force_balance kind='" +
                    balance + "'/>"));
      const auto speed_at = [&](double t) {
        const double s = std::min(1.0, t / ramp);
        return speed * (shape == "linear" ? s : s * s * (3 - 2 * s));
      };
      for (int k = 0; k < 10; ++k) {
        const StepRecord record = rig.step();
        const Vec3 gained = k_mass * (speed_at(record.t) - speed_at(record.t - 0.1)) / 0.1 * along;
        const Vec3 weight(0, 0, heaves ? 0 : k_mass * k_gravity);
        EXPECT_LT((record.vessel->carriage->about_com.force - gained - weight).norm(), 1e-9) << record.t;
        EXPECT_LT(record.vessel->carriage->about_joint.torque.norm(), 1e-9);
        EXPECT_LT((record.vessel->state.v - speed_at(record.t) * along).norm(), 1e-14);
      }
      const Ledger& ledger = rig.step().ledger;
      EXPECT_NEAR(ledger.works.back(), 0.5 * k_mass * speed * speed, 1e-9);
      EXPECT_LT((rig.bodies().p_GB[0] - Vec3(0, 0, 3) - speed * (1.1 - 0.5 * ramp) * along).norm(), 1e-13);
    }
}

/// Pitch of a bar about a pivot that accelerates by `a` until `ramp`: (I + m L^2) pitch'' = m L (a cos - g sin).
VecX exact_swing(double inertia, double mass, double arm, double a, double ramp, double t, VecX y) {
  for (const auto& [pull, from, to] : {std::tuple(a, 0.0, std::min(t, ramp)), std::tuple(0.0, ramp, t)}) {
    if (!(to > from)) continue;
    numerics::EventOde ode;
    ode.derivative = [=, drive = pull](double, const VecX& x, VecX& dx) {
      dx.resize(2);
      dx << x[1], mass * arm * (drive * std::cos(x[0]) - k_gravity * std::sin(x[0])) / (inertia + mass * arm * arm);
    };
    numerics::OdeSettings settings;
    settings.relative = 1e-14;
    settings.absolute = VecX::Constant(2, 1e-14);
    numerics::OdeSolution solution(std::move(ode), settings, from, y);
    solution.follow(to, y);
  }
  return y;
}

/// The hull hangs 0.8 m below its joint, which passes no torque about the free pitch.
TEST(ReferenceTowed, SwingsOnItsFreePitch) {
  const double inertia = k_mass / 12 * (4 + 0.25), arm = 0.8;
  const std::string free = "speed='3' ramp='1.05' joint='0 0 0.8' free='pitch'>";
  for (const std::string& balance : {std::string(""), std::string("<force_balance kind='rigid'/>")}) {
    Rig rig(settings("reference", 0.1) + towed(free + balance));
    for (const double t : {0.5, 1.0, 2.0, 4.0}) {
      while (rig.simulation.time() < t - 1e-9) {
        const StepRecord record = rig.step();
        EXPECT_NEAR(record.vessel->carriage->about_joint.torque.y(), 0, 1e-8);
      }
      const VecX y = exact_swing(inertia, k_mass, arm, 3 / 1.05, 1.05, t, VecX::Zero(2));
      EXPECT_NEAR(rig.pitch(), y[0], 1e-10) << t;
      EXPECT_NEAR(rig.bodies().w_GB[0].y(), y[1], 1e-10) << t;
    }
  }
}

/// A bar that hangs on the hull by a hinge swings as its own pendulum, and both its loads are on the carriage.
TEST(ReferenceTowed, APartSwingsUnderTheHull) {
  const double mass = 3, arm = 0.4, inertia = mass / 12 * (0.64 + 0.01);
  Rig rig(settings("reference", 0.1) + towed("speed='2' ramp='0.55'>",
                                             "<part name='bar' joint='hinge' axis='0 1 0' at='0 0 -1' "
                                             "position='0 0 -1.4' size='0.1 0.1 0.8' mass='3'/>"));
  double force = 0;
  for (const double t : {0.5, 1.5}) {
    StepRecord record;
    while (rig.simulation.time() < t - 1e-9) {
      record = rig.step();
      force += 0.1 * record.vessel->carriage->about_com.force.x();
      EXPECT_LT(record.vessel->parts[0].unbalanced_force + record.vessel->parts[0].unbalanced_torque, 1e-9);
    }
    VecX start = VecX::Zero(2);
    const VecX y = exact_swing(inertia, mass, arm, 2 / 0.55, 0.55, t, start);
    EXPECT_NEAR(record.vessel->parts[0].coordinates[0], y[0], 1e-10) << t;
    EXPECT_NEAR(record.vessel->parts[0].rates[0], y[1], 1e-10) << t;
  }
  EXPECT_NEAR(force, k_mass * 2 + mass * rig.bodies().v_GB[1].x(), 1e-8);
}

/// Speed of x'' + 2 zeta omega x' + omega^2 x = -a from rest, t after the acceleration stepped in.
double ringing_speed(double omega, double zeta, double a, double t) {
  const double damped = omega * std::sqrt(1 - zeta * zeta);
  return t > 0 ? -a * std::exp(-zeta * omega * t) * std::sin(damped * t) / damped : 0;
}

/// Cell 1 alone holds surge; it takes the steps of the acceleration at both ends of the ramp.
TEST(ReferenceTowed, SurgeOnCellsIsTheDampedOscillator) {
  const double omega = 12, zeta = 0.1, speed = 0.6, ramp = 0.55, a = speed / ramp, h = 0.1;
  Rig rig(settings("reference", h) + k_weightless +
          towed("speed='0.6' ramp='0.55'>" + k_cells + std::to_string(k_mass * omega * omega) + "' damping='" +
                std::to_string(2 * zeta * omega * k_mass) + "'/>"));
  const auto speed_at = [&](double t) {
    return speed * std::min(1.0, t / ramp) + ringing_speed(omega, zeta, a, t) - ringing_speed(omega, zeta, a, t - ramp);
  };
  for (int k = 0; k < 20; ++k) {
    const StepRecord record = rig.step();
    EXPECT_TRUE(record.vessel->has_cells);
    EXPECT_NEAR(record.vessel->carriage->cells[0], k_mass * (speed_at(record.t) - speed_at(record.t - h)) / h, 1e-8);
    EXPECT_NEAR(record.vessel->state.v.x(), speed_at(record.t), 1e-12);
    for (std::size_t cell = 1; cell < 6; ++cell) EXPECT_NEAR(record.vessel->carriage->cells[cell], 0, 1e-8);
  }
}

/// A step of force: the weight comes onto three unloaded cells; elastic, so it rings for ever.
TEST(ReferenceTowed, TheWeightRingsOnUnloadedCells) {
  const double omega = 30, stiffness = k_mass * omega * omega / 3, h = 0.05;
  Rig rig(settings("reference", h) +
          towed("start='as-placed'>" + k_cells + std::to_string(stiffness) + "' damping='0'/>"));
  for (int k = 0; k < 40; ++k) {
    const StepRecord record = rig.step();
    const auto speed_at = [&](double t) { return -k_gravity / omega * std::sin(omega * t); };
    const double expected = k_mass * (k_gravity + (speed_at(record.t) - speed_at(record.t - h)) / h) / 3;
    for (const std::size_t cell : {3u, 4u, 5u}) EXPECT_NEAR(record.vessel->carriage->cells[cell], expected, 1e-7);
  }
  // from the equilibrium nothing rings
  Rig still(settings("reference", h) + towed(">" + k_cells + std::to_string(stiffness) + "' damping='0'/>"));
  for (int k = 0; k < 10; ++k) EXPECT_NEAR(still.step().vessel->carriage->cells[3], k_mass * k_gravity / 3, 1e-8);
}

const std::string k_water = "<water density='1000' level='0'/><hydro><buoyancy/></hydro>";

/// Vertical sides: omega^2 = g / draught at any amplitude that keeps the deck dry.
TEST(ReferenceTowed, FreeHeaveIsTheOscillator) {
  const double draught = k_mass / 2000, omega = std::sqrt(k_gravity / draught);
  Rig rig(settings("reference", 0.1) + k_water +
          towed("speed='1' ramp='0.5' free='heave' start='as-placed'>", "",
                "0 0 " + std::to_string(0.25 - draught + 0.02)));
  for (int k = 0; k < 30; ++k) {
    const StepRecord record = rig.step();
    EXPECT_NEAR(record.vessel->state.pose.p.z(), 0.25 - draught + 0.02 * std::cos(omega * record.t), 1e-10);
    EXPECT_NEAR(record.vessel->carriage->about_com.force.z(), 0, 1e-8);
  }
}

/// A box that lies ahead is pushed with m a; a ball that is struck leaves a rigid hull at twice its speed.
TEST(ReferenceTowed, PushesAndStrikes) {
  for (const std::string& balance :
       {std::string("rigid'/>"), std::string("six-cells' stiffness='1e6' damping='1e4'/>")}) {
    Rig push(settings("reference", 0.1) + k_weightless + towed("speed='1' ramp='0.5'><force_balance kind='" + balance) +
             "<body name='box' shape='box' size='0.5 0.5 0.5' mass='200' position='1.25 0 3'/>");
    Vec3 on_hull = Vec3::Zero(), held = Vec3::Zero();
    for (int k = 0; k < 5; ++k) {
      const StepRecord record = push.step();
      on_hull += 0.1 * record.vessel->contact.force;
      held += 0.1 * record.vessel->carriage->about_com.force;
    }
    EXPECT_NEAR(on_hull.x(), -200 * push.bodies().v_GB[1].x(), 1e-8);
    EXPECT_NEAR(held.x(), 200 * push.bodies().v_GB[1].x() + k_mass * push.bodies().v_GB[0].x(), 1e-8);
    if (balance[0] == 'r') {
      EXPECT_NEAR(push.bodies().v_GB[1].x(), 1, 1e-9);
      EXPECT_NEAR(held.x(), 1000, 1e-7);
    }

    Rig strike(settings("reference", 0.1, 0, 1) + k_weightless + towed("speed='1'><force_balance kind='" + balance) +
               "<body name='ball' shape='sphere' radius='0.2' mass='5' position='1.25 0 3'/>");
    const StepRecord record = strike.step();
    const bool rigid = balance[0] == 'r';
    // cells give nothing in an impact: that is of two free bodies
    EXPECT_NEAR(strike.bodies().v_GB[1].x(), rigid ? 2 : 2 * k_mass / (k_mass + 5), 1e-12);
    EXPECT_NEAR(record.vessel->contact.force.x(), -5 * strike.bodies().v_GB[1].x() / 0.1, 1e-9);
    if (rigid) {
      EXPECT_NEAR(record.vessel->carriage->about_com.force.x(), 100, 1e-9);
      EXPECT_NEAR(record.ledger.works.back(), 10, 1e-9);
    }
  }
}

/// A path that begins at speed takes the vessel along at once, and a pendulum begins to swing.
TEST(ReferenceTowed, AJumpOfTheSpeedIsAnImpulse) {
  const double inertia = k_mass / 12 * (4 + 0.25), arm = 0.8;
  const double rate = k_mass * arm * 1.5 / (inertia + k_mass * arm * arm);
  Rig rig(settings("reference", 0.1) + towed("joint='0 0 0.8' free='pitch'><path file='track.csv'/>"));
  double impulse = 0;
  for (int k = 0; k < 8; ++k) impulse += 0.1 * rig.step().vessel->carriage->about_com.force.x();
  VecX start(2);
  start << 0, rate;
  const VecX y = exact_swing(inertia, k_mass, arm, 0, 0, 0.8 - 0.25, start);
  EXPECT_NEAR(rig.pitch(), y[0], 1e-10);
  EXPECT_NEAR(rig.bodies().w_GB[0].y(), y[1], 1e-10);
  EXPECT_NEAR(impulse, k_mass * rig.bodies().v_GB[0].x(), 1e-8);
}

/// Heave and pitch of a moving barge, on rigid axes and on oscillating cells.
TEST(ReferenceTowed, TheSchemesApproachIt) {
  const std::string rigid = towed("speed='1' ramp='0.8' ramp_shape='smooth' joint='0.6 0 0.2' free='heave pitch'>", "",
                                  "0 0"),
                    cells = towed("speed='1' ramp='0.8' ramp_shape='smooth' joint='0.2 0 0.1' free='heave'>" + k_cells +
                                      "8e4' damping='300'/>",
                                  "", "0 0");
  for (const std::string& scene : {rigid, cells}) {
    Rig exact(settings("reference", 0.1) + k_water + scene);
    exact.run(1);
    for (const auto& [integrator, order] : {std::pair("semi-implicit-euler", 1.0), std::pair("moreau", 2.0)}) {
      double last = 0;
      for (const double step : {0.01, 0.005, 0.0025}) {
        Rig rig(settings(integrator, step) + k_water + scene);
        rig.run(1);
        const double error = (rig.bodies().p_GB[0] - exact.bodies().p_GB[0]).norm() +
                             (rig.bodies().v_GB[0] - exact.bodies().v_GB[0]).norm() +
                             (rig.bodies().w_GB[0] - exact.bodies().w_GB[0]).norm();
        if (last > 0) {
          EXPECT_NEAR(std::log2(last / error), order, 0.15) << integrator << " " << last << " " << error;
        }
        last = error;
      }
      EXPECT_LT(last, 0.01);
    }
  }
}

}  // namespace reference_towed_test
