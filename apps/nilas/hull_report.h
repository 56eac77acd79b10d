#pragma once
/// What `nilas hull` says about a hull.
#include <nlohmann/json.hpp>
#include <optional>

#include "core/mesh/decompose.h"
#include "core/mesh/mend.h"
#include "core/vessel/hull.h"

namespace nilas {

/// A hull with how it came about.
struct PreparedHull {
  Hull hull;
  std::vector<MeshNote> mended;
  Deviation deviation;              ///< of the parts from the mesh
  std::vector<PartCount> table;     ///< empty where nothing was decomposed
  std::optional<double> tolerance;  ///< that was asked of the parts, where a mesh was decomposed [m]
};

/// z of the waterline in frame V. Throws InputError unless the draught lies between keel and deck.
double waterline_level(const TriangleMesh& mesh, double draught);

/// Why the parts stand further off than they should, and what helps; empty where they do not. `most` parts are allowed.
std::string missed_tolerance(const PreparedHull& prepared, std::size_t most);

/// The keys of the report: volume, centre, hydrostatics at the draught, symmetry, what was mended, parts.
nlohmann::ordered_json hull_report(const PreparedHull& prepared, double draught);

/// The same for readers; places at most three of each kind.
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace nilas
