#pragma once
/// How far Simbody's joint reactions and the balance of momenta are apart over a run.
#include <string>
#include <vector>

#include "core/base/state.h"
#include "core/sim/account/step_record.h"

namespace nilas {

/// The joint of the carriage, or of a part.
struct JointBalance {
  std::string name;                              ///< of the part; empty: the carriage
  double force = 0, torque = 0;                  ///< largest differences in any step [N, N m]
  double force_time = 0, torque_time = 0;        ///< when [s]
  double largest_force = 0, largest_torque = 0;  ///< that the joint carried in any step [N, N m]
};

class ReactionBalance {
 public:
  /// Above this share of the largest load a run says so, unless the difference is below a millionth of the vessel's
  /// weight.
  static constexpr double k_limit = 1e-3;

  /// `info`: of a run with a vessel, or not.
  explicit ReactionBalance(const RunInfo& info);
  /// Steps that know only one of both loads count for nothing.
  void add(const StepRecord& record);

  /// The carriage first, then the parts; joints of which no step knew both loads are left out.
  std::vector<JointBalance> joints() const;
  /// Largest difference over the largest load, a torque counted as a force at the vessel's length.
  double relative(const JointBalance& joint) const;
  /// One sentence about the joint that is farthest beyond the limit, or nothing.
  std::string doubt() const;

  void save(StateWriter out) const;
  /// Throws InputError when the state is one of a run with other joints.
  void restore(const StateReader& in);

 private:
  struct Seen {
    JointBalance joint;
    bool any = false;
  };
  double apart(const JointBalance& joint) const;
  static void note(Seen& seen, double t, double force, double torque, const Wrench& load);

  std::vector<Seen> seen_;  ///< of the carriage, if there is one, and the parts
  bool has_carriage_ = false;
  double length_ = 1;      ///< of the vessel [m]
  double negligible_ = 0;  ///< difference [N]
};

/// Lines of the closing account, at most 80 columns; nothing without joints.
std::string reaction_lines(const ReactionBalance& balance);

}  // namespace nilas
