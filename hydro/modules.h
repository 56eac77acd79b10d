#pragma once
/// The hydrodynamic force modules of a scene. Buoyancy and drag act on every free floe and rigid body and on the
/// vessel; walls and fixed bodies take none.
#include <memory>

#include "core/bodies/module.h"
#include "core/choices/defaults.h"
#include "hydro/water.h"

namespace nilas::hydro {

/// Hydrostatic pressure integrated exactly over the wetted surface: rho g V upwards at the centre of buoyancy. The
/// force is conservative. Its potential is rho g times the integral of (level - z) over the submerged volume. A body
/// whose pose has not changed is not clipped again.
/// `without_vessel`: hull and parts of the vessel take none, since another module has their hydrostatics.
std::unique_ptr<bodies::ForceModule> make_buoyancy(const Water& water, int threads, bool without_vessel = false);

/// Quadratic drag, evaluated at one point per wetted face, the centroid of its wet part. Let n be the outward normal, u
/// the velocity of the undisturbed water at that point, which is the current and the sum of the parts of Water::flows,
/// v_r = u - (v + w x r), and v_t = v_r - (v_r . n) n:
///   form, where the flow meets the face (v_r . n < 0):  dF = -0.5 rho C_f (v_r . n)^2 n dA
///   skin, on every wet face:                            dF =  0.5 rho C_s |v_t| v_t dA
/// A flat plate broadside therefore has the drag coefficient C_f on its area. A faceted sphere has C_f / 2 on its
/// cross-section. Faces are the triangles of a mesh, box, cylinder or faceted sphere, and the whole caps and sides of a
/// floe. One point per face is exact for a body that translates. For a body that turns it leaves out how the velocity
/// varies over the face. A floe that rocks about a horizontal axis through its centre gets form drag on its sides only.
struct DragCoefficients {
  double form = defaults::k_form_drag;      ///< C_f
  double skin = defaults::k_skin_friction;  ///< C_s
};
/// Makes the module of quadratic drag. limit() keeps an explicit step stable for slivers at great speeds: it scales the
/// wrench W of a free body down to W P / (h W . M^-1 W) where that is less than W. P is the power that the drag takes
/// from the motion through the water, summed over the faces. The scaled drag takes at most half of h P, and never gives
/// energy. With `order_free` the bits do not depend on the order of faces, and mirrored bodies take mirrored loads.
/// With `vessel_in_plane_elsewhere`, another module has the vessel's loads in surge, sway and yaw: drag then sees no
/// such motion of the vessel and gives no such load, and only damps its heave, roll and pitch.
std::unique_ptr<bodies::ForceModule> make_drag(const Water& water, const DragCoefficients& coefficients, int threads,
                                               bool order_free = false, bool vessel_in_plane_elsewhere = false);

/// F = coefficient (velocity - v) at the centre of mass of each free floe [N s/m, m/s]: the driving force of the
/// pre-sawn test. Where coefficient h > m, the force of a step of length h [s] would carry a floe past `velocity`.
/// There limit() scales it down so that the floe just reaches that velocity.
std::unique_ptr<bodies::ForceModule> make_virtual_drag(double coefficient, const Vec3& velocity);

}  // namespace nilas::hydro
