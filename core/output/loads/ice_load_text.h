#pragma once
/// Ice loads, tow force and loads on structures as a run tells them at its end.
#include <string>

#include "core/output/loads/ice_load.h"

namespace nilas {

struct ForceUnit {
  const char* name;
  double size;  ///< [N]
};
/// N, kN or MN: that in which a force of this size has a readable number.
ForceUnit force_unit(double newton);
/// A force in N, kN or MN with four digits.
std::string force_text(double newton);

/// What a raw peak depends on, as a whole sentence.
std::string raw_peak_depends_on(const IceLoad& load);

/// Lines of at most 80 columns: mean, window, deviation and peaks, of a towed vessel what takes the tow force. `error`:
/// the parts of the mean's error.
std::string ice_load_lines(const IceLoad& load, const LoadError& error);
std::string structure_lines(const StructureLoad& structure);

}  // namespace nilas
