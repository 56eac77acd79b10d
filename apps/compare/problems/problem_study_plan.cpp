#include "apps/compare/problems/problem_study_plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "apps/compare/workshop/special_numbers.h"
#include "contact/registry.h"
#include "core/base/error.h"

namespace nilas::compare {

namespace {

constexpr int k_enumerable = 8;     // contacts
constexpr int k_small = 50;         // contacts, for which the finest tolerance is cheap
constexpr double k_finest = 1e-10;  // [m/s]
constexpr double k_shares = 2;      // of the budget per run: about half of the runs reach their limit
constexpr double k_least_limit = 0.2, k_most_limit = 60;  // [s]
constexpr double k_per_contact = 6e-4;                    // mean over all solvers, for the estimate [s]

const std::vector<double>& usual_tolerances() {
  static const std::vector<double> all{1e-2, 1e-4, 1e-6, 1e-8, k_finest};
  return all;
}

bool takes(const contact::SolverEntry& entry, Law law) {
  return std::find(entry.laws.begin(), entry.laws.end(), law) != entry.laws.end();
}

/// Why a solver cannot solve a problem; empty if it can.
std::string why_not(const contact::SolverEntry& entry, Law law, const StudyFile& file) {
  try {
    contact::demand_law(entry, law);
    if (file.moments) contact::demand_moments(entry, law);
  } catch (const InputError& error) {
    return error.what();
  }
  if (entry.name == "enumerate" && file.problem.contacts > k_enumerable)
    return "enumerate takes up to " + std::to_string(k_enumerable) + " contacts";
  return "";
}

/// The radical inverse of k in base 2, which mirrors its bits at the binary point: 0, 1/2, 1/4, 3/4, 1/8 ...
double radical_inverse(std::uint64_t k) {
  double x = 0;
  for (double weight = 0.5; k > 0; k >>= 1U, weight /= 2) x += static_cast<double>(k & 1U) * weight;
  return x;
}

/// The readable files in an order in which each stretch spans all sizes.
std::vector<std::size_t> spread(const std::vector<StudyFile>& files) {
  std::vector<std::size_t> by_size;
  for (std::size_t k = 0; k < files.size(); ++k)
    if (files[k].fault.empty()) by_size.push_back(k);
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](std::size_t a, std::size_t b) { return files[a].problem.contacts < files[b].problem.contacts; });
  std::vector<std::size_t> place(by_size.size());
  std::iota(place.begin(), place.end(), std::size_t{0});
  std::stable_sort(place.begin(), place.end(),
                   [](std::size_t a, std::size_t b) { return radical_inverse(a) < radical_inverse(b); });
  std::vector<std::size_t> out;
  for (const std::size_t k : place) out.push_back(by_size[k]);
  return out;
}

std::vector<std::string> solvers_for(const StudyChoice& choice, Law law, const std::vector<StudyFile>& files) {
  if (!choice.solvers.empty()) return choice.solvers;
  const bool any_small = std::any_of(files.begin(), files.end(), [](const StudyFile& file) {
    return file.fault.empty() && file.problem.contacts <= k_enumerable;
  });
  std::vector<std::string> names;
  for (const auto& entry : contact::solver_registry())
    if (takes(entry, law) && (any_small || entry.name != "enumerate")) names.push_back(entry.name);
  return names;
}

/// The runs that are compared with each other: those of one problem, law and tolerance.
using Block = std::vector<StudyRun>;

std::vector<Block> all_blocks(const std::vector<StudyFile>& files, const StudyChoice& choice) {
  std::vector<Block> blocks;
  const bool usual = choice.tolerances.empty();
  const std::vector<std::size_t> order = spread(files);
  for (const double tolerance : middle_first(usual ? usual_tolerances() : choice.tolerances))
    for (const std::size_t file : order) {
      if (usual && tolerance == k_finest && files[file].problem.contacts > k_small) continue;
      for (const auto& law : choice.laws) {
        Block block;
        for (const auto& solver : solvers_for(choice, parse_law(law).law, files))
          block.push_back({file, solver, law, tolerance});
        blocks.push_back(block);
      }
    }
  return blocks;
}

double with_two_digits(double seconds) {
  const double unit = std::pow(10, std::floor(std::log10(seconds)) - 1);
  return std::round(seconds / unit) * unit;
}

}  // namespace

void validate(const StudyChoice& choice) {
  for (const auto& solver : choice.solvers) contact::find_solver(solver);
  for (const auto& law : choice.laws) parse_law(law);
  for (const double tolerance : choice.tolerances)
    if (!(tolerance > 0) || !std::isfinite(tolerance))
      throw InputError("--tolerance: found " + std::to_string(tolerance) +
                       "; allowed: a finite number above 0, in m/s");
}

std::vector<double> middle_first(std::vector<double> tolerances) {
  std::sort(tolerances.begin(), tolerances.end(), std::greater<>());
  tolerances.erase(std::unique(tolerances.begin(), tolerances.end()), tolerances.end());
  const auto middle = static_cast<std::ptrdiff_t>(tolerances.size() / 2);
  std::vector<double> out;
  for (std::ptrdiff_t away = 0; out.size() < tolerances.size(); ++away)
    for (const std::ptrdiff_t k : {middle + away, middle - away})
      if (k >= 0 && k < static_cast<std::ptrdiff_t>(tolerances.size()) && (away > 0 || k != middle || out.empty()))
        out.push_back(tolerances[k]);
  return out;
}

StudyRow row_of(const StudyFile& file, const StudyRun& run) {
  StudyRow row;
  row.problem = file.problem;
  row.solver = run.solver;
  row.law = run.law;
  row.tolerance = run.tolerance;
  return row;
}

StudyPlan make_plan(const std::vector<StudyFile>& files, const StudyChoice& choice, double core_seconds, double start_s,
                    const std::function<bool(const StudyRow&)>& done) {
  StudyPlan plan;
  for (const auto& file : files) {
    if (file.fault.empty()) continue;
    StudyRow row = row_of(file, {});
    row.tolerance = k_unknown;
    row.message = file.fault;
    plan.settled.push_back(row);
  }
  std::vector<Block> blocks = all_blocks(files, choice);
  std::size_t count = 0;
  for (auto& block : blocks) {
    Block wanted;
    for (const auto& run : block) {
      StudyRow row = row_of(files[run.file], run);
      row.message = why_not(contact::find_solver(run.solver), parse_law(run.law).law, files[run.file]);
      row.outcome = RunOutcome::not_applicable;
      if (!row.message.empty())
        plan.settled.push_back(row);
      else if (!done || !done(row))
        wanted.push_back(run);
    }
    count += wanted.size();
    block = wanted;
  }
  const double share = core_seconds / static_cast<double>(std::max<std::size_t>(count, 1)) - start_s;
  plan.limit_s =
      choice.limit_s > 0 ? choice.limit_s : with_two_digits(std::clamp(k_shares * share, k_least_limit, k_most_limit));
  bool full = false;
  for (const auto& block : blocks) {
    double estimate = 0, most = 0;
    for (const auto& run : block) {
      const StudyFile& file = files[run.file];
      const double before = start_s + file.reading_s;
      estimate += before + std::min(plan.limit_s, k_per_contact * file.problem.contacts);
      most += before + plan.limit_s;
    }
    full = full || (!plan.runs.empty() && plan.estimate_s + estimate > core_seconds);
    auto& list = full ? plan.dropped : plan.runs;
    list.insert(list.end(), block.begin(), block.end());
    if (full) continue;
    plan.estimate_s += estimate;
    plan.at_most_s += most;
  }
  return plan;
}

}  // namespace nilas::compare
