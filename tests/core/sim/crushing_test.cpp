/// Crushing in the step: forces of hulls driven into ice, impacts against closed forms, accounts, invariances.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <sstream>
#include <string>

#include "core/scene/read_scene.h"
#include "core/sim/simulation.h"
#include "tests/support/scratch_folder.h"

namespace {

using namespace nilas;

constexpr double k_strength = 1e5, k_thickness = 0.25;

std::string text(double x) {
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

std::string stl(const std::vector<Vec3>& vertices, const std::vector<std::vector<int>>& faces) {
  std::ostringstream out;
  out.precision(17);
  out << "solid hull\n";
  const auto vertex = [&](int v) { out << "vertex " << vertices[static_cast<std::size_t>(v)].transpose() << "\n"; };
  for (const auto& face : faces)
    for (std::size_t k = 2; k < face.size(); ++k) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (const int v : {face[0], face[k - 1], face[k]}) vertex(v);
      out << "endloop\nendfacet\n";
    }
  out << "endsolid hull\n";
  return out.str();
}

/// Its edge at x = 0 at mid height, opening to x = -2 at half angle atan 1/2; the sides lean out by `lean` of the trace
/// per height, and the edge by twice that.
std::string wedge(double lean) {
  std::vector<Vec3> vertices;
  for (const double z : {-1.0, 1.0})
    vertices.insert(vertices.end(), {Vec3(2 * lean * z, 0, z), Vec3(-2, 1 + lean * z, z), Vec3(-2, -1 - lean * z, z)});
  return stl(vertices, {{1, 4, 3, 0}, {3, 5, 2, 0}, {2, 1, 0}, {4, 5, 3}, {2, 5, 4, 1}});
}

/// Its tip at x = 0 and the square of side 2 that it opens to at x = -2.
std::string pyramid() {
  return stl({Vec3(0, 0, 0), Vec3(-2, 1, 1), Vec3(-2, -1, 1), Vec3(-2, -1, -1), Vec3(-2, 1, -1)},
             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}, {4, 3, 2, 1}});
}

std::string crushing(const std::string& model, double strength = k_strength) {
  return "<fracture compressive_strength='" + text(strength) + "'><crushing " + model + "/></fracture>";
}
const std::string k_seed = "model='seed-limit'", k_compliant = "model='compliant'";

struct Rig {
  Rig(const std::string& content, double step, int threads = 1, const std::string& contact = "", double friction = 0,
      double gravity = 0)
      : scene([&] {
          folder.write("wedge.stl", wedge(0));
          folder.write("flared.stl", wedge(0.25));
          folder.write("pyramid.stl", pyramid());
          folder.write("track.csv",
                       "t_s,x_m,y_m,yaw_deg\n0,0,0,0\n0.2,0.1,0,0\n0.4,0.2,0,0\n0.8,0.1,0,0\n1.6,0.5,0,0\n");
          return read_scene(folder.write("scene.xml", "<scene version='1'><time step='" + text(step) +
                                                          "' end='1000'/><gravity value='0 0 " + text(-gravity) +
                                                          "'/><contact solver='auto' tolerance='1e-12' "
                                                          "max_iterations='10000' " +
                                                          contact + "><friction between='* *' static='" +
                                                          text(friction) + "'/></contact>" + content + "</scene>"));
        }()),
        simulation(std::make_unique<Simulation>(scene, threads, warnings)) {}

  StepRecord step() { return simulation->step(); }
  const Bodies& bodies() const { return simulation->bodies(); }
  /// Largest x of the surface of a body.
  double front(std::size_t b) const {
    double x = -1e300;
    for (const Vec3& v : bodies().shape[b]->surface.vertices)
      x = std::max(x, (bodies().p_GB[b] + bodies().R_GB[b] * v).x());
    return x;
  }
  /// Of the only body that is no floe.
  std::size_t hull() const {
    const auto found =
        std::find_if(bodies().kind.begin(), bodies().kind.end(), [](BodyKind k) { return k != BodyKind::floe; });
    return static_cast<std::size_t>(found - bodies().kind.begin());
  }

  test::ScratchFolder folder;
  WarningCounts warnings{make_logger("off", "")};
  Scene scene;
  std::unique_ptr<Simulation> simulation;
};

Vec2 turned(double angle_deg, double x, double y) {
  const double c = std::cos(angle_deg * k_deg), s = std::sin(angle_deg * k_deg);
  return {c * x - s * y, s * x + c * y};
}

std::string outline(double angle_deg, const std::vector<Vec2>& corners) {
  std::string s;
  for (const Vec2& x : corners) {
    const Vec2 p = turned(angle_deg, x.x(), x.y());
    s += text(p.x()) + " " + text(p.y()) + " ";
  }
  return s;
}

/// A vessel of the given mesh at speed 0.5 m/s along x, its tip at x0, towards a fixed breakable sheet from x = 0 on;
/// all turned about z.
std::string towed(const std::string& mesh, double x0, double angle_deg = 0, double y0 = 0) {
  const Vec2 start = turned(angle_deg, x0, y0);
  const std::string angle = text(angle_deg);
  return "<vessel hull='" + mesh + "' heading_deg='" + angle + "' position='" + text(start.x()) + " " +
         text(start.y()) + " 0'><mass value='1000'/><carriage speed='0.5' heading_deg='" + angle +
         "'/></vessel><ice thickness='" + text(k_thickness) + "'><floe fixed='true' breakable='true' outline='" +
         outline(angle_deg, {{0, -3}, {4, -3}, {4, 3}, {0, 3}}) + "'/></ice>";
}

TEST(Crushing, ForceOfASteadyWedgeIsStrengthTimesArea) {
  Rig rig(towed("wedge.stl", -0.0025) + crushing(k_seed), 0.01);
  for (int k = 0; k < 100; ++k) {
    const double depth = std::max(0.0, rig.front(0));
    const StepRecord record = rig.step();
    const Vec3 force = record.vessel->contact.force;
    const double expected = k_strength * depth * k_thickness;  // both sides, along x
    EXPECT_NEAR(force.x(), -expected, 1e-9 * (1 + expected));
    EXPECT_NEAR(force.y(), 0, 1e-9 * (1 + expected));
    EXPECT_NEAR(force.z(), 0, 1e-9 * (1 + expected));
  }
}

TEST(Crushing, ForceOfASteadyFlaredWedge) {
  Rig rig(towed("flared.stl", -0.13) + crushing(k_seed), 0.01);
  bool partial = false, full = false;
  for (int k = 0; k < 120; ++k) {
    const double at_middle = rig.front(0) - 0.5;  // the edge is 0.5 m further forward 1 m up
    // the edge stands at at_middle + z/2 at height z: from there up the sides are in the ice
    const double low = std::max(-k_thickness / 2, -2 * at_middle);
    const StepRecord record = rig.step();
    const Vec3 force = record.vessel->contact.force;
    double expected_x = 0, expected_z = 0;
    if (low < k_thickness / 2) {
      const double top = at_middle + k_thickness / 4, bottom = at_middle + low / 2;
      expected_x = k_strength * (top * top - bottom * bottom);        // of the frontal width at_middle + z/2
      expected_z = k_strength * 0.5 * (top * top - bottom * bottom);  // of the sections' areas
      (low > -k_thickness / 2 ? partial : full) = true;
    }
    EXPECT_NEAR(force.x(), -expected_x, 1e-9 * (1 + expected_x)) << at_middle;
    EXPECT_NEAR(force.z(), expected_z, 1e-9 * (1 + expected_x));
  }
  EXPECT_TRUE(partial && full);
}

TEST(Crushing, DoublingTheStrengthDoublesTheForce) {
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig one(towed("wedge.stl", -0.0025) + crushing(model), 0.01);
    Rig two(towed("wedge.stl", -0.0025) + crushing(model, 2 * k_strength), 0.01);
    for (int k = 0; k < 50; ++k) {
      const Vec3 once = one.step().vessel->contact.force, twice = two.step().vessel->contact.force;
      EXPECT_NEAR(twice.x(), 2 * once.x(), 1e-9 * std::abs(twice.x()));
    }
    EXPECT_LT(one.step().vessel->contact.force.x(), -1000);
  }
}

/// With steady speed the implicit force is that of the area at the step's end.
TEST(Crushing, ImplicitForceIsThatOfTheStepsEnd) {
  Rig rig(towed("wedge.stl", -0.0025) + crushing(k_compliant), 0.01);
  for (int k = 0; k < 60; ++k) {
    const StepRecord record = rig.step();
    const double expected = k_strength * std::max(0.0, rig.front(0)) * k_thickness;
    EXPECT_NEAR(record.vessel->contact.force.x(), -expected, 1e-9 * (1 + expected)) << k;
  }
}

TEST(Crushing, ItsEnergyIsTheWorkOfItsForce) {
  for (const std::string& model :
       {k_seed, k_compliant, std::string("model='pressure-area' coefficient='1e5' exponent='-0.3'")}) {
    Rig rig(towed("flared.stl", -0.13) + crushing(model), 0.01, 1, "", 0.1);
    double work = 0;
    StepRecord record;
    for (int k = 0; k < 100; ++k) {
      record = rig.step();
      work -= record.vessel->contact.force.x() * 0.5 * 0.01;
    }
    const Ledger& ledger = record.ledger;
    EXPECT_GT(ledger.crushing, 100);
    EXPECT_NEAR(ledger.crushing, work - ledger.friction, 1e-6 * work) << model;
    EXPECT_EQ(ledger.impact, 0);
    EXPECT_LE(std::abs(ledger.imbalance), 1e-12 * work);
    // without the term the ledger is open
    EXPECT_GT(std::abs(ledger.imbalance - ledger.crushing), 0.1 * work);
  }
}

TEST(Crushing, CrushedMassIsThatOfTheOverlap) {
  Rig rig(towed("wedge.stl", -0.0025) + crushing(k_seed), 0.01);
  for (int k = 0; k < 100; ++k) rig.step();
  const double depth = rig.front(0) - 0.5 * 0.01;  // where the last contacts were found
  EXPECT_NEAR(rig.simulation->crushed_mass(), 920 * 0.5 * depth * depth * k_thickness, 1e-9);
}

/// Driven in, back, and in again along a track.
TEST(Crushing, CrushedIceDoesNotPushBack) {
  for (const std::string& model : {k_seed, k_compliant}) {
    const std::string track =
        "<vessel hull='wedge.stl' position='-0.0025 0 0'><mass value='1000'/><carriage><path "
        "file='track.csv'/></carriage></vessel><ice thickness='0.25'><floe fixed='true' "
        "breakable='true' outline='0 -3 4 -3 4 3 0 3'/></ice>";
    Rig rig(track + crushing(model), 0.01);
    double deepest = 0;
    int behind = 0, again = 0;
    for (int k = 0; k < 150; ++k) {
      const double before = rig.front(0);
      const StepRecord record = rig.step();
      const double after = rig.front(0), force = -record.vessel->contact.force.x();
      deepest = std::max(deepest, before);
      const double most = k_strength * k_thickness * std::max(after, before);
      EXPECT_LE(force, most * (1 + 1e-9));
      EXPECT_GE(force, 0);
      if (std::max(after, before) < deepest - 1e-9) {
        EXPECT_EQ(force, 0) << model << " at step " << k;
        ++behind;
      } else if (before >= deepest && after > before) {
        EXPECT_GE(force, k_strength * k_thickness * before * (1 - 1e-9));
        if (behind > 0) ++again;
      }
    }
    EXPECT_GT(behind, 30);
    EXPECT_GT(again, 20);
  }
}

/// A free body of mass 5000 kg at 1 m/s into a fixed sheet.
struct Impact {
  double depth = 0, force = 0, left = 0;  ///< largest; and the speed after it, positive on
  int steps = 0;                          ///< until 20 after it came to rest
};

Impact impact(const std::string& mesh, const std::string& model, double h, const std::string& integrator,
              double strength = k_strength, double speed = 1) {
  const double mass = 5000, gap = 1e-3;
  const std::string content = "<body shape='mesh' mesh='" + mesh + "' mass='" + text(mass) + "' position='" +
                              text(-gap) + " 0 0' velocity='" + text(speed) + " 0 0'/><ice thickness='" +
                              text(mesh == "pyramid.stl" ? 4.0 : k_thickness) +
                              "'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 3'/></ice>";
  Rig rig(content + crushing(model, strength), h, 1, "integrator='" + integrator + "'");
  const std::size_t body = rig.hull();
  Impact found;
  constexpr int k_after = 20;  // steps at rest
  for (int rest = 0; rest < k_after;) {
    const double before = rig.bodies().v_GB[body].x();
    rig.step();
    found.left = rig.bodies().v_GB[body].x();
    found.depth = std::max(found.depth, rig.front(body));
    found.force = std::max(found.force, mass * (before - found.left) / h);
    rest += std::abs(found.left) < 1e-8 ? 1 : 0;
    ++found.steps;
  }
  return found;
}

struct ImpactCase {
  std::string mesh, model;
  double depth, force;  ///< closed form
};

/// 1/2 M v^2 = int F d(delta) with F = k delta^q.
ImpactCase closed_form(const std::string& mesh, const std::string& model, double k, double q) {
  const double depth = std::pow((q + 1) * 5000 / (2 * k), 1 / (q + 1));
  return {mesh, model, depth, k * std::pow(depth, q)};
}

std::vector<ImpactCase> impact_cases() {
  const double c = 1e5, ex = -0.1, slant = std::sqrt(5.0);
  const std::string pressure_area = "model='pressure-area' coefficient='1e5' exponent='-0.1'";
  return {closed_form("wedge.stl", k_seed, k_strength * k_thickness, 1),
          closed_form("wedge.stl", k_compliant, k_strength * k_thickness, 1),
          closed_form("pyramid.stl", k_compliant, k_strength, 2),
          closed_form("wedge.stl", pressure_area, c * std::pow(slant * k_thickness, ex) * k_thickness, 1 + ex),
          closed_form("pyramid.stl", pressure_area, c * std::pow(slant, ex), 2 + 2 * ex)};
}

/// Popov's collision: depth and force converge with the first order in the step, from 1e-4 to 0.05 s.
TEST(Crushing, ImpactConvergesToPopovsClosedForm) {
  for (const ImpactCase& one : impact_cases()) {
    const double duration = 1.5 * one.depth;  // at 1 m/s
    for (const double h : {0.05, 0.01, 0.001, 1e-4}) {
      const Impact found = impact(one.mesh, one.model, h, "semi-implicit-euler");
      const double share = h / duration;
      const double depth_error = found.depth / one.depth - 1, force_error = found.force / one.force - 1;
      EXPECT_LE(std::abs(depth_error), 1.5 * share + 1e-7) << one.mesh << one.model << " step " << h;
      EXPECT_LE(std::abs(force_error), 2.5 * share + 1e-7) << one.mesh << one.model << " step " << h;
      EXPECT_NEAR(found.left, 0, 1e-12 * found.steps) << "crushing is plastic; 1e-12 is the solver's tolerance";
    }
  }
}

/// Ice so strong that the impact lasts a hundredth of the step: it ends at rest at once, without rebound.
TEST(Crushing, IsStableAtAnyStep) {
  for (const std::string& model : {k_seed, k_compliant}) {
    const Impact found = impact("wedge.stl", model, 0.05, "semi-implicit-euler", 1e9);
    EXPECT_LE(found.steps, 23) << model;
    EXPECT_NEAR(found.left, 0, 1e-12 * found.steps) << model;
    EXPECT_LE(found.depth, 0.05) << "no further than the way of one step";
    const double exact = std::sqrt(5000 / (1e9 * k_thickness));
    EXPECT_LE(found.depth, model == k_compliant ? exact : 1) << "implicit: no deeper than in continuous time";
  }
}

/// Continuous detection follows pairs as fast as these; the ice gives way all the same.
TEST(Crushing, IsThatOfFastBodiesToo) {
  const double strength = 1e7, speed = 20, exact = speed * std::sqrt(5000 / (strength * k_thickness));
  for (const std::string& model : {k_seed, k_compliant}) {
    const Impact found = impact("wedge.stl", model, 0.01, "semi-implicit-euler", strength, speed);
    EXPECT_NEAR(found.depth, exact, 0.25 * exact) << model << ": a step is a seventh of the impact";
  }
}

/// A pile: the width of the contact is the chord of its facets.
TEST(Crushing, OfACylinder) {
  Rig rig(
      "<body name='pile' shape='cylinder' radius='0.5' height='2' mass='5000' position='-0.501 0 0' "
      "velocity='1 0 0'/><ice thickness='0.25'><floe fixed='true' breakable='true' outline='0 -3 4 -3 4 3 0 "
      "3'/></ice>" +
          crushing(k_seed),
      1e-3);
  double depth = 0, worst = 0;
  for (int k = 0; k < 500; ++k) {
    depth = std::max(0.0, rig.bodies().p_GB[rig.hull()].x() + 0.5);
    const double before = rig.bodies().v_GB[rig.hull()].x();
    rig.step();
    const double now = rig.bodies().v_GB[rig.hull()].x(), force = 5000 * (before - now) / 1e-3;
    const double expected = k_strength * k_thickness * 2 * std::sqrt(depth * (1 - depth));
    if (now > 0.01 && depth > 0.05) worst = std::max(worst, std::abs(force / expected - 1));
  }
  EXPECT_GT(depth, 0.15);
  EXPECT_LT(worst, 5e-3) << "64 facets";
}

TEST(Crushing, ImpactWithTheMidpointRule) {
  for (const ImpactCase& one : impact_cases()) {
    const Impact found = impact(one.mesh, one.model, 1e-3, "moreau");
    EXPECT_NEAR(found.depth, one.depth, 5e-3 * one.depth) << one.mesh << one.model;
    EXPECT_NEAR(found.force, one.force, 5e-3 * one.force);
    EXPECT_NEAR(found.left, 0, 1e-12 * found.steps);
  }
}

TEST(Crushing, DoesNotDependOnTheFrame) {
  for (const std::string& model : {k_seed, k_compliant}) {
    Rig straight(towed("flared.stl", -0.13) + crushing(model), 0.01, 1, "", 0.1);
    Rig at_angle(towed("flared.stl", -0.13, 33) + crushing(model), 0.01, 1, "", 0.1);
    for (int k = 0; k < 100; ++k) {
      const Vec3 expected = straight.step().vessel->contact.force, force = at_angle.step().vessel->contact.force;
      const Vec2 back = turned(-33, force.x(), force.y());
      EXPECT_LE((Vec3(back.x(), back.y(), force.z()) - expected).norm(), 1e-8 * (1 + expected.norm())) << k;
    }
  }
}

TEST(Crushing, MirroredScenesHaveMirroredForces) {
  const auto scene = [](double side) {
    const auto corner = [&](double x, double y) { return text(x) + " " + text(side * y) + " "; };
    return "<vessel hull='flared.stl' position='-0.13 " + text(0.2 * side) +
           " 0'><mass value='1000'/><carriage speed='0.5'/></vessel><ice thickness='0.25'><floe fixed='true' "
           "breakable='true' outline='" +
           corner(0, -0.3) + corner(2, -1) + corner(2, 1) + corner(0.1, 0.6) + "'/></ice>" + crushing(k_compliant);
  };
  Rig port(scene(1), 0.01, 1, "", 0.1), starboard(scene(-1), 0.01, 1, "", 0.1);
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = port.step().vessel->contact.force, s = starboard.step().vessel->contact.force;
    EXPECT_LE((p - Vec3(s.x(), -s.y(), s.z())).norm(), 1e-9 * (1 + p.norm()));
  }
}

/// A ship into floating floes.
std::string field(bool reversed = false) {
  std::string floes;
  for (int k = 0; k < 6; ++k) {
    const int i = reversed ? 5 - k : k;
    const double x = 0.05 + 0.75 * (i / 2), y = i % 2 == 0 ? 0.02 : -0.72;
    floes += "<floe breakable='true' outline='" + outline(0, {{x, y}, {x + 0.7, y}, {x + 0.7, y + 0.7}, {x, y + 0.7}}) +
             "'/>";
  }
  return "<water density='1005'/><hydro><buoyancy/><drag/></hydro>"
         "<vessel hull='flared.stl' position='-0.2 0.05 0'><mass value='1000'/><carriage speed='0.5'/></vessel>"
         "<ice thickness='0.1'>" +
         floes + "</ice><body name='pier' shape='box' size='1 3 2' position='3 0 0' fixed='true'/>";
}

struct FieldRig : Rig {
  explicit FieldRig(const std::string& model, bool reversed = false, int threads = 1)
      : Rig(field(reversed) + crushing(model, 2e4), 0.01, threads, "stabilisation='projection'", 0.1, 9.81) {}
};

TEST(Crushing, AFieldStaysCalmAndItsAccountsClose) {
  for (const std::string& model : {k_seed, k_compliant}) {
    FieldRig rig(model);
    StepRecord record;
    double fastest = 0;
    for (int k = 0; k < 300; ++k) {
      record = rig.step();
      EXPECT_LE(record.momentum_imbalance, 1e-11 * record.momentum_scale + 1e-12);
      for (std::size_t b = 1; b < rig.bodies().id.size(); ++b) fastest = std::max(fastest, rig.bodies().v_GB[b].norm());
    }
    double put_in = 0;
    for (const double work : record.ledger.works) put_in += std::abs(work);
    EXPECT_LE(std::abs(record.ledger.imbalance), 1e-10 * put_in) << model;
    EXPECT_GT(record.ledger.crushing, 0);
    EXPECT_LT(fastest, 1.0) << "twice the hull's speed";
  }
}

TEST(Crushing, ThreadsAndOrderOfFloes) {
  FieldRig one(k_compliant), two(k_compliant, false, 2), reversed(k_compliant, true);
  for (int k = 0; k < 120; ++k) {
    const StepRecord a = one.step(), b = two.step(), c = reversed.step();
    EXPECT_EQ(a.state_hash, b.state_hash) << k;
    const Vec3 difference = a.vessel->contact.force - c.vessel->contact.force;
    EXPECT_LE(difference.norm(), 1e-5 * (1 + a.vessel->contact.force.norm())) << k;
  }
}

TEST(Crushing, GoesOnFromACheckpointWithTheSameBits) {
  FieldRig whole(k_compliant);
  for (int k = 0; k < 80; ++k) whole.step();
  State state;
  whole.simulation->save(StateWriter(state));
  FieldRig rest(k_compliant, false, 2);
  rest.simulation->restore(StateReader(state));
  for (int k = 0; k < 80; ++k) ASSERT_EQ(rest.step().state_hash, whole.step().state_hash) << k;
  EXPECT_EQ(rest.simulation->crushed_mass(), whole.simulation->crushed_mass());
  EXPECT_GT(whole.simulation->crushed_mass(), 0);
}

/// The hull against unbreakable floes, breakable floes against each other and against walls stay rigid.
TEST(Crushing, IsOfBreakableFloesAgainstHullsAlone) {
  const std::string content = towed("wedge.stl", -0.0025);
  const auto at = content.find("breakable='true'");
  Rig rigid(std::string(content).replace(at, 16, "breakable='false'") + crushing(k_seed), 0.01);
  StepRecord record;
  EXPECT_ANY_THROW(static_cast<void>(Rig("<ice><floe outline='0 0 1 0 1 1'/></ice>" + crushing("model='none'"), 0.01)));
  for (int k = 0; k < 20; ++k) record = rigid.step();
  EXPECT_EQ(record.ledger.crushing, 0);
  const auto& modules = rigid.simulation->info().modules;
  EXPECT_TRUE(std::any_of(modules.begin(), modules.end(), [](const auto& m) { return m.first == "crushing"; }));
}

}  // namespace
