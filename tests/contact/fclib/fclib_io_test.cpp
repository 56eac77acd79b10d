/// Tests of FCLIB files: every storage is read as it was written, and every fault has a message.
#include "contact/fclib/fclib_io.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>

#include "contact/fclib/fclib_matrix.h"
#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"
#include "tests/support/program.h"
#include "tests/support/refusal.h"

namespace nilas::contact {
namespace fclib_io_test {

using nilas_test::ScratchFolder;
namespace fs = std::filesystem;

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

/// One matrix group as stored in a file.
struct Stored {
  int m = 0, n = 0, nzmax = 0, nz = 0;
  std::vector<int> p, i;
  std::vector<double> x;
};

/// A global problem of two bodies with three degrees of freedom each and two contacts. Tests may change its members.
struct GlobalFile {
  Stored mass{6, 6, 6, 6, {0, 1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5}, {2, 2, 2, 3, 3, 3}};
  Stored jacobian{6, 6, 40, -1, {0, 1, 2, 3, 5, 7, 9}, {0, 1, 2, 0, 3, 1, 4, 2, 5}, {1, 1, 1, -1, 1, -1, 1, -1, 1}};
  std::vector<double> f{-1, 0.2, 0, -2, 0.5, 0.1}, w{0, 0, 0, 0.1, 0, 0}, mu{0.3, 0.5};
  int spacedim = 3;
  std::string root = "fclib_global";
};

void add_stored(hdf5::Hdf5Writer& file, const std::string& group, const Stored& matrix) {
  file.add_group(group);
  file.add(group + "/m", std::vector<int>{matrix.m});
  file.add(group + "/n", std::vector<int>{matrix.n});
  file.add(group + "/nzmax", std::vector<int>{matrix.nzmax});
  file.add(group + "/nz", std::vector<int>{matrix.nz});
  file.add(group + "/p", matrix.p);
  file.add(group + "/i", matrix.i);
  file.add(group + "/x", matrix.x);
}

void write(const GlobalFile& problem, const fs::path& path, const std::function<void(hdf5::Hdf5Writer&)>& more = {}) {
  hdf5::Hdf5Writer file;
  file.add_group(problem.root);
  file.add(problem.root + "/spacedim", std::vector<int>{problem.spacedim});
  add_stored(file, problem.root + "/M", problem.mass);
  add_stored(file, problem.root + "/H", problem.jacobian);
  file.add_group(problem.root + "/vectors");
  file.add(problem.root + "/vectors/f", problem.f);
  file.add(problem.root + "/vectors/w", problem.w);
  file.add(problem.root + "/vectors/mu", problem.mu);
  if (more) more(file);
  file.save(path);
}

void write_local(const Stored& w, const fs::path& path, const std::vector<double>& mu = {0.3, 0.5}) {
  hdf5::Hdf5Writer file;
  file.add_group("fclib_local");
  file.add("fclib_local/spacedim", std::vector<int>{3});
  add_stored(file, "fclib_local/W", w);
  file.add_group("fclib_local/vectors");
  file.add("fclib_local/vectors/q", std::vector<double>{-1, 0.1, 0, -2, 0, 0.3});
  file.add("fclib_local/vectors/mu", mu);
  file.save(path);
}

/// W with an entry off the diagonal and a slightly different transposed entry, as triplets, p = columns.
Stored triplets() {
  return {6, 6, 30, 8, {0, 1, 2, 3, 4, 5, 3, 0}, {0, 1, 2, 3, 4, 5, 0, 3}, {2, 2, 2, 1, 1, 1, 0.5, 0.501}};
}
Stored compressed(int nz) {
  const bool by_rows = nz == -2;
  return {
      6,
      6,
      8,
      nz,
      {0, 2, 3, 4, 6, 7, 8},
      {0, 3, 1, 2, 0, 3, 4, 5},
      by_rows ? std::vector<double>{2, 0.5, 2, 2, 0.501, 1, 1, 1} : std::vector<double>{2, 0.501, 2, 2, 0.5, 1, 1, 1}};
}

MatX dense(const FclibProblem& read) { return MatX(sparse_matrix(std::get<LocalProblem>(read.problem))); }

void expect_refused(const fs::path& path, const std::string& words) {
  test::expect_refusal([&] { read_fclib(path); }, {words, path.string()});
}

TEST(FclibIo, EveryStorageGivesTheSameMatrix) {
  const ScratchFolder folder;
  MatX expected = MatX(VecX{{2, 2, 2, 1, 1, 1}}.asDiagonal());
  expected(0, 3) = 0.5;
  expected(3, 0) = 0.501;
  for (const Stored& stored : {triplets(), compressed(-1), compressed(-2)}) {
    write_local(stored, folder.path() / "w.hdf5");
    const auto read = read_fclib(folder.path() / "w.hdf5");
    EXPECT_EQ(dense(read), expected) << stored.nz;
    EXPECT_NEAR(read.asymmetry, 0.001 / 2, 1e-15);
    EXPECT_EQ(read.num_velocities(), 0);
  }
}

TEST(FclibIo, TripletsOfAnOblongMatrixAreUnderstoodInEitherOrder) {
  const ScratchFolder folder;
  GlobalFile problem;
  problem.mu = {0.3};
  problem.w = {0, 0, 0};
  problem.jacobian = {6, 3, 6, 6, {0, 0, 1, 1, 2, 2}, {0, 3, 1, 4, 2, 5}, {-1, 1, -1, 1, -1, 1}};
  write(problem, folder.path() / "columns.hdf5");
  std::swap(problem.jacobian.p, problem.jacobian.i);
  write(problem, folder.path() / "rows.hdf5");
  const auto one = read_fclib(folder.path() / "columns.hdf5"), other = read_fclib(folder.path() / "rows.hdf5");
  EXPECT_EQ(std::get<ContactProblem>(one.problem).jacobian_data, std::get<ContactProblem>(other.problem).jacobian_data);
}

TEST(FclibIo, LocalProblemsComeBackAsWritten) {
  const ScratchFolder folder;
  write_local(triplets(), folder.path() / "in.hdf5");
  auto read = read_fclib(folder.path() / "in.hdf5");
  auto& problem = std::get<LocalProblem>(read.problem);
  problem.mu_static[1] = 0.6;
  problem.force_limit[0] = 7;
  problem.compliance[1] = 1e-4;
  problem.tangential_compliance[0] = 2e-4;
  read.title = "two contacts";
  ContactSolution solution;
  solution.r = VecX{{1, 0.1, 0, 2, 0, 0.3}};
  solution.u = contact_velocities(problem, solution.r);
  write_fclib(folder.path() / "out.hdf5", read, &solution);
  const auto again = read_fclib(folder.path() / "out.hdf5");
  const auto& same = std::get<LocalProblem>(again.problem);
  EXPECT_EQ(dense(again), dense(read));
  EXPECT_EQ(same.q, problem.q);
  EXPECT_EQ(same.mu_static, problem.mu_static);
  EXPECT_EQ(same.force_limit, problem.force_limit);
  EXPECT_EQ(same.compliance, problem.compliance);
  EXPECT_EQ(same.tangential_compliance, problem.tangential_compliance);
  EXPECT_EQ(again.title, "two contacts");
  ASSERT_TRUE(again.solution.has_value());
  EXPECT_EQ(*again.solution, solution.r);
  EXPECT_EQ(hdf5::Hdf5Reader(folder.path() / "out.hdf5").numbers("solution/u"), solution.u);
}

TEST(FclibIo, GlobalProblemsComeBackAsWritten) {
  const ScratchFolder folder;
  write(GlobalFile{}, folder.path() / "in.hdf5");
  const auto read = read_fclib(folder.path() / "in.hdf5");
  const auto& problem = std::get<ContactProblem>(read.problem);
  validate(problem);
  EXPECT_EQ(problem.num_velocities(), 6);
  EXPECT_EQ(problem.num_contacts(), 2);
  ContactSolution solution;
  solution.r = VecX{{0.5, 0.1, 0, 0, 0, 0}};
  solution.v = velocities(problem, solution.r);
  solution.u = contact_velocities(problem, solution.v);
  write_fclib(folder.path() / "out.hdf5", read, &solution);
  const auto again = read_fclib(folder.path() / "out.hdf5");
  const auto& same = std::get<ContactProblem>(again.problem);
  EXPECT_EQ(same.mass_data, problem.mass_data);
  EXPECT_EQ(same.jacobian_data, problem.jacobian_data);
  EXPECT_EQ(same.f, problem.f);
  EXPECT_EQ(same.w, problem.w);
  EXPECT_EQ(velocities(same, *again.solution), solution.v);
}

TEST(FclibIo, DegreesOfFreedomKeepTheFilesOrder) {
  const ScratchFolder folder;
  GlobalFile problem;  // The bodies' rows are {0,5}, {1,4}, {2,3}: no block has consecutive rows.
  problem.mass = {6,
                  6,
                  12,
                  12,
                  {0, 1, 2, 3, 4, 5, 0, 5, 1, 4, 2, 3},
                  {0, 1, 2, 3, 4, 5, 5, 0, 4, 1, 3, 2},
                  {4, 4, 4, 4, 4, 4, 1, 1, 1, 1, 1, 1}};
  problem.mu = {0.3};
  problem.w = {0, 0, 0};
  problem.jacobian = {6, 3, 3, -1, {0, 1, 2, 3}, {0, 5, 4}, {1, 1, 1}};
  write(problem, folder.path() / "in.hdf5");
  const auto read = read_fclib(folder.path() / "in.hdf5");
  EXPECT_EQ(read.dof_of_file, (std::vector<int>{0, 5, 1, 4, 2, 3}));
  write_fclib(folder.path() / "out.hdf5", read, nullptr);
  EXPECT_EQ(hdf5::Hdf5Reader(folder.path() / "out.hdf5").numbers("fclib_global/vectors/f"),
            (VecX{{-1, 0.2, 0, -2, 0.5, 0.1}}));
}

TEST(FclibIo, AnAsymmetricMassIsInvertedAsItStands) {
  const ScratchFolder folder;
  GlobalFile problem;
  problem.mass = {6, 6, 8, 8, {0, 1, 2, 3, 4, 5, 0, 1}, {0, 1, 2, 3, 4, 5, 1, 0}, {2, 2, 2, 3, 3, 3, 0.5, 0.501}};
  write(problem, folder.path() / "in.hdf5");
  const auto read = read_fclib(folder.path() / "in.hdf5");
  EXPECT_NEAR(read.asymmetry, 0.001 / 3, 1e-15);
  const auto& masses = std::get<ContactProblem>(read.problem);
  const VecX v = velocities(masses, VecX::Zero(6));
  EXPECT_NEAR(2 * v[0] + 0.501 * v[1], problem.f[0], 1e-15);
  EXPECT_NEAR(0.5 * v[0] + 2 * v[1], problem.f[1], 1e-15);
}

TEST(FclibIo, PlaceholdersAreNoSolutions) {
  const ScratchFolder folder;
  write(GlobalFile{}, folder.path() / "in.hdf5", [](hdf5::Hdf5Writer& file) {
    file.add_group("solution");
    file.add("solution/r", std::vector<double>(6, 0.0));
    file.add_group("guesses");
    file.add_group("guesses/1");
    file.add("guesses/1/r", std::vector<double>{1, 0, 0, 0, 0, 0});
  });
  const auto read = read_fclib(folder.path() / "in.hdf5");
  EXPECT_FALSE(read.solution.has_value());
  EXPECT_EQ(read.guess.value()[0], 1);
}

TEST(FclibIo, EveryFaultHasAMessage) {
  const ScratchFolder folder;
  const auto path = folder.path() / "bad.hdf5";
  const auto refused = [&](const std::string& words, const std::function<void(GlobalFile&)>& spoil) {
    GlobalFile problem;
    spoil(problem);
    write(problem, path);
    expect_refused(path, words);
  };
  refused("/fclib_global/vectors/mu: contact 1 is -0.1", [](auto& p) { p.mu[1] = -0.1; });
  refused("/fclib_global/vectors/mu: entry 0 is not finite", [](auto& p) { p.mu[0] = k_nan; });
  refused("/fclib_global/vectors/w: has 5 entries, needs 6", [](auto& p) { p.w.pop_back(); });
  refused("/fclib_global/vectors/f: entry 2 is not finite", [](auto& p) { p.f[2] = k_nan; });
  refused("/fclib_global/vectors/mu: is empty", [](auto& p) { p.mu.clear(); });
  refused("/fclib_global/spacedim: is 2", [](auto& p) { p.spacedim = 2; });
  refused("/fclib_global_rolling/spacedim: is 3", [](auto& p) { p.root = "fclib_global_rolling"; });
  refused("rolling friction is supported in the global form only", [](auto& p) { p.root = "fclib_local_rolling"; });
  refused("not an FCLIB file", [](auto& p) { p.root = "other"; });
  refused("/fclib_global/M/x: entry 3 is not finite", [](auto& p) { p.mass.x[3] = k_nan; });
  refused("/fclib_global/M/i: an index is outside", [](auto& p) { p.mass.i[3] = 6; });
  refused("/fclib_global/M/i: an index is outside", [](auto& p) { p.mass.i[3] = -1; });
  refused("/fclib_global/M/m: is 7", [](auto& p) { p.mass.m = 7; });
  refused("/fclib_global/M/p: has 6 entries, needs 2147483647",
          [](auto& p) { p.mass.nz = std::numeric_limits<int>::max(); });
  refused("/fclib_global/M/nz: is -3", [](auto& p) { p.mass.nz = -3; });
  refused("/fclib_global/M/nzmax: is 5", [](auto& p) { p.mass.nzmax = 5; });
  refused("/fclib_global/M/nzmax", [](auto& p) { p.mass.nzmax = std::numeric_limits<int>::max(); });
  refused("/fclib_global/M: its block 0 is not positive definite", [](auto& p) { p.mass.x[5] = -3; });
  refused("/fclib_global/M: is not symmetric", [](auto& p) {
    p.mass = {6, 6, 7, 7, {0, 1, 2, 3, 4, 5, 0}, {0, 1, 2, 3, 4, 5, 1}, {2, 2, 2, 3, 3, 3, 0.1}};
  });
  refused("/fclib_global/H/p: falls at entry 3", [](auto& p) { p.jacobian.p[2] = 8; });
  refused("/fclib_global/H/p: begins at 1", [](auto& p) { p.jacobian.p[0] = 1; });
  refused("/fclib_global/H/p: has 6 entries", [](auto& p) { p.jacobian.p.pop_back(); });
  refused("/fclib_global/H/i: has 9 entries, needs 90", [](auto& p) { p.jacobian.p.back() = 90; });
  refused("/fclib_global/H/i: an index is outside", [](auto& p) { p.jacobian.i[0] = 1000000; });
  refused("/fclib_global/H: H^T M^-1 H of contact 0",
          [](auto& p) { p.jacobian.x[0] = p.jacobian.x[1] = p.jacobian.x[2] = 0; });
}

TEST(FclibIo, WhatIsNotSupportedIsNamed) {
  const ScratchFolder folder;
  const auto path = folder.path() / "bad.hdf5";
  write(GlobalFile{}, path, [](hdf5::Hdf5Writer& file) {
    add_stored(file, "fclib_global/G", {6, 1, 1, -1, {0, 1}, {0}, {1}});
  });
  expect_refused(path, "/fclib_global/G: bilateral constraints are not supported");
  write(GlobalFile{}, path, [](hdf5::Hdf5Writer& file) { file.add("fclib_global/vectors/b", std::vector<double>{1}); });
  expect_refused(path, "/fclib_global/vectors/b: bilateral");
  write(GlobalFile{}, path, [](hdf5::Hdf5Writer& file) { file.add_group("fclib_local"); });
  expect_refused(path, "holds one problem");
  Stored skew = triplets();
  skew.x[7] = 0.6;
  write_local(skew, path);
  expect_refused(path, "/fclib_local/W: is not symmetric: 0.05");
  Stored still = triplets();
  still.x[0] = still.x[1] = still.x[2] = 0;
  write_local(still, path);
  expect_refused(path, "diagonal block of contact 0");
  write_local(triplets(), path, {0.3, 0.5, 0.1});
  expect_refused(path, "/fclib_local/vectors/q: has 6 entries, needs 9");
}

TEST(FclibIo, FilesThatCannotBeOpenedAreNoBadInput) {
  const ScratchFolder folder;
  EXPECT_THROW(read_fclib(folder.path() / "none.hdf5"), FileError);
  EXPECT_THROW(read_fclib(folder.path()), FileError);
  folder.write("text.hdf5", "not HDF5 at all");
  expect_refused(folder.path() / "text.hdf5", "is no HDF5 file");
  folder.write("empty.hdf5", "");
  expect_refused(folder.path() / "empty.hdf5", "is empty");
  EXPECT_THROW(write_fclib(folder.path() / "none/out.hdf5", LocalProblem{}, nullptr), FileError);
}

/// Whether a damaged file was refused with a message; false where the damage did not matter.
bool refused(const ScratchFolder& folder, const std::string& bytes) {
  const auto path = folder.write("damaged.hdf5", bytes);
  return test::refusal([&] { read_fclib(path); }) != "accepted";
}

TEST(FclibIo, TruncatedFilesAreRefused) {
  const ScratchFolder folder;
  write(GlobalFile{}, folder.path() / "good.hdf5");
  const std::string bytes = nilas_test::read_text(folder.path() / "good.hdf5");
  for (std::size_t length = 0; length < bytes.size(); length += 149)
    EXPECT_TRUE(refused(folder, bytes.substr(0, length))) << length;
  EXPECT_TRUE(refused(folder, bytes.substr(0, bytes.size() - 1)));
}

TEST(FclibIo, DamagedBytesAreRefusedOrHarmless) {
  const ScratchFolder folder;
  write(GlobalFile{}, folder.path() / "good.hdf5");
  const std::string good = nilas_test::read_text(folder.path() / "good.hdf5");
  std::mt19937 random(20);
  int bad = 0;
  constexpr int k_files = 200;
  for (int k = 0; k < k_files; ++k) {
    std::string bytes = good;
    for (int flips = 1 + static_cast<int>(random() % 6); flips > 0; --flips)
      bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    bad += refused(folder, bytes);
  }
  EXPECT_GT(bad, k_files / 10);
}

}  // namespace fclib_io_test
}  // namespace nilas::contact
