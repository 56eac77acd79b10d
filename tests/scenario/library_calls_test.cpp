/// Every shipped scene with ice calls FCL and libccd. The calls are counted from outside of the program.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <string>

#include "tests/support/file_text.h"
#include "tests/support/program.h"

namespace nilas_test {
namespace library_calls_test {

std::map<std::string, long> counted_calls(const fs::path& scene, const std::string& more, const fs::path& folder) {
  const fs::path counts = folder / "calls.txt";
  fs::remove(counts);
  setenv("LD_PRELOAD", NILAS_COUNTS_CALLS, 1);
  setenv("NILAS_LIBRARY_CALLS", counts.c_str(), 1);
  const ProgramResult run = run_nilas("run '" + scene.string() + "' " + more + " --out run --force --quiet", folder);
  unsetenv("LD_PRELOAD");
  unsetenv("NILAS_LIBRARY_CALLS");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::map<std::string, long> calls;
  std::ifstream in(counts);
  std::string name;
  for (long count = 0; in >> name >> count;) calls[name] = count;
  return calls;
}

class LibraryCalls : public ::testing::TestWithParam<std::string> {};

/// A few steps are enough, since all pairs are new then.
TEST_P(LibraryCalls, FclAndCcdAreAsked) {
  const ScratchFolder folder;
  const fs::path scene = fs::path(NILAS_SOURCE_DIR) / "apps/scenes" / (GetParam() + ".xml");
  const auto calls = [&](const std::string& narrow_phase) {
    auto counted = counted_calls(scene, "--until 0.05 --set contact/@narrow_phase=" + narrow_phase, folder.path());
    return std::pair(counted.at("distance") + counted.at("collide"), counted.at("ccd"));
  };
  const auto [by_default, ccd_by_default] = calls("nilas");
  const auto [by_fcl, ccd_by_fcl] = calls("fcl");
  EXPECT_GT(by_default, 0);
  EXPECT_GT(ccd_by_default, 0);
  EXPECT_GT(by_fcl, 0);
  EXPECT_GT(ccd_by_fcl, 0);
  EXPECT_LE(calls("nilas-alone").first, by_default);
}

/// In a scene without ice nothing touches.
std::vector<std::string> shipped_scenes() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(fs::path(NILAS_SOURCE_DIR) / "apps/scenes"))
    if (file.path().extension() == ".xml" && nilas::test::read_text(file.path()).find("<ice") != std::string::npos)
      names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(ShippedScenes, LibraryCalls, ::testing::ValuesIn(shipped_scenes()), [](const auto& tested) {
  std::string name = tested.param;
  std::erase(name, '-');
  return name;
});

}  // namespace library_calls_test
}  // namespace nilas_test
