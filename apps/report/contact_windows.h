#pragma once
/// The contacts of a run around chosen times, from its contacts.h5.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/math.h"
#include "core/scene/scene.h"

namespace nilas {

/// A contact that carried a force in one step.
struct ContactMark {
  Vec3 p = Vec3::Zero();      ///< in the frame of the drawing [m]
  Vec3 side = Vec3::Zero();   ///< points to where it can be seen from, in that frame
  Vec3 force = Vec3::Zero();  ///< on the body, in G [N]
};

struct ContactWindow {
  double t = 0, half_width = 0;    ///< [s]
  long steps = 0;                  ///< in it
  std::vector<ContactMark> marks;  ///< weakest first
  Vec3 mean_force = Vec3::Zero();  ///< on the bodies over its steps, in G [N]
  double floating_level = 0;       ///< of a vessel: mean height of V's origin in G; 0 without contacts [m]
};

/// The bodies whose contacts are drawn: a vessel in its frame V, or structures in G.
struct DrawnBodies {
  std::vector<std::int64_t> ids;
  bool is_vessel = false;
};

/// One window per time, of the contacts of these bodies. Throws FileError, and InputError where the file holds none of
/// such bodies or a window no step.
std::vector<ContactWindow> contact_windows(const std::filesystem::path& file, const DrawnBodies& drawn,
                                           const TimeScene& run, const std::vector<double>& times, double half_width);

}  // namespace nilas
