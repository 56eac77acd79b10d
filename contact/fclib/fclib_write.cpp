#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/fclib/fclib_io.h"
#include "contact/fclib/fclib_matrix.h"
#include "contact/fclib/fclib_rolling.h"
#include "core/base/error.h"
#include "core/hdf5/hdf5_file.h"

namespace nilas::contact {

namespace {

std::string law_name(Law law, int facets) {
  return law == Law::pyramid_k ? "pyramid-" + std::to_string(facets) : to_string(law);
}

struct Labels {
  std::string title, description;
};

template <class Problem>
void add_info(hdf5::Hdf5Writer& file, const std::string& root, const Labels& labels, const Problem& problem,
              int rows = 3) {
  file.add_group(root + "/info");
  file.add(root + "/info/title", labels.title);
  file.add(root + "/info/description", labels.description);
  file.add(root + "/info/math_info", "3D contact, law " + law_name(problem.law, problem.facets));
  file.add(root + "/spacedim", std::vector<int>{rows});
}

template <class Problem>
void add_coefficients(hdf5::Hdf5Writer& file, const std::string& vectors, const Problem& problem) {
  file.add(vectors + "/mu", problem.mu);
  if (problem.mu_static != problem.mu) file.add(vectors + "/mu_static", problem.mu_static);
  const auto& limits = problem.force_limit;
  if (!std::all_of(limits.begin(), limits.end(), [](double x) { return std::isinf(x); }))
    file.add(vectors + "/force_limit", limits);
  const auto add_unless_zero = [&](const char* name, const std::vector<double>& values) {
    if (!std::all_of(values.begin(), values.end(), [](double x) { return x == 0; })) file.add(vectors + name, values);
  };
  add_unless_zero("/compliance", problem.compliance);
  add_unless_zero("/tangential_compliance", problem.tangential_compliance);
}

void add_entry(std::vector<MatrixEntry>& entries, int row, int column, double value) {
  if (value != 0) entries.push_back({row, column, value});
}

std::vector<MatrixEntry> delassus_entries(const LocalProblem& problem) {
  std::vector<MatrixEntry> entries;
  for (int a = 0; a < problem.num_contacts(); ++a)
    for (int k = problem.row_start[a]; k < problem.row_start[a + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) add_entry(entries, 3 * a + i, 3 * problem.column[k] + j, problem.block[k](i, j));
  return entries;
}

/// `row_of`: row in the file of each velocity.
std::vector<MatrixEntry> mass_entries(const ContactProblem& problem, const std::vector<int>& row_of) {
  std::vector<MatrixEntry> entries;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    const auto mass = problem.mass(k);
    const int first = problem.block_offset[k];
    for (int j = 0; j < problem.block_size(k); ++j)
      for (int i = 0; i < problem.block_size(k); ++i)
        add_entry(entries, row_of[first + i], row_of[first + j], mass(i, j));
  }
  return entries;
}

std::vector<MatrixEntry> jacobian_entries(const ContactProblem& problem, const std::vector<int>& row_of) {
  std::vector<MatrixEntry> entries;
  const auto add_side = [&](int c, int block, const ContactProblem::ConstJacobian& jacobian) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < jacobian.cols(); ++j)
        add_entry(entries, row_of[problem.block_offset[block] + j], 3 * c + i, jacobian(i, j));
  };
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    if (pair.a >= 0) add_side(c, pair.a, problem.jacobian_a(c));
    if (pair.b >= 0) add_side(c, pair.b, problem.jacobian_b(c));
  }
  return entries;
}

/// Velocities in the order of the file's rows.
VecX in_file_order(const VecX& v, const std::vector<int>& row_of) {
  VecX ordered(v.size());
  for (Eigen::Index k = 0; k < v.size(); ++k) ordered[row_of[k]] = v[k];
  return ordered;
}

void add_problem(hdf5::Hdf5Writer& file, const LocalProblem& problem, const std::vector<int>&, const Labels& labels) {
  const std::string root = "fclib_local";
  const int rows = 3 * problem.num_contacts();
  file.add_group(root);
  add_info(file, root, labels, problem);
  add_matrix(file, root + "/W", rows, rows, delassus_entries(problem));
  file.add_group(root + "/vectors");
  file.add(root + "/vectors/q", problem.q);
  add_coefficients(file, root + "/vectors", problem);
}

/// Values of the contacts alone, without their moments.
template <class Value>
std::vector<Value> of_contacts(const RollingRows& rows, const std::vector<Value>& values) {
  std::vector<Value> out;
  for (const int c : rows.contact) out.push_back(values[c]);
  return out;
}

void add_rolling_problem(hdf5::Hdf5Writer& file, const ContactProblem& problem, const std::vector<int>& row_of,
                         const Labels& labels) {
  const std::string root = k_rolling_root;
  const RollingRows rows = RollingRows::of(problem);
  file.add_group(root);
  add_info(file, root, labels, problem, k_rolling_rows);
  add_matrix(file, root + "/M", problem.num_velocities(), problem.num_velocities(), mass_entries(problem, row_of));
  add_matrix(file, root + "/H", problem.num_velocities(), k_rolling_rows * rows.num_points(),
             rows.jacobian_for_file(jacobian_entries(problem, row_of)));
  file.add_group(root + "/vectors");
  file.add(root + "/vectors/f", in_file_order(problem.f, row_of));
  file.add(root + "/vectors/w", rows.velocities_for_file(problem.w));
  file.add(root + "/vectors/mu_r", rows.length);
  ContactProblem contacts;  // only what add_coefficients reads
  contacts.mu = of_contacts(rows, problem.mu);
  contacts.mu_static = of_contacts(rows, problem.mu_static);
  contacts.force_limit = of_contacts(rows, problem.force_limit);
  contacts.compliance = of_contacts(rows, problem.compliance);
  contacts.tangential_compliance = of_contacts(rows, problem.tangential_compliance);
  add_coefficients(file, root + "/vectors", contacts);
}

void add_problem(hdf5::Hdf5Writer& file, const ContactProblem& problem, const std::vector<int>& row_of,
                 const Labels& labels) {
  if (problem.has_moments()) return add_rolling_problem(file, problem, row_of, labels);
  const std::string root = "fclib_global";
  file.add_group(root);
  add_info(file, root, labels, problem);
  add_matrix(file, root + "/M", problem.num_velocities(), problem.num_velocities(), mass_entries(problem, row_of));
  add_matrix(file, root + "/H", problem.num_velocities(), 3 * problem.num_contacts(),
             jacobian_entries(problem, row_of));
  file.add_group(root + "/vectors");
  file.add(root + "/vectors/f", in_file_order(problem.f, row_of));
  file.add(root + "/vectors/w", problem.w);
  add_coefficients(file, root + "/vectors", problem);
}

template <class Problem>
void add_solution(hdf5::Hdf5Writer& file, const Problem& problem, const ContactSolution& solution,
                  const std::vector<int>& row_of) {
  file.add_group("solution");
  if constexpr (std::is_same_v<Problem, ContactProblem>) {
    if (problem.has_moments()) {
      const RollingRows rows = RollingRows::of(problem);
      file.add("solution/r", rows.impulses_for_file(solution.r));
      file.add("solution/u", rows.velocities_for_file(solution.u));
      file.add("solution/v", in_file_order(solution.v, row_of));
      return;
    }
  }
  file.add("solution/r", solution.r);
  file.add("solution/u", solution.u);
  if (solution.v.size() > 0) file.add("solution/v", in_file_order(solution.v, row_of));
}

template <class Problem>
void add_guess(hdf5::Hdf5Writer& file, const Problem& problem, const VecX& guess) {
  file.add_group("guesses");
  file.add_group("guesses/1");
  if constexpr (std::is_same_v<Problem, ContactProblem>) {
    if (problem.has_moments()) {
      file.add("guesses/1/r", RollingRows::of(problem).impulses_for_file(guess));
      return;
    }
  }
  file.add("guesses/1/r", guess);
}

template <class Problem>
void write(const std::filesystem::path& path, const Problem& problem, const std::vector<int>& row_of,
           const Labels& labels, const std::optional<VecX>& guess, const ContactSolution* solution) {
  hdf5::Hdf5Writer file;
  add_problem(file, problem, row_of, labels);
  if (guess) add_guess(file, problem, *guess);
  if (solution) add_solution(file, problem, *solution, row_of);
  file.save(path);
}

}  // namespace

void write_fclib(const std::filesystem::path& path, const FclibProblem& problem, const ContactSolution* solution) {
  std::visit(
      [&](const auto& form) {
        write(path, form, problem.dof_of_file, {problem.title, problem.description}, problem.guess, solution);
      },
      problem.problem);
}

void write_fclib(const std::filesystem::path& path, const LocalProblem& problem, const ContactSolution* solution) {
  write(path, problem, {}, {path.stem().string(), ""}, {}, solution);
}

void write_fclib(const std::filesystem::path& path, const ContactProblem& problem, const ContactSolution* solution) {
  std::vector<int> as_is(problem.num_velocities());
  std::iota(as_is.begin(), as_is.end(), 0);
  write(path, problem, as_is, {path.stem().string(), ""}, {}, solution);
}

}  // namespace nilas::contact
