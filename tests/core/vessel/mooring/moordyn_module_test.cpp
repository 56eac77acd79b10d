/// Lines by MoorDyn, with a stand-in for its library: springs from the anchors at the coupled points' first places.
#include "core/vessel/mooring/moordyn_module.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/geometry/shape.h"

namespace nilas::vessel {

namespace moordyn_module_test {

/// Two coupled points. Each is held by a spring of 100 N/m that has no force at `rest`.
struct StandIn {
  Vec3 points[2] = {{1, 0, 0}, {-1, 2, 0}};
  Vec3 rest[2], now[2];
  int types[2] = {-1, -1};
  double time = 0;
};
constexpr double k_spring = 100, k_breaks_after = 5;  // [N/m, s]
/// The coupled degrees of freedom that it tells.
unsigned told_dof = 6;

StandIn& of(void* system) { return *static_cast<StandIn*>(system); }

MoordynApi stand_in() {
  MoordynApi api;
  api.name = "stand-in";
  api.create = [](const char* file) -> void* {
    return std::string(file).ends_with("lines.txt") ? new StandIn : nullptr;
  };
  api.close = [](void* system) { return delete &of(system), 0; };
  api.set_verbosity = [](void*, int) { return 0; };
  api.coupled_dof = [](void*, unsigned* n) { return *n = told_dof, 0; };
  api.init = [](void* system, const double* x, const double*) {
    for (int k = 0; k < 2; ++k) of(system).rest[k] = of(system).now[k] = Vec3::Map(x + 3 * k);
    of(system).rest[0].z() -= 1;  // it pulls downwards at first
    return 0;
  };
  api.step = [](void* system, const double* x, const double* v, double* f, double* t, double* dt) {
    StandIn& all = of(system);
    if (*t != all.time) return -1;  // steps must follow each other
    all.time = *t + *dt;
    for (int k = 0; k < 2; ++k) {
      all.now[k] = Vec3::Map(x + 3 * k) + *dt * Vec3::Map(v + 3 * k);
      Vec3::Map(f + 3 * k) = k_spring * (all.rest[k] - all.now[k]);
    }
    return 0;
  };
  api.number_of_points = api.number_of_lines = [](void*, unsigned* n) { return *n = 2, 0; };
  api.point = [](void* system, unsigned k) -> void* { return &of(system).points[k - 1]; };
  api.point_type = [](void*, int* type) { return *type = -1, 0; };
  api.point_place = [](void* point, double* place) { return Vec3::Map(place) = *static_cast<Vec3*>(point), 0; };
  api.point_force = [](void*, double* force) { return Vec3::Map(force) = Vec3(0, 0, -k_spring), 0; };
  api.line = [](void* system, unsigned) { return system; };
  api.line_id = [](void*, int* id) { return *id = 7, 0; };
  api.greatest_tension = [](void* system, double* tension) {
    const bool whole = of(system).time < k_breaks_after;
    *tension = whole ? k_spring * (of(system).now[0] - of(system).rest[0]).norm() : std::nan("");
    return 0;
  };
  api.serialize = [](void* system, std::size_t* size, std::uint64_t* data) {
    if (size != nullptr) *size = sizeof(double);
    if (data != nullptr) *data = std::bit_cast<std::uint64_t>(of(system).time);
    return 0;
  };
  api.deserialize = [](void* system, const std::uint64_t* data) {
    of(system).time = std::bit_cast<double>(*data);
    return 0;
  };
  return api;
}

bodies::Bodies hull() {
  bodies::BodySpec spec;
  spec.kind = bodies::BodyKind::vessel;
  spec.motion = bodies::Motion::articulated;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({2, 2, 2}));
  spec.mass = 100;
  spec.pose.p = {10, 0, 0};
  bodies::Bodies bodies;
  bodies.add(spec);
  return bodies;
}

class MoordynMooring : public testing::Test {
 protected:
  MoordynMooring() { told_dof = 6; }
  std::unique_ptr<bodies::ForceModule> make() { return make_moordyn_mooring(stand_in(), settings_, bodies_); }
  Wrench load(bodies::ForceModule& module) {
    bodies::Wrenches out(1);
    module.add_forces(bodies_, 0, out);
    return out[0];
  }
  bodies::Bodies bodies_ = hull();
  MoordynSettings settings_{"lines.txt", {0.5, 0, 0}, 0.25, 0};
};

/// Points at (1 0 0) and (-1 2 0) in V have the arms (0.5 0 0) and (-1.5 2 0).
TEST_F(MoordynMooring, PullsAtItsFairleads) {
  const auto module = make();
  const Wrench start = load(*module);
  EXPECT_EQ(start.force, Vec3(0, 0, -2 * k_spring));
  EXPECT_EQ(start.torque, k_spring * Vec3(-2, -1.5 + 0.5, 0));
  EXPECT_EQ(load(*module).force, start.force);
  bodies_.set_pose(0, {10.1, 0, 0}, Quat::Identity());
  EXPECT_EQ(load(*module).force, start.force);  // forces change at the end of a substep
  module->end_substep(bodies_, 0.5, 0.5);
  const Wrench moved = load(*module);
  EXPECT_NEAR(moved.force.x(), -2 * 0.1 * k_spring, 1e-9);
  EXPECT_NEAR(moved.force.z(), -k_spring, 1e-9);  // only the first spring was put under load
  EXPECT_EQ(module->columns(), (std::vector<std::string>{"line_7_tension_N", "line_7_tension_N"}));
  std::vector<double> values;
  module->append_values(values);
  EXPECT_NEAR(values.at(0), k_spring * std::hypot(0.1, 1), 1e-9);
}

TEST_F(MoordynMooring, ContinuesFromItsState) {
  const auto first = make();
  bodies_.set_pose(0, {10.1, 0.2, 0}, Quat::Identity());
  first->end_substep(bodies_, 0.5, 0.5);
  State state;
  first->save(bodies_, StateWriter(state));
  const auto second = make();
  second->restore(StateReader(state));
  EXPECT_EQ(load(*second).force, load(*first).force);
  second->end_substep(bodies_, 1, 0.5);  // fails where the time was not restored
}

TEST_F(MoordynMooring, TellsTimeAndLineOfATensionThatIsNoNumber) {
  const auto module = make();
  try {
    module->end_substep(bodies_, 6, 6);
    FAIL() << "no refusal";
  } catch (const SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("at 6 s the tension of MoorDyn's line 7"), std::string::npos)
        << error.what();
  }
}

TEST_F(MoordynMooring, TellsTheTimeOfAFailure) {
  const auto module = make();
  try {
    module->end_substep(bodies_, 3, 1);  // it does not begin where the last one ended
    FAIL() << "no refusal";
  } catch (const SimulationError& error) {
    EXPECT_STREQ(error.what(), "at 3 s MoorDyn failed with the code -1");
  }
}

TEST_F(MoordynMooring, RefusesFilesThatItCannotUse) {
  settings_.file = "other.txt";
  try {
    make();
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what()[0], '/') << "the path is not absolute: " << error.what();
  }
  settings_.file = "lines.txt";
  told_dof = 12;
  EXPECT_THROW(make(), InputError);
}

/// Without the library the message says what to do.
TEST(MoordynLibrary, IsAskedForByName) {
  ::setenv("NILAS_MOORDYN", "/no/such/library.so", 1);
  try {
    load_moordyn();
    FAIL() << "no refusal";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("/no/such/library.so"), std::string::npos) << text;
    EXPECT_NE(text.find("NILAS_MOORDYN"), std::string::npos) << text;
  }
  ::unsetenv("NILAS_MOORDYN");
}

}  // namespace moordyn_module_test

}  // namespace nilas::vessel
