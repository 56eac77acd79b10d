#pragma once
/// What a viewer asks of a run: to pause, to go on by one frame, to go slowly.
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>

namespace nilas::view {

class LiveControl {
 public:
  /// Takes a request as the page sends it: {"action": "pause" | "resume" | "step" | "slow", "factor": x}. `slow` keeps
  /// the run at x times real time, or lets it go freely at 0. Throws InputError for anything else, and changes nothing
  /// then.
  void request(const std::string& json);

  /// Called by the run before a step at simulated time t [s]: returns when it may take the step. Returns at once when
  /// `stopped` is true.
  void hold(double t, const std::function<bool()>& stopped);
  /// Called by the run when it has written a frame, which ends a step of the viewer.
  void frame_written();

  /// The state as pages show it, {"paused": false, "factor": 1}, with a count that changes whenever the state does. A
  /// factor of 0 means that the run goes freely.
  struct State {
    std::string json;
    int count = 0;
  };
  State state() const;

 private:
  double ahead(double t);

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false, stepping_ = false;
  double factor_ = 0;                     ///< of real time, 0: free
  double pace_wall_ = 0, pace_time_ = 0;  ///< wall clock and simulated time at which the pace began [s]
  bool pace_begins_ = false;
  int count_ = 0;
};

}  // namespace nilas::view
