/// `nilas problems --export`: files that can be read, with solutions that hold.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/compare/problems/challenge_catalogue.h"
#include "contact/fclib/fclib_io.h"
#include "contact/measure/measure.h"
#include "tests/support/program.h"

namespace challenge_test {

using namespace nilas;
using namespace nilas::compare;
using namespace nilas_test;

TEST(Challenges, AreValidAndNamedApart) {
  std::set<std::string> names;
  for (const auto& one : challenges()) {
    contact::validate(one.problem);
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_GT(one.problem.num_contacts(), 0) << one.name;
  }
}

/// A box that is dropped on the ground.
constexpr const char* k_scene = R"(<scene version="1" name="box">
  <time step="0.01" end="0.2"/>
  <contact law="pyramid" solver="pgs" tolerance="1e-9"><friction between="structure structure" static="0.3" kinetic="0.3"/></contact>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="box" shape="box" size="1 1 1" mass="2" position="0 0 0.51" velocity="1 0 0"/>
</scene>
)";

TEST(ProblemExport, WritesProblemsWithCertifiedSolutions) {
  const ScratchFolder folder;
  folder.write("scenes/box.xml", k_scene);
  const auto run = run_nilas("problems --export out --scenes scenes --json --quiet", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  const Table table(folder.path() / "out/problems.csv");
  EXPECT_EQ(json["problems"].size(), challenges().size() + 1);
  EXPECT_EQ(table.rows(), challenges().size() + 1);
  for (const auto& one : json["problems"]) {
    const std::string name = one["name"];
    const contact::FclibProblem stored = contact::read_fclib(folder.path() / "out" / (name + ".hdf5"));
    const auto& problem = std::get<contact::ContactProblem>(stored.problem);
    ASSERT_TRUE(stored.solution) << name;
    const double map = contact::measure(problem, *stored.solution).law_map_m_s;
    EXPECT_DOUBLE_EQ(map, one["law_map_m_s"]) << name;
    EXPECT_TRUE(one["certified"]) << name << " " << map;
    EXPECT_LE(map, 1e-8) << name;
  }
}

/// The last step of a jam and those 5 and 10 steps before, each with the impulses that its solver began with.
TEST(ProblemExport, WritesStepsOfJamsWithTheirWarmStarts) {
  const ScratchFolder folder;
  folder.write("scenes/box.xml", k_scene);
  std::string pressed = k_scene;
  const std::string law = R"(law="pyramid" solver="pgs")";
  pressed.replace(pressed.find(law), law.size(), R"(law="coulomb" solver="nsgs")");
  folder.write("scenes/jams/pressed.xml", pressed);
  const auto run = run_nilas("problems --export out --scenes scenes --json --quiet", folder.path());
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Table(folder.path() / "out/problems.csv").rows(), challenges().size() + 4);
  for (const char* name : {"pressed-step-10", "pressed-step-15", "pressed-step-20"}) {
    const contact::FclibProblem stored = contact::read_fclib(folder.path() / "out" / (std::string(name) + ".hdf5"));
    const auto& problem = std::get<contact::ContactProblem>(stored.problem);
    ASSERT_TRUE(stored.solution) << name;
    EXPECT_LE(contact::measure(problem, *stored.solution).law_map_m_s, 1e-8) << name;
    ASSERT_TRUE(stored.guess) << name;
    // the box slides steadily, so that the impulses of the step before are near the solution
    EXPECT_LT((*stored.guess - *stored.solution).norm(), 0.2 * stored.solution->norm()) << name;
    EXPECT_NE(*stored.guess, *stored.solution) << name;
  }
}

TEST(ProblemExport, IsTheSameEachTimeAndHarmsNoFolder) {
  const ScratchFolder folder;
  folder.write("scenes/box.xml", k_scene);
  folder.write("full/mine.txt", "mine");
  const auto refused = run_nilas("problems --export full --no-scenes", folder.path());
  EXPECT_EQ(refused.exit_code, 2) << refused.err;
  EXPECT_EQ(run_nilas("problems --export out --scenes nowhere", folder.path()).exit_code, 4);
  EXPECT_EQ(run_nilas("problems --export full --force --quiet --scenes scenes --threads 1", folder.path()).exit_code,
            0);
  EXPECT_EQ(run_nilas("problems --export again --quiet --scenes scenes --threads 2", folder.path()).exit_code, 0);
  EXPECT_EQ(read_text(folder.path() / "full/mine.txt"), "mine");
  EXPECT_EQ(read_text(folder.path() / "full/problems.csv"), read_text(folder.path() / "again/problems.csv"));
}

/// Tells how far it is, and when stopped leaves the table of what it did.
TEST(ProblemExport, IsStoppedWithItsTableSoFar) {
  const ScratchFolder folder;
  std::string endless = k_scene;
  endless.replace(endless.find("0.2"), 3, "1e6");
  folder.write("scenes/box.xml", endless);
  const std::size_t generated = challenges().size();
  const std::string all = std::to_string(generated + 1), last = std::to_string(generated) + " of " + all;
  const std::string command = "cd '" + folder.path().string() +
                              "' && { '" NILAS_PROGRAM
                              "' problems --export out --scenes scenes --until 1e6 --threads 1 >out.txt 2>err.txt & "
                              "p=$!; until grep -q '" +
                              last + "' err.txt; do kill -0 $p || break; sleep 0.01; done; kill -TERM $p; wait $p; }";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 130);
  const std::string told = read_text(folder.path() / "err.txt");
  EXPECT_EQ(told.rfind("  1 of " + all + "  ", 0), 0u) << told;
  EXPECT_NE(told.find("The program was interrupted; " + last + " sources are done.\n"), std::string::npos) << told;
  EXPECT_EQ(Table(folder.path() / "out/problems.csv").rows(), generated);
}

}  // namespace challenge_test
