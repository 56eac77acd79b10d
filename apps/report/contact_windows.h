#pragma once
/// The hull contacts of a run around chosen times, from its contacts.h5.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/math.h"
#include "core/scene/scene.h"

namespace nilas {

/// A contact that carried a force in one step.
struct ContactMark {
  Vec3 p_V = Vec3::Zero();    ///< [m]
  Vec3 force = Vec3::Zero();  ///< on the vessel, in G [N]
};

struct ContactWindow {
  double t = 0, half_width = 0;    ///< [s]
  long steps = 0;                  ///< in it
  std::vector<ContactMark> marks;  ///< weakest first
  Vec3 mean_force = Vec3::Zero();  ///< on the vessel over its steps, in G [N]
  double floating_level = 0;       ///< mean height of V's origin in G; 0 without contacts [m]
};

/// One window per time, of the contacts of the body with this id. Throws FileError, and InputError where the file holds
/// no contacts of a hull or a window no step.
std::vector<ContactWindow> contact_windows(const std::filesystem::path& file, std::int64_t vessel_id,
                                           const TimeScene& run, const std::vector<double>& times, double half_width);

}  // namespace nilas
