#pragma once
/// The contacts of a run around chosen times, from its contacts.h5.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/math.h"
#include "core/scene/scene.h"

namespace nilas::report {

/// A contact that carried a force in one step.
struct ContactMark {
  Vec3 p = Vec3::Zero();      ///< place in the frame of the drawing [m]
  Vec3 side = Vec3::Zero();   ///< direction from which it can be seen, in that frame
  Vec3 force = Vec3::Zero();  ///< force on the body, in G [N]
};

struct ContactWindow {
  double t = 0, half_width = 0;    ///< middle and half the length of the window [s]
  long steps = 0;                  ///< number of steps in the window
  std::vector<ContactMark> marks;  ///< sorted by force, the weakest first
  Vec3 mean_force = Vec3::Zero();  ///< force on the bodies, averaged over the steps, in G [N]
  double floating_level = 0;       ///< mean height in G of the origin of a vessel's frame V [m]; 0 without contacts
};

/// The bodies whose contacts are drawn: a vessel in its frame V, or structures in G.
struct DrawnBodies {
  std::vector<std::int64_t> ids;
  bool is_vessel = false;
};

/// Reads the contacts of these bodies, one window per time [s]. Throws FileError. Throws InputError if the file holds
/// no contacts of such bodies, or if no step lies in a window.
std::vector<ContactWindow> contact_windows(const std::filesystem::path& file, const DrawnBodies& drawn,
                                           const scene::TimeScene& run, const std::vector<double>& times,
                                           double half_width);

}  // namespace nilas::report
