#pragma once
/// What adds forces to bodies outside contact: buoyancy, drag, thrusters, mooring.
#include <string>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas {

/// One wrench per body, about its centre of mass, in G.
using Wrenches = std::vector<Wrench>;

/// A force that the scene named. Simulation holds the list of those, nothing else.
class ForceModule {
 public:
  virtual ~ForceModule() = default;
  virtual std::string name() const = 0;  ///< as in the ledger column work_<name>_J and in summary.json
  /// True when the forces derive from potential_energy(); such a module has no work column.
  virtual bool conservative() const { return false; }
  /// Adds this module's wrenches at time t [s] for the present poses and velocities. `out` has one entry per body.
  virtual void add_forces(const Bodies& bodies, double t, Wrenches& out) = 0;
  /// Leaves of its own wrenches (`out` holds no others) what an explicit step of length h [s] bears. By default all.
  virtual void limit(const Bodies& /*bodies*/, double /*h*/, Wrenches& /*out*/) const {}
  /// Potential energy of the present poses [J]; zero for a module that is not conservative.
  virtual double potential_energy(const Bodies& /*bodies*/) { return 0; }
};

}  // namespace nilas
