#pragma once
/// Ranks the settings of a comparison by error and time.
#include "apps/compare/scenes/judge/findings.h"
#include "apps/compare/scenes/plan/plan.h"

namespace nilas::compare {

/// The least number of steps whose errors show an order.
constexpr std::size_t k_least_order_steps = 3;

/// Sets Merit::dominated if another setting is no slower and no worse, and better in one of both. Errors below the
/// floor count as equal. A setting that is not complete is dominated.
std::vector<Merit> with_dominance(std::vector<Merit> merits);

/// The ratio of two computing times above which one setting is significantly faster: three standard deviations of a
/// ratio of times. `time_spread`: relative standard deviation of times; NaN: not known, 0.1 is then taken.
double significant_speed_ratio(double time_spread);

/// Sets Merit::faulty_part: a setting that has only some of this one's changes from the first setting, and whose error
/// is significant and exceeds that of the first setting by more than the target. A small error of both changes together
/// may then be two errors that cancel.
std::vector<Merit> with_faulty_parts(const Plan& plan, const Measure& measure, std::vector<Merit> merits);

/// Chooses the fastest setting that is accurate enough and has no faulty part. Among settings whose times do not differ
/// significantly it is the most accurate one, or the scene's own setting if that is among them.
Choice choose(const std::vector<Merit>& merits, const Measure& measure, double common_floor, double time_spread);

/// The orders p of errors C h^p, for settings that differ only in the step and have at least k_least_order_steps
/// significant errors. If the reference has the same integrator and a step r itself, errors are C (h^p - r^p).
std::vector<Order> orders_of(const Plan& plan, const Findings& found);

/// Whether the error of any setting is known.
bool anything_compared(const std::vector<Merit>& merits);

}  // namespace nilas::compare
