#pragma once
/// Ordinary differential equations up to an event, by CVODE: Adams' methods of variable order and step.
#include <functional>
#include <memory>
#include <vector>

#include "core/base/math.h"

namespace nilas {

/// y' = derivative(t, y), watched by event functions g: an event is a component that falls through zero. Functions may
/// be asked beyond the event that is found, so they must go on smoothly there.
struct EventOde {
  std::function<void(double t, const VecX& y, VecX& dy)> derivative;
  int num_events = 0;
  std::function<void(double t, const VecX& y, VecX& g)> events;
};

struct OdeSettings {
  double relative = 1e-12;  ///< local error per step
  VecX absolute;            ///< per component
  double longest_step = 0;  ///< [s]; 0: no limit
  long max_steps = 100000;  ///< to the next time asked for
};

struct OdeStop {
  double t = 0;             ///< reached [s]
  std::vector<int> events;  ///< that fell through zero there; empty at the end asked for
};

/// One smooth solution, followed from time to time: its steps go on across the times asked for.
class OdeSolution {
 public:
  /// From y at t0.
  OdeSolution(EventOde ode, const OdeSettings& settings, double t0, const VecX& y);
  ~OdeSolution();
  OdeSolution(OdeSolution&&) noexcept;
  OdeSolution& operator=(OdeSolution&&) noexcept;

  /// To t1, or to the first event before it, after which the solution has ended; y becomes the state there. Throws
  /// SimulationError when the tolerances cannot be held.
  OdeStop follow(double t1, VecX& y);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nilas
