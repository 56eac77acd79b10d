#pragma once
/// The contacts of the body that a report is about, from contacts.h5.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/math.h"

namespace nilas::report {

/// One entry per contact that carried a force, in the order of the steps.
struct HullContacts {
  std::vector<double> time;                  ///< end of the step [s]
  std::vector<std::int64_t> step, other;     ///< number of the step; id of the floe or other body
  std::vector<Vec3> place;                   ///< in V of a vessel, else in G [m]
  std::vector<Vec3> force, impulse, normal;  ///< on the body and into it, in G [N, N s, -]
  std::vector<bool> crushes;                 ///< whether the ice carried all that it can bear
  std::size_t steps = 0;                     ///< number of whole steps in the file
  double floating_level = 0;  ///< mean height in G of the origin of V over all contacts [m]; 0 for a structure
  double share_crushing = 0;  ///< share of the impulses, by size, in contacts where ice crushes
};

/// Reads the contacts of body `id` that carried a force. Throws FileError or InputError where the file cannot be read
/// or lacks a column.
HullContacts hull_contacts(const std::filesystem::path& file, const std::vector<std::int64_t>& ids, bool is_vessel);

}  // namespace nilas::report
