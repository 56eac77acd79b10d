#pragma once
/// The force module of a vessel whose lines MoorDyn moves.
#include <memory>
#include <string>

#include "core/bodies/module.h"
#include "core/vessel/mooring/moordyn_library.h"

namespace nilas::vessel {

struct MoordynSettings {
  std::string file;           ///< MoorDyn's input file
  Vec3 com_V = Vec3::Zero();  ///< centre of mass in V: the file's coupled points are places in V [m]
  double level = 0;           ///< height of still water in G; MoorDyn counts heights from it [m]
  int hull = 0;               ///< index of the hull's body
};

/// Makes the module `mooring` by MoorDyn 2. Its coupled points are fairleads, with coordinates in V; fixed points have
/// coordinates in G, with z from still water. At the end of each substep MoorDyn moves the lines while the fairleads go
/// straight from their last places to the present ones. The forces that it returns act over the next substep, at the
/// fairleads. So coupling is explicit. Lines start at rest with the hull at its start. Columns of steps.csv:
/// line_<id>_tension_N, the greatest in the line. `bodies` are those of the start. The state of MoorDyn is part of
/// the checkpoint. Throws as MoordynSystem does.
std::unique_ptr<bodies::ForceModule> make_moordyn_mooring(const MoordynApi& api, const MoordynSettings& settings,
                                                          const bodies::Bodies& bodies);

}  // namespace nilas::vessel
