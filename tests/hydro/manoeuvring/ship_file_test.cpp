/// Files of ships: what is read, and what is refused with file and line.
#include "hydro/manoeuvring/ship_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace nilas::ship_file_test {

using hydro::ManoeuvringShip;

const char* const k_hull =
    "length_m,100\ndraught_m,6\nm_x,0.02\nm_y,0.2\nJ_z,0.01\nY_v,-0.3\nY_r,0.08\nN_v,-0.1\nN_r,-0.05\n";
const char* const k_propeller = "max_rps,2\npropeller_diameter_m,4\nk_0,0.3\nk_1,-0.3\nk_2,-0.1\n";

class ShipFile : public ::testing::Test {
 protected:
  ManoeuvringShip read(const std::string& text, ManoeuvringModel model = ManoeuvringModel::mmg,
                       PropulsionKind propulsion = PropulsionKind::open_water) {
    std::ofstream(file_) << "# a comment\nname,value\n" << text;
    return hydro::read_ship(file_, model, propulsion, 9.81);
  }
  std::string fault(const std::string& text, ManoeuvringModel model = ManoeuvringModel::mmg,
                    PropulsionKind propulsion = PropulsionKind::open_water) {
    try {
      read(text, model, propulsion);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  }

  test::ScratchFolder folder_;
  std::string file_ = (folder_.path() / "ship.csv").string();
};

TEST_F(ShipFile, HoldsHullPropellerAndRudder) {
  const ManoeuvringShip ship =
      read(std::string(k_hull) + k_propeller + " rudder_area_m2 , 10 \nf_alpha,2.5\nx_R,-0.48\n");
  const auto& hull = std::get<hydro::MmgHull>(ship.hull);
  EXPECT_EQ(hull.length, 100);
  EXPECT_EQ(hull.N_r, -0.05);
  EXPECT_EQ(hull.X_vv, 0);
  EXPECT_EQ(std::get<hydro::OpenWaterPropeller>(ship.propulsion).k_2, -0.1);
  EXPECT_EQ(ship.max_rps, 2);
  EXPECT_EQ(ship.rudder.value().x_R, -0.48);
}

TEST_F(ShipFile, HoldsDerivativesAndAThrustCurve) {
  const ManoeuvringShip ship = read(
      "scaling,bis\nlength_m,80\nmass_kg,5e6\nX_udot,-0.1\nY_vdot,-0.9\nN_rdot,-0.06\nY_v|v|,-1\nX_u,-0.03\n"
      "max_rps,2\npower_W,10e6\npropeller_diameter_m,5\nscrews,1\nmax_speed_m_s,8\n",
      ManoeuvringModel::derivatives, PropulsionKind::thrust_curve);
  const auto& hull = std::get<hydro::DerivativesHull>(ship.hull);
  EXPECT_EQ(hull.terms.size(), 2u);
  EXPECT_EQ(hull.gravity, 9.81);
  const auto& curve = std::get<hydro::ThrustCurve>(ship.propulsion);
  EXPECT_NEAR(curve.pull, 1058.6e3, 100);
  EXPECT_EQ(curve.max_rps, 2);
  EXPECT_FALSE(ship.rudder.has_value());
}

TEST_F(ShipFile, RefusesWhatItCannotMean) {
  EXPECT_NE(fault(std::string(k_hull) + k_propeller + "Y_vw,1\n").find("ship.csv:17: unknown name 'Y_vw'"),
            std::string::npos);
  EXPECT_NE(fault(std::string(k_hull) + k_propeller + "max_rps,2\n").find("'max_rps' stands in line 12 already"),
            std::string::npos);
  EXPECT_NE(fault(k_propeller).find("'length_m' is missing"), std::string::npos);
  EXPECT_NE(fault(std::string(k_hull) + "max_rps,fast\n").find("'max_rps' is 'fast'; allowed: a finite number"),
            std::string::npos);
  EXPECT_NE(fault(std::string(k_hull) + "max_rps,0\n").find("allowed: > 0"), std::string::npos);
  EXPECT_NE(fault("length_m,1,2\n").find("ship.csv:3: found 3 fields"), std::string::npos);
  EXPECT_NE(fault("length_m,1\n", ManoeuvringModel::derivatives).find("'scaling' is missing; allowed: si, bis"),
            std::string::npos);
  EXPECT_NE(
      fault(std::string(k_hull) + "max_rps,2\nmax_speed_m_s,8\n", ManoeuvringModel::mmg, PropulsionKind::thrust_curve)
          .find("both or none of pull_N and power_W"),
      std::string::npos);
  EXPECT_NE(fault("scaling,si\nlength_m,80\nX_udot,1e5\n" + std::string(k_propeller), ManoeuvringModel::derivatives)
                .find("the added mass is not positive"),
            std::string::npos);
  EXPECT_THROW(hydro::read_ship("/no/such/ship.csv", ManoeuvringModel::mmg, PropulsionKind::open_water, 9.81),
               FileError);
}

}  // namespace nilas::ship_file_test
