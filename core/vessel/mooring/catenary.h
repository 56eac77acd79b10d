#pragma once
/// Statics of one elastic mooring line between an anchor and a fairlead, in closed form.
#include <optional>

#include "core/base/math.h"

namespace nilas::vessel {

/// A uniform line. Its weight is that in water per unstretched length; a buoyant line has a negative one.
struct CatenaryLine {
  double length = 0;        ///< unstretched length L [m]
  double weight = 0;        ///< w, not zero [N/m]
  double stiffness = 0;     ///< axial stiffness EA [N]
  double bed_friction = 0;  ///< Coulomb coefficient C_B between the line and the sea bed [-]
  double diameter = 0;  ///< of the line; its axis lies half of it above the bed. solve_catenary() does not use it [m]
};

/// Where the ends of a line are, in its vertical plane.
struct CatenarySpan {
  double across = 0;                ///< horizontal distance from anchor to fairlead, >= 0 [m]
  double up = 0;                    ///< height of the fairlead above the anchor, negative below it [m]
  std::optional<double> above_bed;  ///< height of the anchor above a level sea bed, >= 0 [m]; empty: no bed
};

/// Forces at the ends of a line at rest, their stiffness, and where the line lies.
struct CatenaryForces {
  double fairlead_across = 0;  ///< H, the pull on the fairlead towards the anchor [N]
  double fairlead_down = 0;    ///< V, the pull on the fairlead downwards [N]
  double anchor_across = 0;    ///< pull on the anchor towards the fairlead [N]
  double anchor_up = 0;        ///< pull on the anchor upwards [N]
  double on_bed = 0;           ///< unstretched length on the bed, slack included [m]
  bool slack = false;          ///< true: the line hangs straight down, and more of it lies on the bed than need be
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Zero();  ///< d(H, V) / d(across, up) [N/m]

  double fairlead_tension() const { return std::hypot(fairlead_across, fairlead_down); }  ///< [N]
  double anchor_tension() const { return std::hypot(anchor_across, anchor_up); }          ///< [N]
};

/// Solves the elastic catenary (Jonkman, Dynamics Modeling and Loads Analysis of an Offshore Floating Wind Turbine,
/// NREL/TP-500-41958, 2007, eq. 2.36 to 2.39). The unknowns are H and V at the fairlead. Let V_A = V - w L,
/// T = |(H, V)| and T_A = |(H, V_A)|. A line off the bed has
///   across = H/w (asinh(V/H) - asinh(V_A/H)) + H L/EA,  up = (T - T_A)/w + (V L - w L^2/2)/EA.
/// A line whose anchor stands on the bed lies there over L_B = L - V/w, where that is positive:
///   across = L_B + H/w asinh(V/H) + H L/EA - friction,  up = (T - H)/w + V^2/(2 EA w),
///   friction = C_B w/(2 EA) (L_B^2 - max(0, L_B - H/(C_B w))^2), anchor_across = max(0, H - C_B w L_B).
/// A line that sags onto the bed from an anchor above it has two hanging parts of this kind, with the same H and
/// without friction. A line with more length than it needs at H = 0 is slack. A buoyant line is the mirror image of a
/// heavy one; it does not touch the bed.
///
/// For each H, up rises with V, and along the curve of the given height, across rises with H. Both follow from the
/// convex complementary energy of the line. So two nested one-dimensional Newton searches with brackets always
/// converge. They start from the inextensible line, so that the result depends on the arguments only. The relative
/// error of H and V is about 1e-13 times the condition of the line. It costs some microseconds. Throws ContractError
/// for a line or span out of its range, such as a fairlead below the bed.
CatenaryForces solve_catenary(const CatenaryLine& line, const CatenarySpan& span);

/// Greatest strain along the line [-].
double greatest_strain(const CatenaryLine& line, const CatenaryForces& forces);

}  // namespace nilas::vessel
