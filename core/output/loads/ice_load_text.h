#pragma once
/// Ice loads, tow force and loads on structures as text, for the end of a run.
#include <string>

#include "core/output/loads/ice_load.h"

namespace nilas::output {

struct ForceUnit {
  const char* name;
  double size;  ///< [N]
};
/// The unit N, kN or MN that gives a force of this size a readable number.
ForceUnit force_unit(double newton);
/// A force in N, kN or MN with four digits.
std::string force_text(double newton);

/// The words for the two signs of a load's component. Without `negative`, the number keeps its sign.
struct LoadSides {
  const char *positive, *negative = nullptr;
};
inline constexpr LoadSides k_astern{"astern", "forward"}, k_to_port{"to port", "to starboard"}, k_upward{"up", "down"};
/// A force with its side: "7.506 N to starboard".
std::string sided_force(double newton, const LoadSides& sides);

/// The settings on which a raw peak depends, as a whole sentence.
std::string raw_peak_depends_on(const IceLoad& load);

/// Lines of at most 80 columns: mean, window, deviation and peaks; for a towed vessel also the components of the tow
/// force. `error`: the sources of the mean's error.
std::string ice_load_lines(const IceLoad& load, const LoadError& error);
std::string structure_lines(const StructureLoad& structure);

}  // namespace nilas::output
