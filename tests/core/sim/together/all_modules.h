#pragma once
/// Elements of scenes that have many modules at once: a ship of 200 m with a database, in waves, wind, current and ice.
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/math.h"
#include "tests/core/sim/scene_rig.h"
#include "tests/support/file_text.h"

namespace nilas::test {

/// Numbers as an attribute holds them, to the last bit.
inline std::string texts(std::initializer_list<double> numbers) {
  std::string all;
  for (const double x : numbers) all += (all.empty() ? "" : " ") + text(x);
  return all;
}

/// Writes places and directions of a scene that is mirrored as a whole about the plane y = 0 where `side` is -1, and
/// then turned about the vertical.
class TurnedScene {
 public:
  explicit TurnedScene(double turn_deg = 0, double side = 1)
      : turn_deg_(turn_deg), side_(side), turn_(turn_deg * k_deg) {}
  double side() const { return side_; }
  Vec3 of(const Vec3& v) const {
    const Vec2 level = turn_ * Vec2(v.x(), side_ * v.y());
    return {level.x(), level.y(), v.z()};
  }
  std::string heading(double deg) const { return text(side_ * deg + turn_deg_); }
  std::string at(double x, double y) const {
    const Vec3 p = of({x, y, 0});
    return texts({p.x(), p.y()});
  }
  std::string at(double x, double y, double z) const { return at(x, y) + " " + text(z); }
  std::string outline(const std::vector<Vec2>& corners) const {
    std::string all;
    for (const Vec2& p : corners) all += (all.empty() ? "" : " ") + at(p.x(), p.y());
    return all;
  }

 private:
  double turn_deg_, side_;
  Eigen::Rotation2Dd turn_;
};

/// The files of the ship's database. Those of the drift are invented: they grow with the frequency, and are those of a
/// ship that reflects short waves.
inline SceneRig::Files ship_files() {
  SceneRig::Files files;
  const std::string folder = std::string(NILAS_SOURCE_DIR) + "/tests/data/hydro/mss/fpso";
  for (const std::string ending : {".1", ".3", ".hst"}) files["ship" + ending] = read_text(folder + ending);
  std::ostringstream drift;
  double last_period = -1, last_heading = -1;
  for (const std::string& line : split_lines(files["ship.3"])) {
    std::istringstream in(line);
    double period = 0, heading = 0;
    if (!(in >> period >> heading) || (period == last_period && heading == last_heading)) continue;
    last_period = period;
    last_heading = heading;
    const double w4 = std::pow(2 * k_pi / period, 4), most = 22 * w4 / (w4 + 0.01);
    const double c = std::cos(heading * k_deg), s = std::sin(heading * k_deg);
    const auto row = [&](int mode, double load) {
      drift << period << ' ' << heading << ' ' << heading << ' ' << mode << ' ' << std::abs(load)
            << (load < 0 ? " 180 " : " 0 ") << load << " 0\n";
    };
    row(1, 0.3 * most * c);
    row(2, most * s);
    row(6, 8 * most * s * c);
  }
  files["ship.8"] = drift.str();
  return files;
}

inline const std::string k_database =
    "<database file='ship.1' length='1' density='1025' gravity='9.81' origin='100 0 12'/>";

/// <mass> of the ship of the database. A hull with `less` has this much less [kg], as its parts weigh.
inline std::string ship_mass(double less = 0) {
  const double mass = 1025 * 97960.9;
  const Vec3 com(0.788631, 0, -1);
  const Mat3 at_origin = mass * Vec3(16.3 * 16.3, 54.0 * 54.0, 54.0 * 54.0).asDiagonal();
  const Mat3 I = at_origin - mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose());
  return "<mass value='" + text(mass - less) + "' cog='" + texts({100 + com.x(), 0, 11}) + "' inertia='" +
         texts({I(0, 0), I(1, 1), I(2, 2), 0, I(0, 2), 0}) + "'/>";
}

inline const std::string k_wind_area =
    "<wind_area ship_type='tanker-loaded' frontal='900' lateral='2500' lateral_centroid='5'/>";

/// The ship with its stern at (-100, 0) and its bow at (100, 0), afloat in water of level 0.
inline std::string ship(const std::string& inside, const TurnedScene& turned = TurnedScene(),
                        const std::string& velocity = "", double less = 0) {
  return "<vessel name='ship' position='" + turned.at(-100, 0, -12) + "' heading_deg='" + turned.heading(0) + "' " +
         velocity +
         "><hull generate='wedge' length='200' beam='44' draught='12' depth='20' bow_length='40' triangles='2000'/>" +
         ship_mass(less) + k_wind_area + inside + "</vessel>";
}

/// A wind sea, a swell, and a current. The ice ahead of x = 105 m weakens the sea. `spreading`: attribute of the sea.
inline std::string sea(const TurnedScene& turned = TurnedScene(), const std::string& current = "",
                       const std::string& spreading = "spreading='12'") {
  return "<water density='1025'><current velocity='" + turned.at(-0.4, 0.2, 0) + "' " + current +
         "/><waves kind='jonswap' height='2.5' period='9' heading_deg='" + turned.heading(165) +
         "' components='10' shortest_period='6' ramp='3' attenuation='exponential' attenuation_rate='1e-3' " +
         spreading + " ice_edge='" + turned.at(105, 0) +
         "'/>"
         "<waves kind='regular' height='0.8' period='14' heading_deg='" +
         turned.heading(200) + "' phase_deg='30'/></water>";
}
inline std::string wind(const TurnedScene& turned = TurnedScene()) {
  return "<wind speed='14' direction_deg='" + turned.heading(150) + "' profile='log' gusts='npd'/>";
}

/// Four chains to a turret, of which one breaks at 2 s, and a hawser at the stern.
inline std::string ship_mooring(const TurnedScene& turned = TurnedScene(), const std::string& attributes = "") {
  std::string lines;
  for (int k = 0; k < 4; ++k) {
    const Vec2 away = direction_of(k_pi / 4 + k * k_pi / 2);
    lines += "<line name='m" + std::to_string(k + 1) + "' fairlead='" +
             texts({150 + 3 * away.x(), turned.side() * 3 * away.y(), 2}) + "' anchor='" +
             turned.at(50 + 700 * away.x(), 700 * away.y(), -80) +
             "' length='720' weight='1500' stiffness='8e8' bed_friction='0.4' damping='2e4' turret='true' " +
             (k == 1 ? "break_time='2'" : "") + "/>";
  }
  return "<mooring depth='80' " + attributes + "><turret at='150 0 2' friction='1e5'/>" + lines +
         "<spring_line name='hawser' fairlead='2 0 12' anchor='" + turned.at(-180, 0, 0) +
         "' length='80' stiffness='2e5' knee='2' second_stiffness='4e5' damping='1e4'/></mooring>";
}

/// Four thrusters of all kinds that turn or do not, one of which fails, and positioning. `control`: its attributes.
inline std::string ship_thrusters(const std::string& control, const TurnedScene& turned = TurnedScene()) {
  const std::string port = text(8 * turned.side()), starboard = text(-8 * turned.side());
  return "<thrusters>"
         "<thruster name='bow' kind='tunnel' at='180 0 4' max_thrust='8e5' power='6e6' lag='1'/>"
         "<thruster name='port' kind='azimuth' at='12 " +
         port + " 1' max_thrust='1.2e6' power='9e6' lag='1.5' forbidden_deg='" +
         (turned.side() > 0 ? "80 100" : "-100 -80") +
         "' loss='0.05' free_speed='12'/>"
         "<thruster name='starboard' kind='azimuth' at='12 " +
         starboard +
         " 1' max_thrust='1.2e6' power='9e6' lag='1.5' fails_at='3'/>"
         "<thruster name='main' kind='propeller-rudder' at='5 0 3' max_thrust='1.5e6' power='1e7' rudder_area='40' "
         "rudder_span='8' rudder_distance='4' diameter='7'/></thrusters><control mode='dp' " +
         control + "/>";
}
inline const std::string k_noisy_sensors =
    "sensor_period='0.5' sensor_delay='0.5' position_noise='0.1' heading_noise_deg='0.1' watch_circle='3'";
inline const std::string k_jets =
    "<propeller_wash><jet thruster='port' diameter='4' position='12 8 1'/>"
    "<jet thruster='main' diameter='7' position='5 0 3'/></propeller_wash>";

/// Ice of 1 m: floes that break drift onto the bow, and others lie in the wash behind the stern.
inline const std::string k_breaking_ice =
    "<ice density='910' thickness='1' youngs_modulus='5e9'>"
    "<field kind='grid' region='102 -30 150 30' rows='3' columns='2' gap='2' breakable='true' velocity='-1.5 0 0'/>"
    "<field kind='grid' region='-200 -30 -142 30' rows='2' columns='2' gap='1' velocity='0.2 0 0'/>"
    "<vary property='compressive_strength' mean='2e6' cov='0.2'/></ice>"
    "<fracture flexural_strength='5e5' compressive_strength='2e6' min_area='1'><crushing model='compliant'/>"
    "<bending/><splitting/></fracture>";

/// <contact> with friction, for these attributes.
inline std::string contact(const std::string& attributes) {
  return "<contact " + attributes +
         "><friction between='ice ice' static='0.3' kinetic='0.3'/>"
         "<friction between='hull ice' static='0.1' kinetic='0.1'/></contact>";
}

}  // namespace nilas::test
