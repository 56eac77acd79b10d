/// Scenes with as many modules as can stand together. Their accounts close to rounding, and their bits depend neither
/// on the number of threads nor on a checkpoint in the middle of the run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/core/sim/together/all_modules.h"
#include "tests/core/sim/together/step_bits.h"

namespace accounts_test {

using namespace nilas;
using namespace nilas::sim;

struct Case {
  std::string name, scene;
  std::vector<std::string> modules;  ///< of which each must be built
  int broken = 0;                    ///< least number of floes that must break
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const test::TurnedScene k_as_is;
const std::string k_step = "<time step='0.1' end='1000'/><seed value='5'/>";

std::string hydro(const std::string& inside) { return "<hydro><buoyancy/><drag/>" + inside + "</hydro>"; }

/// Water of the database: its added mass, and the loads of waves with slow drift.
std::string of_database(const std::string& inside, const std::string& jets = test::k_jets) {
  return hydro("<added_mass vessel='database'/><wave_loads vessel='database' drift='newman'/>" + inside + jets +
               test::k_database);
}

const std::string k_still = "velocity='0.3 0 0'";

std::string scene(const std::string& contact, const std::string& water, const std::string& loads,
                  const std::string& vessel, const std::string& ice = test::k_breaking_ice) {
  return k_step + test::contact(contact) + water + loads + test::wind() + vessel + ice;
}

const std::string k_positioned = test::ship_thrusters("setpoint='3 -2' heading_deg='4' " + test::k_noisy_sensors);

/// A pod on a hinge, a barge pushed ahead of the stern on a ball joint, and a strut from the barge to a quay.
const std::string k_parts =
    "<part name='pod' joint='hinge' shape='box' size='6 2 5' mass='1e5' position='20 0 -2' at='20 0 0' "
    "stiffness='1e6' damping='1e5'/>"
    "<part name='barge' joint='ball' shape='box' size='30 20 6' mass='2.4e6' position='-20 0 11' at='-2 0 12'/>"
    "<rod name='strut' on='barge' at='-35 0 12' to='-135 -60 2'/>";

/// Thrusters of positioning, whose mass is that of the hull without its parts.
const std::string k_free_thrusters =
    "<thrusters><thruster name='port' kind='azimuth' at='32 8 1' max_thrust='1.2e6' power='9e6' lag='1.5' thrust='5e5' "
    "angle_deg='30'/><thruster name='main' kind='propeller' at='32 0 3' max_thrust='1.5e6' power='1e7' "
    "thrust='3e5'/></thrusters><control mode='dp' most_offset='50'/>";

/// The same ice, which meets a ship that holds its station fast enough to break.
std::string fast_ice() {
  std::string ice = test::k_breaking_ice;
  const std::string slow = "velocity='-1.5 0 0'";
  return ice.replace(ice.find(slow), slow.size(), "velocity='-4 0 0'");
}

const std::string k_profile = "profile='profile.csv' series='series.csv'";

std::string manoeuvring(const std::string& manoeuvre) {
  return "<manoeuvring preset='kvlcc2' length='200' midship='100'/>" + manoeuvre +
         "<thrusters><thruster name='bow' kind='tunnel' at='180 0 4' max_thrust='8e5' power='6e6' lag='1' "
         "thrust='3e5'/></thrusters>";
}
const std::string k_steered_jets =
    "<propeller_wash><jet thruster='propeller' diameter='6' position='2 0 3'/>"
    "<jet thruster='bow' diameter='3' position='180 0 4' direction='0 1 0'/></propeller_wash>";
const std::string k_towed_jet = "<propeller_wash><jet thrust='5e5' diameter='6' position='2 0 3'/></propeller_wash>";

std::vector<Case> cases() {
  const std::string theta = "law='coulomb' tolerance='1e-6' integrator='moreau' ";
  const std::vector<std::string> water{"buoyancy", "drag", "added_mass", "wave_loads", "wind", "propeller_wash"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = water;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  return {
      {"MooredWithThrusters",
       scene(theta + "solver='auto'", test::sea(), of_database("<radiation order='4'/>"),
             test::ship(k_positioned + test::ship_mooring(), k_as_is, k_still), fast_ice()),
       with({"radiation", "mooring", "thruster", "control", "crushing", "breaking"}), 1},
      {"PositionedByDatabaseAlone",
       scene(theta + "solver='nsgs' theta='1'", test::sea(),
             of_database("<restoring/><radiation model='convolution'/>"), test::ship(k_positioned, k_as_is, k_still),
             fast_ice()),
       with({"restoring", "radiation", "thruster", "control", "crushing", "breaking"}), 1},
      {"CurrentOfTables",
       scene("law='pyramid' solver='pgs' tolerance='1e-6' integrator='moreau'", test::sea(k_as_is, k_profile),
             hydro("<wave_loads diffraction='database'/>" + test::k_jets + test::k_database),
             test::ship(k_positioned + test::ship_mooring(), k_as_is, k_still), fast_ice()),
       {"wave_loads", "wind", "propeller_wash", "mooring", "thruster", "control", "crushing", "breaking"},
       1},
      {"PartsAndRods",
       scene("solver='nsgs' tolerance='1e-6' integrator='semi-implicit-euler' substeps='4'", test::sea(),
             of_database("<radiation order='4'/>"),
             test::ship(k_parts + k_free_thrusters + test::ship_mooring(k_as_is, "start='as-placed'"), k_as_is, "",
                        2.5e6)),
       with({"radiation", "mooring", "thruster", "control", "crushing", "breaking"}), 1},
      {"Zigzag",
       scene(theta + "solver='newton'", test::sea(),
             hydro("<restoring/><added_mass/><wave_loads vessel='database' drift='newman'/>" + k_steered_jets +
                   test::k_database),
             test::ship(manoeuvring("<manoeuvre kind='zigzag' start='1' angle_deg='20' heading_deg='0.05'/>"), k_as_is,
                        "velocity='5 0 0'")),
       with({"restoring", "manoeuvring", "manoeuvre", "thruster", "crushing", "breaking"}), 1},
      {"TowedOnCells",
       scene(theta + "solver='newton'", test::sea(), of_database("<radiation order='4'/>", k_towed_jet),
             test::ship("<carriage speed='3' ramp='2'><force_balance kind='six-cells'/></carriage>")),
       with({"radiation", "crushing", "breaking"}), 1},
      {"TowedFreeToPitch",
       scene("solver='nsgs' tolerance='1e-6' integrator='semi-implicit-euler'", test::sea(),
             of_database("<radiation model='convolution'/>", k_towed_jet),
             test::ship("<carriage speed='3' ramp='2' free='heave pitch roll'/>")),
       with({"radiation", "crushing", "breaking"}), 1},
  };
}

test::SceneRig::Files files() {
  test::SceneRig::Files all = test::ship_files();
  all["profile.csv"] = "z_m,u_m_s,v_m_s\n0,-0.4,0.1\n-20,-0.2,0\n-80,0,0\n";
  all["series.csv"] = "t_s,u_m_s,v_m_s\n0,0,0\n2,0.3,-0.2\n30,-0.5,0.4\n";
  return all;
}

class Together : public testing::TestWithParam<Case> {
 protected:
  test::SceneRig rig(int threads = 1) { return test::SceneRig(GetParam().scene, threads, files()); }
};

/// The work and energy that passed between bodies, water and air so far [J].
double turnover(const Ledger& energy) {
  double sum = energy.kinetic + std::abs(energy.friction) + std::abs(energy.impact) + std::abs(energy.crushing) +
               std::abs(energy.fracture) + std::abs(energy.integrator) + std::abs(energy.stabilisation);
  for (const double work : energy.works) sum += std::abs(work);
  return sum;
}

constexpr int k_steps = 60, k_middle = 33;

TEST_P(Together, AccountsCloseAndBitsStay) {
  test::SceneRig whole = rig(), threads = rig(2);
  const RunInfo& info = whole.simulation.info();
  for (const std::string& module : GetParam().modules)
    EXPECT_TRUE(std::any_of(info.modules.begin(), info.modules.end(), [&](const auto& m) { return m.first == module; }))
        << module;
  std::vector<test::StepBits> bits;
  State state;
  int contacts = 0, broken = 0;
  for (int k = 0; k < k_steps; ++k) {
    if (k == k_middle) whole.simulation.save(StateWriter(state));
    const StepRecord record = whole.balanced_step(1e-14, 0);
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-12 * turnover(record.ledger));
    contacts += record.contacts;
    broken += static_cast<int>(record.broken.size());
    bits.emplace_back(record);
    ASSERT_EQ(test::StepBits(threads.simulation.step()), bits.back()) << "two threads, step " << k + 1;
  }
  EXPECT_GT(contacts, 30);
  EXPECT_GE(broken, GetParam().broken);
  test::SceneRig rest = rig(2);
  rest.simulation.restore(StateReader(state));
  for (int k = k_middle; k < k_steps; ++k)
    ASSERT_EQ(test::StepBits(rest.simulation.step()), bits[static_cast<std::size_t>(k)]) << "resumed, step " << k + 1;
}

INSTANTIATE_TEST_SUITE_P(All, Together, testing::ValuesIn(cases()), [](const auto& c) { return c.param.name; });

}  // namespace accounts_test
