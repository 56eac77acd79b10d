#include "core/output/text/slowdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace nilas::output {

namespace {

constexpr double k_told_from = 1.5;                  // ratio of step times
constexpr double k_waits = 1.25;                     // wall time over processor time
constexpr std::size_t k_quarters = 4, k_least = 20;  // least number of steps in a quarter
constexpr std::size_t k_most = 1024;                 // stretches
constexpr double k_shortest_told_ms = 2000;          // time of all steps

}  // namespace

void StepCosts::add(const sim::StepRecord& record, double processor_ms) {
  if (steps_ == length_ * stretches_.size()) {
    if (stretches_.size() == k_most) {
      for (std::size_t k = 0; k < k_most / 2; ++k)
        for (std::size_t c = 0; c < k_costs; ++c) stretches_[k][c] = stretches_[2 * k][c] + stretches_[2 * k + 1][c];
      stretches_.resize(k_most / 2);
      length_ *= 2;
    }
    stretches_.emplace_back();
  }
  ++steps_;
  Sums& sums = stretches_.back();
  sums[k_ms] += std::accumulate(record.ms.begin(), record.ms.end(), 0.0);
  sums[k_processor_ms] += processor_ms;
  sums[k_solver_ms] += record.ms[static_cast<std::size_t>(sim::Phase::solver)];
  sums[k_fracture_ms] += record.ms[static_cast<std::size_t>(sim::Phase::fracture)];
  sums[k_contacts] += record.contacts;
  sums[k_iterations] += record.iterations;
}

StepCosts::Ends StepCosts::ends(Cost cost, std::size_t first) const {
  const std::size_t count = (stretches_.size() - first) / k_quarters;
  const auto mean = [&](std::size_t from) {
    double sum = 0;
    for (std::size_t k = from; k < from + count; ++k) sum += stretches_[k][cost];
    return sum / static_cast<double>(std::min(length_ * (from + count), steps_) - length_ * from);
  };
  return {mean(first), mean(stretches_.size() - count)};
}

std::string StepCosts::slowdown(std::size_t first) const {
  const std::size_t from = first / length_;
  if (first + k_quarters * k_least > steps_ || from + k_quarters > stretches_.size()) return "";
  const Ends ms = ends(k_ms, from), processor = ends(k_processor_ms, from);
  double all_ms = 0;
  for (const Sums& sums : stretches_) all_ms += sums[k_ms];
  if (all_ms < k_shortest_told_ms || ms.ratio() < k_told_from) return "";
  std::string text = fmt::format(
      "Steps of the last quarter took {:.3g} times as long as those of the first: {:.0f} ms instead of {:.0f} ms, with "
      "{:.0f} ms of processor time instead of {:.0f} ms.",
      ms.ratio(), ms.late, ms.early, processor.late, processor.early);
  // On a free machine at least one thread computes at any time, whatever their number.
  const bool waited = ms.late > k_waits * processor.late;
  if (waited) text += " The machine was busy with other work, or its disk was slow.";
  return waited && processor.ratio() < k_told_from ? text : text + " " + causes(from);
}

std::string StepCosts::causes(std::size_t first) const {
  const Ends ms = ends(k_ms, first), solver = ends(k_solver_ms, first), fracture = ends(k_fracture_ms, first);
  const Ends contacts = ends(k_contacts, first), iterations = ends(k_iterations, first);
  constexpr double k_percent = 100;
  const double added = ms.late - ms.early;
  std::string text = fmt::format(
      "The solver took {:.0f} % of the time added{}. ", k_percent * (solver.late - solver.early) / added,
      fracture.late > 0
          ? fmt::format(", crushing and breaking {:.0f} %", k_percent * (fracture.late - fracture.early) / added)
          : "");
  text += fmt::format("There were {:.0f} contacts per step instead of {:.0f}, and {:.0f} iterations instead of {:.0f}.",
                      contacts.late, contacts.early, iterations.late, iterations.early);
  return text;
}

void StepCosts::save(StateWriter out) const {
  out.add("stretches", stretches_);
  out.add("length", length_);
  out.add("steps", steps_);
}

void StepCosts::restore(const StateReader& in) {
  in.get("stretches", stretches_);
  in.get("length", length_);
  in.get("steps", steps_);
}

}  // namespace nilas::output
