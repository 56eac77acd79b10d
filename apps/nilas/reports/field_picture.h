#pragma once
/// A picture of the ice of a scene from above and of the distribution of its floe sizes.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/nilas/reports/field_report.h"
#include "core/sim/world/world.h"

namespace nilas::commands {

constexpr int k_picture_width = 1600;  ///< [pixels]
/// The height at which the ice fits at equal scale in x and y, and a histogram per report [pixels].
int picture_height(const std::vector<sim::PlannedIce>& ice, const std::vector<FieldReport>& reports);

/// Draws a PNG with gnuplot. The map has axes in metres and shows the floes, coloured by thickness if it varies, the
/// hull's outline, the keep-out around it, and the regions. Histograms next to it show the sizes obtained and those
/// asked for. Throws FileError.
void draw_field(const std::filesystem::path& file, const std::string& title, const std::vector<sim::PlannedIce>& ice,
                const std::vector<FieldReport>& reports);

}  // namespace nilas::commands
