#pragma once
/// Perturbed runs: runs of one scene whose starts differ by a tiny displacement, and their statistics.
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"

namespace nilas::bench {

struct Mean {
  double value = 0, error = 0;  ///< Mean, and standard error of the mean.
};

/// Mean of value(course) over the courses.
template <class Course, class Value>
Mean mean_of(const std::vector<Course>& courses, const Value& value) {
  Mean mean;
  const auto n = static_cast<double>(courses.size());
  for (const auto& course : courses) mean.value += value(course) / n;
  double squares = 0;
  for (const auto& course : courses) squares += std::pow(value(course) - mean.value, 2);
  if (n > 1) mean.error = std::sqrt(squares / (n - 1) / n);
  return mean;
}

/// Results of run(k) for the unperturbed scene (k = 0) and for its perturbed runs 1 to `twins`, each on a thread of its
/// own.
template <class Run>
auto with_twins(int twins, int threads, const Run& run) {
  std::vector<decltype(run(std::uint64_t{0}))> courses(static_cast<std::size_t>(twins) + 1);
  parallel_for(twins + 1, threads, [&](std::ptrdiff_t k) { courses[k] = run(static_cast<std::uint64_t>(k)); });
  return courses;
}

}  // namespace nilas::bench
