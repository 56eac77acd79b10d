#include "contact/fclib/fclib_io.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/fclib/fclib_blocks.h"
#include "contact/fclib/fclib_matrix.h"
#include "contact/fclib/fclib_rolling.h"
#include "contact/problem/mass_inverse.h"
#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::contact {

namespace {

/// Largest relative asymmetry that gyroscopic terms and inexact frames explain; measured ones are up to 1e-3.
constexpr double k_most_asymmetry = 1e-2;
/// Most numbers in dense mass blocks beyond ten per stored one: one block of 4000 degrees of freedom.
constexpr std::size_t k_most_mass_numbers = 16'000'000;

std::vector<double> as_list(const VecX& x) { return {x.data(), x.data() + x.size()}; }

VecX read_vector(const hdf5::Hdf5Reader& file, const std::string& name, int size) {
  const auto found = file.size(name);
  if (found != static_cast<std::size_t>(size))
    file.refuse(name, "has " + std::to_string(found) + " entries, needs " + std::to_string(size));
  return file.numbers(name);
}

/// nc, from the length of mu.
int read_num_contacts(const hdf5::Hdf5Reader& file, const std::string& vectors) {
  const std::size_t count = file.size(vectors + "/mu");
  if (count == 0) file.refuse(vectors + "/mu", "is empty; a problem has contacts");
  constexpr auto k_most = static_cast<std::size_t>(std::numeric_limits<int>::max() / k_rolling_rows);
  if (count > k_most) file.refuse(vectors + "/mu", "has more entries than are supported");
  return static_cast<int>(count);
}

/// A coefficient per contact from the file where it is there.
std::vector<double> read_extra(const hdf5::Hdf5Reader& file, const std::string& name, int nc,
                               const std::vector<double>& otherwise) {
  if (!file.has(name)) return otherwise;
  if (file.size(name) != static_cast<std::size_t>(nc)) file.refuse(name, "needs " + std::to_string(nc) + " entries");
  return as_list(file.numbers_or_infinity(name));
}

void demand_at_least(const hdf5::Hdf5Reader& file, const std::string& name, const std::vector<double>& values,
                     const std::vector<double>& least) {
  for (std::size_t c = 0; c < values.size(); ++c)
    if (!(values[c] >= least[c]))
      file.refuse(name, "contact " + std::to_string(c) + " is " + std::to_string(values[c]) + ", needs at least " +
                            std::to_string(least[c]));
}

template <class Problem>
void read_coefficients(const hdf5::Hdf5Reader& file, const std::string& vectors, int nc, Problem& problem) {
  const std::vector<double> none(nc, 0.0);
  problem.mu = as_list(read_vector(file, vectors + "/mu", nc));
  demand_at_least(file, vectors + "/mu", problem.mu, none);
  problem.mu_static = read_extra(file, vectors + "/mu_static", nc, problem.mu);
  demand_at_least(file, vectors + "/mu_static", problem.mu_static, problem.mu);
  problem.force_limit =
      read_extra(file, vectors + "/force_limit", nc, std::vector<double>(nc, std::numeric_limits<double>::infinity()));
  demand_at_least(file, vectors + "/force_limit", problem.force_limit, none);
  problem.compliance = read_extra(file, vectors + "/compliance", nc, none);
  demand_at_least(file, vectors + "/compliance", problem.compliance, none);
  problem.tangential_compliance = read_extra(file, vectors + "/tangential_compliance", nc, none);
  demand_at_least(file, vectors + "/tangential_compliance", problem.tangential_compliance, none);
  problem.key.clear();
  for (int c = 0; c < nc; ++c) problem.key.push_back(static_cast<std::uint64_t>(c));
}

void refuse_bilateral(const hdf5::Hdf5Reader& file, const std::string& root,
                      std::initializer_list<const char*> matrices, const char* vector) {
  const std::string fault = "bilateral constraints are not supported, contacts alone are";
  for (const char* matrix : matrices)
    if (has_matrix(file, root + "/" + matrix)) file.refuse(root + "/" + matrix, fault);
  const std::string name = root + "/vectors/" + vector;
  if (file.has(name) && file.size(name) > 0) file.refuse(name, fault);
}

void refuse_asymmetry(const hdf5::Hdf5Reader& file, const std::string& name, double asymmetry) {
  if (!(asymmetry <= k_most_asymmetry))
    file.refuse(name, "is not symmetric: " + std::to_string(asymmetry) + " relative, at most " +
                          std::to_string(k_most_asymmetry) + " is supported");
}

/// Places a list of entries in blocks of 3 x 3, rows in order, with every diagonal block.
void fill_blocks(std::vector<MatrixEntry> entries, int nc, LocalProblem& problem) {
  for (int k = 0; k < nc; ++k) entries.push_back({3 * k, 3 * k, 0.0});
  std::stable_sort(entries.begin(), entries.end(), [](const MatrixEntry& a, const MatrixEntry& b) {
    return a.row / 3 != b.row / 3 ? a.row < b.row : a.column / 3 < b.column / 3;
  });
  int row = -1;
  for (const auto& entry : entries) {
    const int a = entry.row / 3, b = entry.column / 3;
    if (a != row || problem.column.back() != b) {
      problem.column.push_back(b);
      problem.block.emplace_back(Mat3::Zero());
    }
    row = a;
    problem.block.back()(entry.row % 3, entry.column % 3) += entry.value;
    problem.row_start.resize(a + 1);
    problem.row_start.push_back(static_cast<int>(problem.column.size()));
  }
}

LocalProblem read_local(const hdf5::Hdf5Reader& file, const std::string& root) {
  refuse_bilateral(file, root, {"V", "R"}, "s");
  LocalProblem problem;
  const int nc = read_num_contacts(file, root + "/vectors");
  read_coefficients(file, root + "/vectors", nc, problem);
  problem.q = read_vector(file, root + "/vectors/q", 3 * nc);
  fill_blocks(read_matrix(file, root + "/W", 3 * nc, 3 * nc), nc, problem);
  for (int c = 0; c < nc; ++c)
    if (!(problem.diagonal(c).trace() > 0) || !problem.diagonal(c).allFinite())
      file.refuse(root + "/W", "the diagonal block of contact " + std::to_string(c) +
                                   " has no positive finite trace: nothing can move there");
  return problem;
}

/// Where each degree of freedom of the file lies: in which block, and at which place within it.
struct DofPlaces {
  std::vector<int> block, place;
  DofPlaces(int ndof, const std::vector<std::vector<int>>& blocks) : block(ndof), place(ndof) {
    for (std::size_t k = 0; k < blocks.size(); ++k)
      for (std::size_t i = 0; i < blocks[k].size(); ++i) {
        block[blocks[k][i]] = static_cast<int>(k);
        place[blocks[k][i]] = static_cast<int>(i);
      }
  }
};

void set_blocks(const hdf5::Hdf5Reader& file, const std::string& name, const std::vector<std::vector<int>>& blocks,
                std::size_t stored, ContactProblem& problem) {
  for (const auto& block : blocks) {
    problem.block_offset.push_back(problem.block_offset.back() + static_cast<int>(block.size()));
    problem.mass_offset.push_back(problem.mass_offset.back() + block.size() * block.size());
  }
  if (problem.mass_offset.back() > k_most_mass_numbers + 10 * stored)
    file.refuse(name, "bodies cannot be told apart: contacts join blocks of too many degrees of freedom");
}

/// Fills the mass blocks; returns their largest asymmetry relative to the largest entry of M.
double fill_masses(const std::vector<MatrixEntry>& entries, const DofPlaces& places, ContactProblem& problem) {
  problem.mass_data.assign(problem.mass_offset.back(), 0.0);
  for (const auto& entry : entries) {
    const int k = places.block[entry.row];
    const std::size_t n = problem.block_size(k);
    problem.mass_data[problem.mass_offset[k] + n * places.place[entry.column] + places.place[entry.row]] += entry.value;
  }
  double largest = 0, difference = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto mass = problem.mass(k);
    largest = std::max(largest, mass.cwiseAbs().maxCoeff());
    difference = std::max(difference, (mass - mass.transpose()).cwiseAbs().maxCoeff());
  }
  return largest > 0 ? difference / largest : 0;
}

/// The blocks that a contact touches, the lower one first; the first is -1 where there is one alone.
void add_block_to(ContactProblem::Pair& pair, int block) {
  if (block == pair.a || block == pair.b) return;
  pair.a = pair.b;
  pair.b = block;
  if (pair.a > pair.b) std::swap(pair.a, pair.b);
}

void fill_jacobians(const std::vector<MatrixEntry>& entries, const DofPlaces& places, int nc, ContactProblem& problem) {
  const auto size_of = [&problem](int block) { return block < 0 ? std::size_t{0} : problem.block_size(block); };
  problem.pairs.assign(nc, {});
  for (const auto& entry : entries) add_block_to(problem.pairs[entry.column / 3], places.block[entry.row]);
  for (std::size_t c = 0; c < problem.moments.size(); ++c)
    if (problem.moments[c].contact >= 0) problem.pairs[c] = problem.pairs[problem.moments[c].contact];
  for (const auto& pair : problem.pairs)
    problem.jacobian_offset.push_back(problem.jacobian_offset.back() + 3 * (size_of(pair.a) + size_of(pair.b)));
  problem.jacobian_data.assign(problem.jacobian_offset.back(), 0.0);
  for (const auto& entry : entries) {
    const std::size_t c = entry.column / 3, direction = entry.column % 3;
    const int block = places.block[entry.row];
    const bool second = block == problem.pairs[c].b;
    const std::size_t first = problem.jacobian_offset[c] + (second ? 3 * size_of(problem.pairs[c].a) : 0);
    problem.jacobian_data[first + direction * size_of(block) + places.place[entry.row]] += entry.value;
  }
}

void refuse_unmovable(const hdf5::Hdf5Reader& file, const std::string& root, const ContactProblem& problem) {
  const int bad = MassInverse(problem).first_bad_block();
  if (bad >= 0) file.refuse(root + "/M", "its block " + std::to_string(bad) + " is not positive definite");
  const auto diagonal = delassus_diagonal(problem);
  for (std::size_t c = 0; c < diagonal.size(); ++c)
    if (!problem.is_moment(static_cast<int>(c)) && (!(diagonal[c].trace() > 0) || !diagonal[c].allFinite()))
      file.refuse(root + "/H", "H^T M^-1 H of contact " + std::to_string(c) +
                                   " has no positive finite trace: nothing can move there");
}

int read_num_velocities(const hdf5::Hdf5Reader& file, const std::string& name) {
  const std::size_t count = file.size(name);
  if (count == 0 || count > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    file.refuse(name, "has " + std::to_string(count) + " entries; not supported");
  return static_cast<int>(count);
}

/// The rolling form's rows (N, T1, T2, R1, R2) as a contact (N, T1, T2) and, where mu_r > 0, a moment (0, R1, R2).
RollingRows read_rolling_rows(const hdf5::Hdf5Reader& file, const std::string& vectors, int nc) {
  RollingRows rows;
  rows.length = as_list(read_vector(file, vectors + "/mu_r", nc));
  demand_at_least(file, vectors + "/mu_r", rows.length, std::vector<double>(nc, 0.0));
  rows.number();
  return rows;
}

/// Appends the moments' coefficients and links.
void add_moments(const RollingRows& rows, ContactProblem& problem) {
  const int nc = rows.num_points();
  problem.moments.resize(rows.num_rows());
  for (int c = 0; c < nc; ++c) {
    const int m = rows.moment[c];
    if (m < 0) continue;
    problem.moments[c].moment = m;
    problem.moments[m].contact = c;
    problem.moments[m].rolling = rows.length[c];
    problem.mu.push_back(1);
    problem.mu_static.push_back(1);
    problem.force_limit.push_back(std::numeric_limits<double>::infinity());
    problem.compliance.push_back(0);
    problem.tangential_compliance.push_back(0);
    problem.key.push_back(static_cast<std::uint64_t>(m));
  }
}

/// A moment acts between the two blocks of its contact.
void demand_same_blocks(const hdf5::Hdf5Reader& file, const std::string& root, const RollingRows& rows,
                        const std::vector<MatrixEntry>& jacobian, const DofPlaces& places) {
  std::vector<ContactProblem::Pair> pairs(rows.num_rows());
  for (const auto& entry : jacobian) add_block_to(pairs[entry.column / 3], places.block[entry.row]);
  for (int c = 0; c < rows.num_points(); ++c) {
    if (rows.moment[c] < 0) continue;
    const auto& own = pairs[c];
    const auto& moment = pairs[rows.moment[c]];
    for (const int block : {moment.a, moment.b})
      if (block >= 0 && block != own.a && block != own.b)
        file.refuse(root + "/H", "the moment of contact " + std::to_string(c) + " acts on another body than its force");
  }
}

/// Reads the global form, with or without rolling friction, into `out`.
void read_global(const hdf5::Hdf5Reader& file, const std::string& root, FclibProblem& out) {
  refuse_bilateral(file, root, {"G"}, "b");
  ContactProblem problem;
  const int nc = read_num_contacts(file, root + "/vectors");
  const int ndof = read_num_velocities(file, root + "/vectors/f");
  read_coefficients(file, root + "/vectors", nc, problem);
  const VecX f = read_vector(file, root + "/vectors/f", ndof);
  const auto mass = read_matrix(file, root + "/M", ndof, ndof);
  std::vector<MatrixEntry> jacobian;
  RollingRows rows;
  if (root == k_rolling_root) {
    rows = read_rolling_rows(file, root + "/vectors", nc);
    problem.w = rows.velocities(read_vector(file, root + "/vectors/w", k_rolling_rows * nc));
    jacobian = rows.jacobian(read_matrix(file, root + "/H", ndof, k_rolling_rows * nc));
    add_moments(rows, problem);
  } else {
    problem.w = read_vector(file, root + "/vectors/w", 3 * nc);
    jacobian = read_matrix(file, root + "/H", ndof, 3 * nc);
  }
  const int num_rows = static_cast<int>(problem.mu.size());
  const auto blocks = split_into_blocks(ndof, mass, jacobian, num_rows);
  const DofPlaces places(ndof, blocks);
  set_blocks(file, root + "/M", blocks, mass.size(), problem);
  out.asymmetry = fill_masses(mass, places, problem);
  refuse_asymmetry(file, root + "/M", out.asymmetry);
  if (problem.has_moments()) demand_same_blocks(file, root, rows, jacobian, places);
  fill_jacobians(jacobian, places, num_rows, problem);
  for (const auto& block : blocks) out.dof_of_file.insert(out.dof_of_file.end(), block.begin(), block.end());
  problem.f = f(out.dof_of_file);
  refuse_unmovable(file, root, problem);
  out.problem = std::move(problem);
}

/// Impulses of `name` unless absent, never written or all zero.
std::optional<VecX> read_impulses(const hdf5::Hdf5Reader& file, const std::string& name, const FclibProblem& of) {
  if (!file.is_filled(name)) return {};
  const auto* const global = std::get_if<ContactProblem>(&of.problem);
  const bool rolling = global && global->has_moments();
  VecX r = read_vector(file, name, (rolling ? k_rolling_rows : 3) * of.num_contacts());
  if (r.isZero(0)) return {};
  if (!rolling) return r;
  return RollingRows::of(*global).impulses(r);
}

/// The group of the problem; refuses forms that are not supported.
std::string find_root(const hdf5::Hdf5Reader& file) {
  if (file.has("fclib_local_rolling"))
    file.refuse("fclib_local_rolling", "rolling friction is supported in the global form only");
  std::vector<std::string> found;
  for (const char* root : {"fclib_local", "fclib_global", k_rolling_root})
    if (file.has(root)) found.emplace_back(root);
  if (found.size() > 1) file.refuse(found[0], "stands beside /" + found[1] + "; a file holds one problem");
  if (found.empty()) file.refuse("fclib_local", "is missing, and so is /fclib_global: not an FCLIB file");
  const std::string& root = found.front();
  const int dimensions = file.integer(root + "/spacedim"), needed = root == k_rolling_root ? k_rolling_rows : 3;
  if (dimensions != needed)
    file.refuse(root + "/spacedim", "is " + std::to_string(dimensions) + "; only " + std::to_string(needed) +
                                        " rows per contact, in three dimensions, are supported here");
  return root;
}

}  // namespace

int FclibProblem::num_contacts() const {
  if (const auto* const global = std::get_if<ContactProblem>(&problem)) return global->num_points();
  return std::get<LocalProblem>(problem).num_contacts();
}

int FclibProblem::num_velocities() const { return static_cast<int>(dof_of_file.size()); }

FclibProblem read_fclib(const std::filesystem::path& path) {
  const hdf5::Hdf5Reader file(path);
  const std::string root = find_root(file);
  FclibProblem out;
  if (root != "fclib_local") {
    read_global(file, root, out);
  } else {
    LocalProblem problem = read_local(file, root);
    out.asymmetry = asymmetry(problem);
    refuse_asymmetry(file, root + "/W", out.asymmetry);
    out.problem = std::move(problem);
  }
  out.title = file.text(root + "/info/title");
  out.description = file.text(root + "/info/description");
  out.solution = read_impulses(file, "solution/r", out);
  out.guess = read_impulses(file, "guesses/1/r", out);
  return out;
}

}  // namespace nilas::contact
