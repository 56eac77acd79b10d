#pragma once
/// Where a run's floes lay, for drawings.
#include <filesystem>
#include <vector>

#include "core/bodies/bodies.h"

namespace nilas {

/// Upper outlines of the floes in frame V at the stored instant nearest to t [s], from a bodies.csv of these bodies;
/// `com_V` is the vessel's centre of mass in V. Empty where the file is not there. Throws InputError for rows of other
/// bodies.
std::vector<std::vector<Vec3>> floe_outlines(const std::filesystem::path& bodies_csv, const Bodies& bodies, int vessel,
                                             const Vec3& com_V, double t);

}  // namespace nilas
