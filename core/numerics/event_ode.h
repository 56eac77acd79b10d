#pragma once
/// Ordinary differential equations up to an event, by CVODE: Adams' methods of variable order and step.
#include <functional>
#include <memory>
#include <vector>

#include "core/base/math.h"

namespace nilas::numerics {

/// The equation y' = derivative(t, y) with event functions g: an event is a component that falls through zero.
/// Functions may be evaluated beyond the event, so they must continue smoothly there.
struct EventOde {
  std::function<void(double t, const VecX& y, VecX& dy)> derivative;
  int num_events = 0;
  std::function<void(double t, const VecX& y, VecX& g)> events;
};

struct OdeSettings {
  double relative = 1e-12;  ///< local error per step
  VecX absolute;            ///< one tolerance per component
  double longest_step = 0;  ///< [s]; 0: no limit
  long max_steps = 100000;  ///< largest number of steps to the next requested time
};

struct OdeStop {
  double t = 0;             ///< time reached [s]
  std::vector<int> events;  ///< components that fell through zero there; empty at the requested end
};

/// One smooth solution that is followed from time to time; its steps continue across the requested times.
class OdeSolution {
 public:
  /// Starts from y at t0.
  OdeSolution(EventOde ode, const OdeSettings& settings, double t0, const VecX& y);
  ~OdeSolution();
  OdeSolution(OdeSolution&&) noexcept;
  OdeSolution& operator=(OdeSolution&&) noexcept;

  /// Advances to t1, or to the first event before it, which ends the solution. y becomes the state there. Throws
  /// SimulationError when the tolerances cannot be held.
  OdeStop follow(double t1, VecX& y);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas::numerics
