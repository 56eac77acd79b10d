#pragma once
/// The contact forces of one step as a ParaView PolyData document: points with vectors, for arrows.
#include <string>
#include <vector>

#include "core/output/tables/contact_rows.h"

namespace nilas::output {

/// A document with a point per contact that carries a force. `h`: step [s]. Arrays: docs/reference/outputs.md.
std::string contact_forces_document(const std::vector<ContactRow>& rows, double h);

}  // namespace nilas::output
