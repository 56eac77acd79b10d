#pragma once
/// The difference between Simbody's joint reactions and the balance of momenta over a run.
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas::output {

/// The joint of the carriage, or of a part.
struct JointBalance {
  std::string name;                              ///< name of the part; empty: the carriage
  double force = 0, torque = 0;                  ///< largest differences in any step [N, N m]
  double force_time = 0, torque_time = 0;        ///< times of these [s]
  double largest_force = 0, largest_torque = 0;  ///< largest loads of the joint in any step [N, N m]
};

class ReactionBalance {
 public:
  /// Share of the largest load above which a run warns, unless the difference is below a millionth of the vessel's
  /// weight.
  static constexpr double k_limit = 1e-3;

  /// Prepares the balance of a run. `info` may be that of a run without a vessel.
  explicit ReactionBalance(const sim::RunInfo& info);
  /// Adds a step. Joints for which only one of both loads is known are ignored.
  void add(const sim::StepRecord& record);

  /// The carriage first, then the parts. Joints for which no step knew both loads are left out.
  std::vector<JointBalance> joints() const;
  /// Largest difference over the largest load, with torques converted to forces at the vessel's length.
  double relative(const JointBalance& joint) const;
  /// One sentence about the joint with the largest relative difference beyond the limit; else empty.
  std::string doubt() const;

  void save(StateWriter out) const;
  /// Restores a state. Throws InputError when it belongs to a run with other joints.
  void restore(const StateReader& in);

 private:
  struct Seen {
    JointBalance joint;
    bool any = false;
  };
  double apart(const JointBalance& joint) const;
  static void note(Seen& seen, double t, double force, double torque, const Wrench& load);

  std::vector<Seen> seen_;  ///< one entry for the carriage, if there is one, and one per part
  bool has_carriage_ = false;
  double length_ = 1;      ///< length of the vessel [m]
  double negligible_ = 0;  ///< largest difference that is ignored [N]
};

/// Lines of the closing account, at most 80 columns; empty without joints.
std::string reaction_lines(const ReactionBalance& balance);

}  // namespace nilas::output
