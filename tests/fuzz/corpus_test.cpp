/// Gives the stored inputs of fuzzing to the readers: what once was a finding stays mended in every build.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "tests/fuzz/targets.h"

namespace corpus_test {

namespace fs = std::filesystem;

class StoredInputs : public testing::TestWithParam<nilas::fuzz::NamedTarget> {};

/// Runs all inputs of a target in a folder and returns their number.
int run_all(const fs::path& folder, nilas::fuzz::Target target) {
  int count = 0;
  if (!fs::exists(folder)) return 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path());
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    EXPECT_NO_THROW(target(bytes)) << entry.path();
    ++count;
  }
  return count;
}

TEST_P(StoredInputs, AreTakenOrRefused) {
  const fs::path stored = fs::path(NILAS_SOURCE_DIR) / "tests" / "fuzz";
  EXPECT_GT(run_all(stored / "corpus" / GetParam().name, GetParam().run), 0);
  run_all(stored / "findings" / GetParam().name, GetParam().run);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, StoredInputs, testing::ValuesIn(nilas::fuzz::k_targets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace corpus_test
