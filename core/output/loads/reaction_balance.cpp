#include "core/output/loads/reaction_balance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/output/text/console.h"

namespace nilas::output {

namespace {

constexpr double k_negligible = 1e-6, k_standard_gravity = 9.80665;

/// Keeps the largest value and its time; a NaN counts as largest.
void keep_largest(double value, double t, double& largest, double& time) {
  if (std::isnan(largest) || value <= largest) return;
  largest = value;
  time = t;
}

std::string told(const JointBalance& joint) {
  return joint.name.empty() ? "the carriage" : "part '" + joint.name + "'";
}

}  // namespace

ReactionBalance::ReactionBalance(const sim::RunInfo& info)
    : has_carriage_(info.has_carriage), negligible_(k_negligible * k_standard_gravity * info.vessel_mass.mass) {
  if (info.vessel_length > 0) length_ = info.vessel_length;
  if (has_carriage_) seen_.emplace_back();
  for (const sim::PartInfo& part : info.parts) seen_.emplace_back().joint.name = part.name;
}

void ReactionBalance::note(Seen& seen, double t, double force, double torque, const Wrench& load) {
  JointBalance& joint = seen.joint;
  seen.any = true;
  keep_largest(force, t, joint.force, joint.force_time);
  keep_largest(torque, t, joint.torque, joint.torque_time);
  joint.largest_force = std::max(joint.largest_force, load.force.norm());
  joint.largest_torque = std::max(joint.largest_torque, load.torque.norm());
}

void ReactionBalance::add(const sim::StepRecord& record) {
  if (!record.vessel) return;
  const sim::VesselRecord& vessel = *record.vessel;
  if (has_carriage_ && vessel.carriage && vessel.carriage->disagreement) {
    const Wrench& apart = *vessel.carriage->disagreement;
    note(seen_.front(), record.t, apart.force.norm(), apart.torque.norm(), vessel.carriage->about_com);
  }
  const std::size_t first = has_carriage_ ? 1 : 0;
  for (std::size_t k = 0; k < vessel.parts.size(); ++k) {
    const sim::PartRecord& part = vessel.parts[k];
    note(seen_[first + k], record.t, part.unbalanced_force, part.unbalanced_torque, part.joint);
  }
}

std::vector<JointBalance> ReactionBalance::joints() const {
  std::vector<JointBalance> joints;
  for (const Seen& seen : seen_)
    if (seen.any) joints.push_back(seen.joint);
  return joints;
}

/// Largest difference, with a torque converted to a force at the vessel's length [N].
double ReactionBalance::apart(const JointBalance& joint) const { return std::max(joint.force, joint.torque / length_); }

double ReactionBalance::relative(const JointBalance& joint) const {
  const double load = std::max(joint.largest_force, joint.largest_torque / length_);
  return apart(joint) == 0 ? 0 : apart(joint) / load;
}

std::string ReactionBalance::doubt() const {
  const std::vector<JointBalance> all = joints();
  const auto worst =
      std::max_element(all.begin(), all.end(), [&](const auto& a, const auto& b) { return relative(a) < relative(b); });
  if (worst == all.end() || relative(*worst) <= k_limit || apart(*worst) <= negligible_) return {};
  return fmt::format(
      "The vessel turns or swings too fast for the time step: the load in the joint of {} is uncertain by {:.1g} of "
      "its largest value.",
      told(*worst), relative(*worst));
}

void ReactionBalance::save(StateWriter out) const {
  std::vector<double> values;
  for (const auto& [joint, any] : seen_)
    values.insert(values.end(), {joint.force, joint.torque, joint.force_time, joint.torque_time, joint.largest_force,
                                 joint.largest_torque, any ? 1.0 : 0.0});
  out.add("joints", values);
}

void ReactionBalance::restore(const StateReader& in) {
  constexpr std::size_t k_values = 7;
  std::vector<double> values;
  in.get("joints", values, k_values * seen_.size());
  const double* next = values.data();
  for (auto& [joint, any] : seen_) {
    for (double* value : {&joint.force, &joint.torque, &joint.force_time, &joint.torque_time, &joint.largest_force,
                          &joint.largest_torque})
      *value = *next++;
    any = *next++ != 0;
  }
}

std::string reaction_lines(const ReactionBalance& balance) {
  std::string text;
  const auto line = [&](const char* label, const std::string& told) { text += account_line(label, told); };
  double worst = 0;
  std::string of;
  for (const JointBalance& joint : balance.joints()) {
    const double relative = balance.relative(joint);
    if (joint.name.empty()) {
      line("carriage's reaction", fmt::format("Simbody and the momenta differ by {:.2g} N, {:.2g} N m: {:.2g} of the "
                                              "largest load",
                                              joint.force, joint.torque, relative));
    } else if (of.empty() || relative > worst) {
      worst = relative;
      of = joint.name;
    }
  }
  if (!of.empty())
    line("loads in joints", fmt::format("Simbody and the momenta differ by at most {:.2g} of the largest load, in "
                                        "part '{}'",
                                        worst, of));
  if (const std::string doubt = balance.doubt(); !doubt.empty()) line("joint loads doubtful", doubt);
  return text;
}

}  // namespace nilas::output
