/// What a scene with many modules does not depend on: the direction of the ground's X axis, the side of the ship, the
/// order of its elements, and its scale.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "tests/core/sim/together/all_modules.h"
#include "tests/core/sim/together/step_bits.h"

namespace invariance_test {

using namespace nilas;
using namespace nilas::sim;
using test::SceneRig;
using test::TurnedScene;

const std::string k_time = "<time step='0.1' end='1000'/><seed value='5'/>";

/// Loads of the database, or of the pressure on the hull, on the ship that is moored and holds its station.
std::string hydro(const std::string& waves, const std::string& jets) {
  return "<hydro><buoyancy/><drag/><added_mass vessel='database'/><radiation order='4'/><wave_loads " + waves + "/>" +
         jets + test::k_database + "</hydro>";
}

std::string contact(const std::string& solver = "newton") {
  return test::contact("solver='" + solver + "' tolerance='1e-11' integrator='moreau'");
}

/// Two floes at the bow, of which one touches it, and one in the wash of the stern.
std::string floes(const TurnedScene& turned, bool backwards = false) {
  const auto floe = [&](const std::string& name, double x, double y, double along, double across, double u, double v) {
    std::vector<Vec2> corners{{x, y}, {x + along, y}, {x + along, y + across}, {x, y + across}};
    if (turned.side() < 0) std::reverse(corners.begin(), corners.end());
    return "<floe name='" + name + "' outline='" + turned.outline(corners) + "' velocity='" + turned.at(u, v, 0) +
           "'/>";
  };
  std::vector<std::string> all{floe("one", 100.5, -11, 25, 18, -1.2, 0.1), floe("two", 102, 8.5, 20, 14, -0.8, -0.1),
                               floe("three", -140, 4, 24, 16, 0.2, 0)};
  if (backwards) std::reverse(all.begin(), all.end());
  return "<ice density='910' thickness='1'>" + all[0] + all[1] + all[2] + "</ice>";
}

std::string moored(const TurnedScene& turned, const std::string& waves = "vessel='database' drift='newman'",
                   const std::string& spreading = "spreading='12'", bool backwards = false) {
  const std::string place = turned.at(3, -2), heading = turned.heading(4);
  const std::string jets = "<propeller_wash><jet thruster='port' diameter='4' position='12 " +
                           test::text(8 * turned.side()) +
                           " 1'/><jet thruster='main' diameter='7' position='5 0 3'/></propeller_wash>";
  return k_time + contact() + test::sea(turned, "", spreading) + hydro(waves, jets) + test::wind(turned) +
         test::ship(test::ship_thrusters("setpoint='" + place + "' heading_deg='" + heading + "'", turned) +
                        test::ship_mooring(turned),
                    turned, "velocity='" + turned.at(0.3, 0.1, 0) + "'") +
         floes(turned, backwards);
}

std::string sailing(const TurnedScene& turned) {
  return k_time + contact() + test::sea(turned) +
         "<hydro><buoyancy/><drag/><restoring/><added_mass/><wave_loads vessel='database' drift='newman'/>"
         "<propeller_wash><jet thruster='propeller' diameter='6' position='2 0 3'/></propeller_wash>" +
         test::k_database + "</hydro>" + test::wind(turned) +
         test::ship("<manoeuvring preset='kvlcc2' length='200' midship='100'/><manoeuvre kind='course' heading_deg='" +
                        turned.heading(10) + "' speed='3'/>",
                    turned, "velocity='" + turned.at(3, 0, 0) + "'") +
         floes(turned);
}

/// Compares a scene with its image, whose loads and motions must be the images of those of the scene, to `share` of the
/// largest so far.
class Images {
 public:
  Images(const std::string& scene, const std::string& image, const TurnedScene& turned, double share)
      : one_(scene, 1, test::ship_files()), other_(image, 1, test::ship_files()), turned_(turned), share_(share) {}

  void expect(int steps) {
    int contacts = 0;
    for (int k = 0; k < steps && !testing::Test::HasFailure(); ++k) {
      SCOPED_TRACE("step " + std::to_string(k + 1));
      const StepRecord a = one_.simulation.step(), b = other_.simulation.step();
      contacts += a.contacts;
      compare(*a.vessel, *b.vessel);
      compare_floes();
    }
    EXPECT_GT(contacts, steps / 3);
  }

 private:
  void compare(const std::string& what, const Wrench& a, const Wrench& b) {
    Vec2& most = largest_.emplace(what, Vec2::Zero()).first->second;
    most = most.cwiseMax(Vec2(a.force.norm(), a.torque.norm()));
    EXPECT_LE((turned_.of(a.force) - b.force).norm(), share_ * most.x()) << what;
    // Torques and angular velocities keep the sense of a turn about the mirror's normal.
    EXPECT_LE((turned_.side() * turned_.of(a.torque) - b.torque).norm(), share_ * most.y()) << what;
  }
  void compare(const VesselRecord& a, const VesselRecord& b) {
    compare("water", *a.hydro, *b.hydro);
    compare("contact", a.contact, b.contact);
    for (std::size_t m = 0; m < a.module_loads.size(); ++m)
      compare(one_.simulation.info().vessel_loads[m], a.module_loads[m], b.module_loads[m]);
    compare("velocities", {a.state.v, a.state.w}, {b.state.v, b.state.w});
    compare("place", {a.state.pose.p, Vec3::Zero()}, {b.state.pose.p, Vec3::Zero()});
  }
  void compare_floes() {
    const bodies::Bodies &a = one_.bodies(), &b = other_.bodies();
    for (std::size_t floe = 1; floe < a.name.size(); ++floe) {
      const auto image =
          static_cast<std::size_t>(std::find(b.name.begin(), b.name.end(), a.name[floe]) - b.name.begin());
      ASSERT_LT(image, b.name.size());
      compare(a.name[floe], {a.v_GB[floe], a.w_GB[floe]}, {b.v_GB[image], b.w_GB[image]});
    }
  }

  SceneRig one_, other_;
  TurnedScene turned_;
  double share_;
  std::map<std::string, Vec2> largest_;  ///< of forces and torques
};

constexpr double k_rounding = 1e-7;

TEST(Invariance, TurnsWithTheScene) {
  const TurnedScene turned(30);
  Images(moored(TurnedScene()), moored(turned), turned, k_rounding).expect(60);
}

TEST(Invariance, TurnsWithTheSceneOfPressureOnTheHull) {
  const TurnedScene turned(-131);
  const std::string waves = "diffraction='database'";
  Images(moored(TurnedScene(), waves), moored(turned, waves), turned, k_rounding).expect(60);
}

TEST(Invariance, TurnsWithTheSceneOfAShipThatSails) {
  const TurnedScene turned(30);
  Images(sailing(TurnedScene()), sailing(turned), turned, k_rounding).expect(60);
}

/// The mesh and the database of the ship are symmetric to rounding of their files. Directions of a spread sea are drawn
/// to one side first, so the sea has none.
TEST(Invariance, IsTheSameOnTheOtherSide) {
  const TurnedScene mirrored(0, -1);
  const std::string waves = "vessel='database' drift='newman'";
  Images(moored(TurnedScene(), waves, ""), moored(mirrored, waves, ""), mirrored, 1e-5).expect(60);
}

TEST(Invariance, OrderOfFloesChangesRoundingAlone) {
  const TurnedScene as_is;
  const std::string waves = "vessel='database' drift='newman'", spreading = "spreading='12'";
  Images(moored(as_is), moored(as_is, waves, spreading, true), as_is, k_rounding).expect(60);
}

/// The order in which a scene names its elements decides no bit.
TEST(Invariance, OrderOfElementsDecidesNoBit) {
  const TurnedScene as_is;
  const std::string inside = test::ship_thrusters("") + test::ship_mooring();
  const std::string mooring = test::ship_mooring() + test::ship_thrusters("");
  const std::string still = "velocity='0.3 0.1 0'", waves = "<wave_loads vessel='database' drift='newman'/>";
  SceneRig one(k_time + contact("auto") + test::sea() +
                   "<hydro><buoyancy/><drag/><added_mass vessel='database'/><radiation order='4'/>" + waves +
                   test::k_jets + test::k_database + "</hydro>" + test::wind() + test::ship(inside, as_is, still) +
                   floes(as_is),
               1, test::ship_files());
  SceneRig other(floes(as_is) + test::ship(mooring, as_is, still) + test::wind() + "<hydro>" + test::k_database +
                     test::k_jets + waves +
                     "<radiation order='4'/><added_mass vessel='database'/><drag/><buoyancy/></hydro>" + test::sea() +
                     contact("auto") + k_time,
                 1, test::ship_files());
  for (int k = 0; k < 30; ++k)
    ASSERT_EQ(test::StepBits(other.simulation.step()), test::StepBits(one.simulation.step())) << k;
}

}  // namespace invariance_test
