/// State hashes of three shipped scenes against those stored in golden.json, so that no change of a bit goes unnoticed.
/// One set of hashes holds for any number of threads. The sets come from Release builds. Compiler and libraries may
/// change bits, and so may the processor: with FMA the C library computes some functions by other instructions.
#include <gnu/libc-version.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "tests/support/program.h"

namespace golden_test {

using namespace nilas_test;
using Json = nlohmann::ordered_json;

/// A scene that runs until it has contacts, and the last one until floes have broken.
struct Case {
  const char* scene;
  const char* until;  ///< End of the run [s].
  bool breaks;        ///< Whether ice must break in the run.
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

bool has_fma() {
#ifdef __x86_64__
  return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

/// While an object exists, programs that start use no FMA in the C library, as on a processor without it.
class WithoutFma {
 public:
  WithoutFma() { setenv("GLIBC_TUNABLES", "glibc.cpu.hwcaps=-FMA,-FMA4", 1); }
  ~WithoutFma() { unsetenv("GLIBC_TUNABLES"); }
  WithoutFma(const WithoutFma&) = delete;
  WithoutFma& operator=(const WithoutFma&) = delete;
};

struct Outcome {
  Json platform;
  std::string scene, until, hash;
};

/// The properties that may change bits: architecture, compiler, libraries, and whether the C library uses FMA.
Json platform_of(const Json& versions, bool fma) {
  Json platform;
#ifdef __x86_64__
  platform["architecture"] = "x86_64";
#else
  platform["architecture"] = "other";
#endif
  platform["fma"] = fma;
  platform["glibc"] = gnu_get_libc_version();
  for (const char* name : {"compiler", "cgal", "eigen", "fcl", "simbody", "sundials"}) platform[name] = versions[name];
  return platform;
}

Outcome run(const Case& c, int threads, bool fma) {
  const ScratchFolder folder;
  const ProgramResult result = run_nilas("run '" + shipped_scene(c.scene).string() + "' --quiet --out run --until " +
                                             c.until + " --threads " + std::to_string(threads),
                                         folder.path());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const Table steps(folder.path() / "run/steps.csv");
  EXPECT_GT(steps["contacts"].back(), 0);
  if (c.breaks) {
    EXPECT_GT(Table(folder.path() / "run/events.csv").rows(), 0u);
  }
  const Json summary = Json::parse(read_text(folder.path() / "run/summary.json"));
  return {platform_of(summary["versions"], fma), c.scene, c.until, steps.text("state_hash").back()};
}

fs::path golden_file() { return fs::path(NILAS_SOURCE_DIR) / "tests/scenario/golden.json"; }

Json stored_sets() { return Json::parse(read_text(golden_file()))["sets"]; }

std::optional<std::string> stored_hash(const Outcome& outcome) {
  for (const Json& set : stored_sets())
    if (set["platform"] == outcome.platform)
      for (const Json& entry : set["hashes"])
        if (entry["scene"] == outcome.scene && entry["until_s"] == outcome.until) return entry["state_hash"];
  return {};
}

/// Puts a hash into the file. Sets of other compilers and libraries are removed, since they belong to an older state.
void renew(const Outcome& outcome) {
  Json sets = Json::array();
  bool placed = false;
  const Json entry{{"scene", outcome.scene}, {"until_s", outcome.until}, {"state_hash", outcome.hash}};
  for (Json set : stored_sets()) {
    Json either = set["platform"];
    either["fma"] = outcome.platform["fma"];
    if (either != outcome.platform || (set["platform"]["fma"] == true && !has_fma())) continue;
    if (set["platform"] == outcome.platform) {
      Json hashes = Json::array();
      for (const Json& other : set["hashes"])
        if (other["scene"] != outcome.scene) hashes.push_back(other);
      hashes.push_back(entry);
      set["hashes"] = hashes;
      placed = true;
    }
    sets.push_back(set);
  }
  if (!placed) sets.push_back({{"platform", outcome.platform}, {"hashes", Json::array({entry})}});
  std::ofstream(golden_file()) << Json{{"renewed_by", "./dev golden"}, {"sets", sets}}.dump(2) << '\n';
}

/// Whether the platform is the one of README.md, Debian 12 with its g++ on x86_64. The stored hashes must hold there.
bool is_named_platform(const Json& platform) {
  const std::string release = read_text("/etc/os-release");
  const bool debian =
      release.find("\nID=debian\n") != std::string::npos && release.find("\nVERSION_ID=\"12\"\n") != std::string::npos;
  return debian && platform["architecture"] == "x86_64" &&
         platform["compiler"].get<std::string>().rfind("GNU 12.", 0) == 0;
}

void compare_or_renew(const Outcome& outcome) {
  if (std::getenv("NILAS_RENEW_GOLDEN") != nullptr) return renew(outcome);
  const auto stored = stored_hash(outcome);
  if (stored) {
    EXPECT_EQ(outcome.hash, *stored)
        << outcome.scene << " has another state at " << outcome.until << " s than the one stored for "
        << outcome.platform.dump() << ".\nIf results are meant to change, say why in CHANGELOG.md and renew the hashes "
        << "by ./dev golden, which rewrites " << golden_file().string();
  } else if (is_named_platform(outcome.platform)) {
    ADD_FAILURE() << golden_file().string() << " has no hash of " << outcome.scene << " at " << outcome.until
                  << " s for " << outcome.platform.dump() << "; ./dev golden adds it";
  } else {
    std::printf("no state hash is stored for this platform, so only the numbers of threads were compared: %s\n",
                outcome.platform.dump().c_str());
  }
}

class Golden : public ::testing::TestWithParam<Case> {};

TEST_P(Golden, StateHashIsTheStoredOne) {
  const Outcome one = run(GetParam(), 1, has_fma());
  EXPECT_EQ(run(GetParam(), 2, has_fma()).hash, one.hash) << "two threads give other bits than one";
  compare_or_renew(one);
  if (!has_fma()) return;
  const WithoutFma guard;
  compare_or_renew(run(GetParam(), 1, false));
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden,
                         ::testing::Values(Case{"presawn-b.xml", "3.5", false}, Case{"towing.xml", "2", false},
                                           Case{"level-ice.xml", "4", true}),
                         [](const auto& instance) {
                           const std::string name = fs::path(instance.param.scene).stem().string();
                           return name.substr(0, name.find('-'));
                         });

}  // namespace golden_test
