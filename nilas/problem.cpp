#include "nilas/problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "contact/problem/row_of.h"
#include "nilas/error.h"
#include "nilas/problem_content.h"
#include "nilas/translate.h"

namespace nilas {

namespace {

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstRowMajor = Eigen::Map<const RowMajorMatrix>;

/// A dense W takes 72 bytes per pair of contacts: 650 MB at this number.
constexpr int k_most_for_delassus = 3000;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::input, message); }

void demand_size(const char* what, std::size_t found, std::size_t wanted) {
  if (found != wanted)
    refuse(std::string(what) + " has " + std::to_string(found) + " numbers; allowed: " + std::to_string(wanted));
}

/// The number of contacts of which W has three rows each; none where it is not square, or has other rows.
std::optional<std::size_t> contacts_of_matrix(std::size_t numbers) {
  const auto rows = static_cast<std::size_t>(std::llround(std::sqrt(static_cast<double>(numbers))));
  if (rows * rows != numbers || rows % 3 != 0) return std::nullopt;
  return rows / 3;
}

/// Refuses lists of a local problem whose lengths do not fit each other. Of the three, that against the other two is to
/// blame.
void demand_agreement(std::size_t W, std::size_t q, std::size_t mu) {
  const auto of_W = contacts_of_matrix(W);
  const auto of_q = q % 3 == 0 ? std::optional(q / 3) : std::nullopt;
  if (of_W == mu && of_q == mu) return;
  const auto text = [](std::size_t n) { return std::to_string(n); };
  const auto squared = [&](std::size_t rows) {
    return text(rows * rows) + " (" + text(rows) + " x " + text(rows) + ")";
  };
  if (of_W && of_W == of_q)
    refuse("mu has " + text(mu) + " numbers; allowed: " + text(*of_W) + ", one for each contact of W, " +
           squared(3 * *of_W) + ", and q, " + text(q));
  if (of_q == mu)
    refuse("W has " + text(W) + " numbers; allowed: " + squared(3 * mu) + ", since q has " + text(q) + " and mu " +
           text(mu));
  if (of_W == mu)
    refuse("q has " + text(q) + " numbers; allowed: " + text(3 * mu) + ", since W has " + squared(3 * mu) + " and mu " +
           text(mu));
  refuse("W has " + text(W) + " numbers, q " + text(q) + " and mu " + text(mu) +
         "; allowed for nc contacts: (3 nc) x (3 nc), 3 nc and nc");
}

void demand_finite(const char* what, std::span<const double> numbers) {
  for (const double x : numbers)
    if (!std::isfinite(x)) refuse(std::string(what) + " has a number that is not finite");
}

VecX vector_of(std::span<const double> x) {
  return Eigen::Map<const VecX>(x.data(), static_cast<Eigen::Index>(x.size()));
}

contact::LocalProblem dense_local(std::span<const double> W, std::span<const double> q, std::span<const double> mu) {
  const auto nc = static_cast<int>(mu.size());
  const Eigen::Index rows = contact::row_of(nc);
  const ConstRowMajor matrix(W.data(), rows, rows);
  contact::LocalProblem local;
  for (int a = 0; a < nc; ++a) {
    for (int b = 0; b < nc; ++b) {
      const Mat3 block = matrix.block<3, 3>(contact::row_of(a), contact::row_of(b));
      if (a != b && block.isZero(0)) continue;
      local.column.push_back(b);
      local.block.push_back(block);
    }
    local.row_start.push_back(static_cast<int>(local.column.size()));
  }
  local.q = vector_of(q);
  return local;
}

/// Contact coefficients with defaults for everything but friction.
void set_coefficients(std::span<const double> mu, contact::ContactCoefficients& coefficients) {
  coefficients.mu.assign(mu.begin(), mu.end());
  coefficients.mu_static = coefficients.mu;
  coefficients.force_limit.assign(mu.size(), std::numeric_limits<double>::infinity());
  coefficients.compliance.assign(mu.size(), 0);
  coefficients.tangential_compliance.assign(mu.size(), 0);
  for (std::size_t c = 0; c < mu.size(); ++c) coefficients.key.push_back(c);
}

contact::FclibProblem stored(std::variant<contact::LocalProblem, contact::ContactProblem> problem) {
  contact::FclibProblem all;
  all.problem = std::move(problem);
  return all;
}

}  // namespace

namespace library {

VecX impulses_of(const Problem::Content& content, std::span<const double> r, const char* what) {
  demand_size(what, r.size(), static_cast<std::size_t>(contact::row_of(content.stored.num_contacts())));
  demand_finite(what, r);
  return vector_of(r);
}

std::vector<double> listed(const VecX& x) { return {x.data(), x.data() + x.size()}; }

void forget_impulses(Problem::Content& content) {
  content.stored.guess.reset();
  content.stored.solution.reset();
}

std::vector<double> in_order_of_file(const Problem::Content& content, const VecX& v) {
  std::vector<double> ordered(static_cast<std::size_t>(v.size()));
  for (Eigen::Index k = 0; k < v.size(); ++k) ordered[static_cast<std::size_t>(content.stored.dof_of_file[k])] = v[k];
  return ordered;
}

}  // namespace library

Problem::Problem() : content_(std::make_unique<Content>()) { content_->stored.problem = contact::ContactProblem(); }
Problem::Problem(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Problem::Problem(const Problem& other) : content_(std::make_unique<Content>(*other.content_)) {}
Problem::Problem(Problem&& other) noexcept = default;
Problem& Problem::operator=(const Problem& other) {
  if (this != &other) content_ = std::make_unique<Content>(*other.content_);
  return *this;
}
Problem& Problem::operator=(Problem&& other) noexcept = default;
Problem::~Problem() = default;

Problem Problem::local(std::span<const double> W, std::span<const double> q, std::span<const double> mu) {
  return library::translated([&] {
    demand_agreement(W.size(), q.size(), mu.size());
    demand_finite("W", W);
    demand_finite("q", q);
    demand_finite("mu", mu);
    for (const double friction : mu)
      if (friction < 0) refuse("mu has a negative number; allowed: 0 and above");
    contact::LocalProblem local = dense_local(W, q, mu);
    set_coefficients(mu, local);
    contact::validate(local);
    return Problem(std::make_unique<Content>(Content{stored(std::move(local))}));
  });
}

Problem Problem::read(const std::filesystem::path& file) {
  return library::translated([&] { return Problem(std::make_unique<Content>(Content{contact::read_fclib(file)})); });
}

int Problem::add_body(std::span<const double> mass, std::span<const double> momentum) {
  return library::translated([&] {
    auto* const global = std::get_if<contact::ContactProblem>(&content_->stored.problem);
    if (!global) refuse("a problem in its local form takes no bodies");
    const std::size_t n = momentum.size();
    if (n == 0) refuse("a body has at least one velocity");
    if (mass.size() != n * n)
      refuse("mass has " + std::to_string(mass.size()) + " numbers and momentum " + std::to_string(n) +
             "; allowed for n velocities: n x n and n");
    demand_finite("mass", mass);
    demand_finite("momentum", momentum);
    const auto rows = static_cast<Eigen::Index>(n);
    const MatX matrix = ConstRowMajor(mass.data(), rows, rows);
    const Eigen::LLT<MatX> factor(matrix);
    if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > 1e-9 * matrix.cwiseAbs().maxCoeff() ||
        factor.info() != Eigen::Success)
      refuse("the mass of a body is not symmetric and positive definite");
    library::forget_impulses(*content_);
    const int body = global->add_block(matrix);
    global->f.tail(rows) = vector_of(momentum);
    for (Eigen::Index k = 0; k < rows; ++k)
      content_->stored.dof_of_file.push_back(static_cast<int>(content_->stored.dof_of_file.size()));
    return body;
  });
}

int Problem::add_contact(int body_a, std::span<const double> jacobian_a, int body_b, std::span<const double> jacobian_b,
                         std::span<const double> w, double mu) {
  return library::translated([&] {
    auto* const global = std::get_if<contact::ContactProblem>(&content_->stored.problem);
    if (!global) refuse("a problem in its local form takes no contacts");
    const auto side = [&](const char* what, int body, std::span<const double> jacobian) -> MatX {
      if (body < -1 || body >= global->num_blocks())
        refuse("there is no body " + std::to_string(body) + "; allowed: -1 to " +
               std::to_string(global->num_blocks() - 1));
      const int columns = body < 0 ? 0 : global->block_size(body);
      if (jacobian.size() != 3 * static_cast<std::size_t>(columns))
        refuse(std::string(what) + " has " + std::to_string(jacobian.size()) +
               " numbers; allowed: " + std::to_string(3 * columns) + ", in 3 rows for the " + std::to_string(columns) +
               " velocities of body " + std::to_string(body));
      demand_finite(what, jacobian);
      return ConstRowMajor(jacobian.data(), 3, columns);
    };
    const MatX a = side("jacobian_a", body_a, jacobian_a), b = side("jacobian_b", body_b, jacobian_b);
    if (body_a < 0 && body_b < 0) refuse("a contact needs a body that moves");
    if (body_a == body_b) refuse("a contact needs two different bodies");
    demand_size("w", w.size(), 3);
    demand_finite("w", w);
    if (!(mu >= 0) || !std::isfinite(mu)) refuse("mu must be a finite number of 0 or above");
    library::forget_impulses(*content_);
    const auto largest = std::max_element(global->key.begin(), global->key.end());
    const int contact = global->add_contact(body_a, a, body_b, b, largest == global->key.end() ? 0 : *largest + 1);
    global->mu.back() = global->mu_static.back() = mu;
    global->w.tail<3>() = vector_of(w);
    return contact;
  });
}

int Problem::num_contacts() const { return content_->stored.num_contacts(); }
int Problem::num_velocities() const { return content_->stored.num_velocities(); }
bool Problem::is_local() const { return content_->local() != nullptr; }

std::vector<double> Problem::mu() const {
  return std::visit([](const auto& form) { return form.mu; }, content_->stored.problem);
}

std::vector<double> Problem::delassus() const {
  return library::translated([&] {
    if (num_contacts() > k_most_for_delassus)
      refuse("the Delassus operator of " + std::to_string(num_contacts()) +
             " contacts is too large; allowed: " + std::to_string(k_most_for_delassus));
    const auto dense = [](const contact::LocalProblem& local) {
      const RowMajorMatrix matrix = contact::sparse_matrix(local);
      return std::vector<double>(matrix.data(), matrix.data() + matrix.size());
    };
    if (const auto* local = content_->local()) return dense(*local);
    return dense(contact::reduce(*content_->global()));
  });
}

std::vector<double> Problem::q() const {
  return contact_velocities(std::vector<double>(3 * static_cast<std::size_t>(num_contacts())));
}

std::vector<double> Problem::contact_velocities(std::span<const double> r) const {
  return library::translated([&] {
    const VecX impulses = library::impulses_of(*content_, r);
    if (const auto* local = content_->local()) return library::listed(contact::contact_velocities(*local, impulses));
    const contact::ContactProblem& global = *content_->global();
    return library::listed(contact::contact_velocities(global, contact::velocities(global, impulses)));
  });
}

std::vector<double> Problem::velocities(std::span<const double> r) const {
  return library::translated([&] {
    const VecX impulses = library::impulses_of(*content_, r);
    if (is_local()) return std::vector<double>();
    return library::in_order_of_file(*content_, contact::velocities(*content_->global(), impulses));
  });
}

std::vector<double> Problem::guess() const {
  return content_->stored.guess ? library::listed(*content_->stored.guess) : std::vector<double>();
}

std::vector<double> Problem::solution() const {
  return content_->stored.solution ? library::listed(*content_->stored.solution) : std::vector<double>();
}

void Problem::write(const std::filesystem::path& file, std::span<const double> impulses) const {
  library::translated([&] {
    if (impulses.empty()) {
      contact::write_fclib(file, content_->stored, nullptr);
      return;
    }
    contact::ContactSolution solution;
    solution.r = library::impulses_of(*content_, impulses);
    if (const auto* local = content_->local()) {
      solution.u = contact::contact_velocities(*local, solution.r);
    } else {
      solution.v = contact::velocities(*content_->global(), solution.r);
      solution.u = contact::contact_velocities(*content_->global(), solution.v);
    }
    contact::write_fclib(file, content_->stored, &solution);
  });
}

}  // namespace nilas
