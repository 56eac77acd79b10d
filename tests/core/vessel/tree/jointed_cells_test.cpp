/// A vessel of several bodies on six load cells.
#include <cmath>

#include "core/base/error.h"
#include "core/vessel/model/cells.h"
#include "tests/core/vessel/tree/jointed_example.h"

namespace nilas::vessel {
namespace jointed_cells_test {

constexpr double k_h = 0.01;
const std::vector<std::optional<double>> k_schemes{std::nullopt, 0.5};

VesselModel on_cells(std::optional<double> theta, double stiffness, double damping_time) {
  VesselModel model = example::carried(BalanceKind::six_cells);
  model.theta = theta;
  model.carriage->stiffness = stiffness;
  model.carriage->damping = damping_time * stiffness;
  return model;
}

/// A pendulum on a hinge across the hull.
PartModel pendulum() {
  PartModel part;
  part.mass = 40;
  part.inertia_B = Vec3(2, 3, 1).asDiagonal();
  part.point_V = {1.2, 0.1, -0.3};
  part.axis_V = Vec3::UnitY();
  part.in_V.p = {1.2, 0.1, -1.1};
  part.coordinate = 0.8;
  return part;
}

double total_energy(const VesselModel& model, const VesselSystem& system) {
  double energy = example::totals(model, system).kinetic + system.spring_energy();
  energy += example::k_gravity * model.mass.mass * system.state().pose.p.z();
  for (std::size_t k = 0; k < model.parts.size(); ++k)
    energy += example::k_gravity * model.parts[k].mass * system.parts()[k].state.pose.p.z();
  return energy;
}

/// The sum of the readings is the rate of change of all momenta less the weights, and Simbody gives the same.
TEST(JointedCells, ReadWhatTheMomentaLack) {
  for (const auto theta : k_schemes)
    for (const double stiffness : {1e5, 1e7, 1e10}) {
      VesselModel model = on_cells(theta, stiffness, 1e-3);
      model.parts = example::chain().parts;
      const Vec3 start = model.pose_V.p + model.pose_V.q * model.mass.com;
      model.carriage->motion = CarriageMotion::straight(start, 0.3, 2, 0.4, 0.5, 0);
      VesselSystem system(model, 0);
      const std::vector<Wrench> weights = example::weights(model);
      Vec3 weight = Vec3::Zero();
      for (const Wrench& load : weights) weight += load.force;
      for (int k = 0; k < 100; ++k) {
        const Vec6 before = example::totals(model, system).momentum;
        example::step(system, weights, k_h);
        const Vec3 lack = (example::totals(model, system).momentum - before).head<3>() / k_h - weight;
        const CarriageLoads& read = system.carriage_loads();
        ASSERT_LT((read.about_com.force - lack).norm(), 1e-5 * weight.norm()) << stiffness << " " << k;
        const Wrench& apart = read.disagreement.value();
        ASSERT_LT(apart.force.norm() + apart.torque.norm(), 1e-5 * weight.norm()) << stiffness << " " << k;
        const Vec6 sum = cell_wrenches(model.carriage->cells) * Eigen::Map<const Vec6>(read.cells.data());
        const Quat R(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
        ASSERT_LT((R * sum.tail<3>() - read.about_joint.force).norm(), 1e-9 * weight.norm());
        ASSERT_LT((R * sum.head<3>() - read.about_joint.torque).norm(), 1e-9 * weight.norm());
      }
    }
}

/// A welded part at rest: the cells settle to the weight of both, to the last digits.
TEST(JointedCells, SettleToTheWeightOfAllBodies) {
  for (const auto theta : k_schemes) {
    VesselModel model = on_cells(theta, 1e7, 1e-3);
    model.parts = {example::part(JointKind::weld)};
    VesselSystem system(model, 0);
    for (int k = 0; k < 1500; ++k) example::step(system, example::weights(model), k_h);
    const auto& cells = system.carriage_loads().cells;
    const double weight = example::k_gravity * (model.mass.mass + model.parts[0].mass);
    EXPECT_NEAR(cells[3] + cells[4] + cells[5], weight, 1e-9 * weight);
    // about the joint, which is the hull's centre of mass: the part's lever in the carriage's axes
    const Vec3 arm = model.parts[0].in_V.p - model.mass.com;
    const double pitch = example::k_arm * (cells[3] - 0.5 * (cells[4] + cells[5]));
    EXPECT_NEAR(pitch, example::k_gravity * model.parts[0].mass * arm.x(), 1e-6 * weight);
  }
}

/// One welded body is the one body that both are together.
TEST(JointedCells, WeldedPartsAreOneBodyWithTheHull) {
  for (const auto theta : k_schemes) {
    VesselModel model = on_cells(theta, 2e5, 1e-3);
    PartModel twin;  // The part has the hull's own position, so that the joint stays at the centre of mass.
    twin.joint = JointKind::weld;
    twin.mass = model.mass.mass;
    twin.inertia_B = model.mass.inertia;
    twin.point_V = twin.in_V.p = model.mass.com;
    VesselModel whole = model;
    whole.mass.mass *= 2;
    whole.mass.inertia *= 2;
    model.parts = {twin};
    VesselSystem two(model, 0), one(whole, 0);
    for (int k = 0; k < 200; ++k) {
      const double t = k * k_h;
      const Wrench load{Vec3(300 * std::sin(9 * t), 200, -150), Vec3(20, 30 * std::cos(5 * t), -40)};
      const Wrench blow = k == 50 ? Wrench{Vec3(20, -10, 5), Vec3(1, 2, 3)} : Wrench{};
      example::step(two, {load, {}}, k_h, {blow, {}});
      example::step(one, load, k_h, blow);
      for (std::size_t c = 0; c < 6; ++c)
        ASSERT_NEAR(two.carriage_loads().cells[c], one.carriage_loads().cells[c], 0.2) << k << " " << c;
    }
    EXPECT_LT((two.state().pose.p - one.state().pose.p).norm(), 1e-7);
    EXPECT_LT(two.state().pose.q.angularDistance(one.state().pose.q), 1e-7);
  }
}

/// Soft cells without damping are springs as any: energy stays, to the order of the scheme.
TEST(JointedCells, KeepEnergyWithoutDamping) {
  double last = 0;
  for (const double h : {4e-3, 2e-3}) {
    VesselModel model = on_cells(0.5, 4e5, 0);
    model.parts = {pendulum()};
    VesselSystem system(model, 0);
    const double start = total_energy(model, system);
    double worst = 0;
    for (int k = 0; k < std::lround(2 / h); ++k) {
      example::step(system, example::weights(model), h);
      worst = std::max(worst, std::abs(total_energy(model, system) - start));
    }
    EXPECT_LT(worst, 0.1) << "of some 100 J that go to and fro";
    if (last > 0) {
      EXPECT_GT(last / worst, 3);
    }
    last = worst;
  }
}

/// The harder the cells, the nearer to a hull that is held rigidly.
TEST(JointedCells, HardCellsHoldAsARigidCarriage) {
  for (const auto theta : k_schemes) {
    VesselModel rigid = on_cells(theta, 1, 0);
    rigid.carriage->balance = BalanceKind::rigid;
    rigid.parts = {pendulum()};
    VesselModel hard = on_cells(theta, 1e11, 1e-4);
    hard.parts = rigid.parts;
    VesselSystem held(rigid, 0), sprung(hard, 0);
    for (int k = 0; k < 300; ++k) {
      example::step(held, example::weights(rigid), k_h);
      example::step(sprung, example::weights(hard), k_h);
      if (k < 10) continue;  // the start from unloaded cells
      const Vec3 apart = held.carriage_loads().about_joint.force - sprung.carriage_loads().about_joint.force;
      ASSERT_LT(apart.norm(), 1e-2 * held.carriage_loads().about_joint.force.norm()) << k;
    }
    EXPECT_NEAR(held.parts()[0].coordinates[0], sprung.parts()[0].coordinates[0], 1e-4);
  }
}

TEST(JointedCells, AreRefusedWhereTheyCannotHold) {
  VesselModel model = on_cells(0.5, 0, 0);
  model.parts = {pendulum()};
  EXPECT_THROW(VesselSystem(model, 0), InputError);
}

TEST(JointedCells, GoOnFromTheirSavedStateWithTheSameBits) {
  VesselModel model = on_cells(0.5, 1e7, 1e-3);
  model.parts = example::chain().parts;
  VesselSystem whole(model, 0), second(model, 0);
  const auto loads = example::weights(model);
  for (int k = 0; k < 10; ++k) example::step(whole, loads, k_h);
  State state;
  whole.save(StateWriter(state));
  second.restore(StateReader(state));
  for (int k = 0; k < 10; ++k) {
    example::step(whole, loads, k_h);
    example::step(second, loads, k_h);
    ASSERT_EQ(whole.coordinates(), second.coordinates()) << k;
    ASSERT_EQ(whole.carriage_loads().cells, second.carriage_loads().cells) << k;
  }
}

}  // namespace jointed_cells_test
}  // namespace nilas::vessel
