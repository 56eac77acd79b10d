#include "core/output/text/slowdown.h"

#include <fmt/format.h>

#include <numeric>

namespace nilas::output {

namespace {

constexpr double k_told_from = 1.5;                  // ratio of step times
constexpr double k_waits = 1.25;                     // wall time over processor time
constexpr std::size_t k_quarters = 4, k_least = 20;  // least number of steps in a quarter
constexpr double k_shortest_told_ms = 2000;          // time of all steps

/// Means over the first and the last quarter of a series from `first` on.
struct Ends {
  double early = 0, late = 0;
  double ratio() const { return early > 0 ? late / early : 0; }
};

Ends ends(const std::vector<double>& series, std::size_t first) {
  const std::size_t length = (series.size() - first) / k_quarters;
  const auto mean = [&](std::size_t from) {
    const auto begin = series.begin() + static_cast<std::ptrdiff_t>(from);
    return std::accumulate(begin, begin + static_cast<std::ptrdiff_t>(length), 0.0) / static_cast<double>(length);
  };
  return {mean(first), mean(series.size() - length)};
}

}  // namespace

void StepCosts::add(const sim::StepRecord& record, double processor_ms) {
  ms_.push_back(std::accumulate(record.ms.begin(), record.ms.end(), 0.0));
  processor_ms_.push_back(processor_ms);
  solver_ms_.push_back(record.ms[static_cast<std::size_t>(sim::Phase::solver)]);
  fracture_ms_.push_back(record.ms[static_cast<std::size_t>(sim::Phase::fracture)]);
  contacts_.push_back(record.contacts);
  iterations_.push_back(record.iterations);
}

std::string StepCosts::slowdown(std::size_t first) const {
  if (first + k_quarters * k_least > ms_.size()) return "";
  const Ends ms = ends(ms_, first), processor = ends(processor_ms_, first);
  if (std::accumulate(ms_.begin(), ms_.end(), 0.0) < k_shortest_told_ms || ms.ratio() < k_told_from) return "";
  std::string text = fmt::format(
      "Steps of the last quarter took {:.3g} times as long as those of the first: {:.0f} ms instead of {:.0f} ms, with "
      "{:.0f} ms of processor time instead of {:.0f} ms.",
      ms.ratio(), ms.late, ms.early, processor.late, processor.early);
  // On a free machine at least one thread computes at any time, whatever their number.
  const bool waited = ms.late > k_waits * processor.late;
  if (waited) text += " The machine was busy with other work, or its disk was slow.";
  return waited && processor.ratio() < k_told_from ? text : text + " " + causes(first);
}

std::string StepCosts::causes(std::size_t first) const {
  const Ends ms = ends(ms_, first), solver = ends(solver_ms_, first), fracture = ends(fracture_ms_, first);
  const Ends contacts = ends(contacts_, first), iterations = ends(iterations_, first);
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
  out.add("ms", ms_);
  out.add("processor_ms", processor_ms_);
  out.add("solver_ms", solver_ms_);
  out.add("fracture_ms", fracture_ms_);
  out.add("contacts", contacts_);
  out.add("iterations", iterations_);
}

void StepCosts::restore(const StateReader& in, std::size_t steps) {
  in.get("ms", ms_, steps);
  in.get("processor_ms", processor_ms_, steps);
  in.get("solver_ms", solver_ms_, steps);
  in.get("fracture_ms", fracture_ms_, steps);
  in.get("contacts", contacts_, steps);
  in.get("iterations", iterations_, steps);
}

}  // namespace nilas::output
