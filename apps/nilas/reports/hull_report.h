#pragma once
/// The report of `nilas hull` on a hull.
#include <nlohmann/json.hpp>
#include <optional>

#include "core/hull/hull.h"
#include "core/hull/hull_doubts.h"
#include "core/mesh/decompose/decompose.h"
#include "core/mesh/mend/mend.h"

namespace nilas::commands {

/// A hull and how it was made.
struct PreparedHull {
  hull::Hull hull;
  std::vector<mesh::MeshNote> mended;
  std::optional<mesh::Deviation>
      deviation;                       ///< deviation of the convex parts from the mesh; none if the mesh is the part
  std::vector<mesh::PartCount> table;  ///< empty if nothing was decomposed
  std::optional<double> tolerance;     ///< tolerance asked of the parts, if a mesh was decomposed [m]
  double draught = 0;                  ///< draught of the waterline that the report takes [m]
  hull::HullUse use;                   ///< origin of the hull, for advice
};

/// The height z of the waterline in frame V [m]. Throws InputError unless the draught lies between a thousandth of the
/// height, below which rounding would show in GM, and the height.
double waterline_level(const geometry::TriangleMesh& mesh, double draught);

/// Why the convex parts deviate by more than the tolerance, and what helps; empty if they do not. `most`: the number of
/// parts that is allowed.
std::string missed_tolerance(const PreparedHull& prepared, std::size_t most);

/// The report as JSON: size, volume, centre, hydrostatics, bow, symmetry, what was mended, convex parts, doubts. The
/// keys are in docs/reference/outputs.md. GM is that of a uniform solid.
nlohmann::ordered_json hull_report(const PreparedHull& prepared);

/// The report as text, without the warnings and with at most three places of each kind.
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace nilas::commands
