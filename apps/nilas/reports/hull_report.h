#pragma once
/// What `nilas hull` says about a hull.
#include <nlohmann/json.hpp>
#include <optional>

#include "core/hull/hull.h"
#include "core/hull/hull_doubts.h"
#include "core/mesh/decompose/decompose.h"
#include "core/mesh/mend/mend.h"

namespace nilas {

/// A hull with how it came about.
struct PreparedHull {
  Hull hull;
  std::vector<MeshNote> mended;
  std::optional<Deviation> deviation;  ///< of the parts from the mesh; none where the mesh itself is the part
  std::vector<PartCount> table;        ///< empty where nothing was decomposed
  std::optional<double> tolerance;     ///< that was asked of the parts, where a mesh was decomposed [m]
  double draught = 0;                  ///< of the waterline that the report takes [m]
  HullUse use;                         ///< where it comes from, for advice
};

/// z of the waterline in frame V. Throws InputError unless the draught lies between a thousandth of the height, below
/// which rounding would show in GM, and the height.
double waterline_level(const TriangleMesh& mesh, double draught);

/// Why the parts stand further off than they should, and what helps; empty where they do not. `most` parts are allowed.
std::string missed_tolerance(const PreparedHull& prepared, std::size_t most);

/// The keys of the report: size, volume, centre, hydrostatics, bow, symmetry, what was mended, parts, doubts;
/// docs/reference/outputs.md has them. GM takes the centre of a uniform solid.
nlohmann::ordered_json hull_report(const PreparedHull& prepared);

/// The same for readers, but for the warnings; places at most three of each kind.
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace nilas
