#pragma once
/// The ice of a scene from above, and how the sizes of its floes are distributed.
#include <filesystem>
#include <string>
#include <vector>

#include "apps/nilas/reports/field_report.h"
#include "core/sim/world/world.h"

namespace nilas {

constexpr int k_picture_width = 1600;  ///< [pixels]
/// Height that leaves room for the ice at equal scale in x and y, and for a histogram per report [pixels].
int picture_height(const std::vector<PlannedIce>& ice, const std::vector<FieldReport>& reports);

/// Draws a PNG by gnuplot: floes coloured by thickness where it varies, the hull's outline and what is kept clear
/// around it, the regions, axes in metres; beside it histograms of the sizes obtained, with what was asked. Throws
/// FileError.
void draw_field(const std::filesystem::path& file, const std::string& title, const std::vector<PlannedIce>& ice,
                const std::vector<FieldReport>& reports);

}  // namespace nilas
