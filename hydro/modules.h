#pragma once
/// The hydrodynamic force modules of a scene. Buoyancy and drag act on every free floe and rigid body and on the
/// vessel; walls and fixed bodies take none.
#include <memory>

#include "core/bodies/module.h"
#include "core/choices/defaults.h"
#include "hydro/water.h"

namespace nilas {

/// Hydrostatic pressure integrated exactly over the wetted surface: rho g V upwards at the centre of buoyancy.
/// Conservative; the potential is rho g times the integral of (level - z) over the submerged volume. Poses already seen
/// are not clipped again.
std::unique_ptr<ForceModule> make_buoyancy(const Water& water, int threads);

/// Quadratic drag, one point per wetted face. With v_r = current - (v + w x r) at the centroid of the face's wet part,
/// n its outward normal and v_t = v_r - (v_r . n) n:
///   form, where the flow meets the face (v_r . n < 0):  dF = -0.5 rho C_f (v_r . n)^2 n dA
///   skin, on every wet face:                            dF =  0.5 rho C_s |v_t| v_t dA
/// A flat plate broadside so has the drag coefficient C_f on its area; a faceted sphere C_f / 2 on its cross-section.
/// Faces are the triangles of a mesh, box, cylinder or faceted sphere, and caps and sides of a floe as whole polygons.
/// One point per face is exact for a body that translates. For one that turns it leaves out the velocity's variation
/// over the face: a floe that rocks about a horizontal axis through its centre gets no form drag on its caps, only on
/// its sides.
struct DragCoefficients {
  double form = defaults::k_form_drag;      ///< C_f
  double skin = defaults::k_skin_friction;  ///< C_s
};
/// For slivers at great speeds a quadratic force is too much for an explicit step: limit() scales the wrench W of a
/// free body down to W P / (h W . M^-1 W) where that is less than W, P being the power that it takes from the motion
/// through the water. It then takes at most half of h P, and never gives. `order_free`: the bits do not depend on the
/// order of faces, and mirrored bodies take mirrored loads.
std::unique_ptr<ForceModule> make_drag(const Water& water, const DragCoefficients& coefficients, int threads,
                                       bool order_free = false);

/// F = coefficient (velocity - v) at the centre of mass of each free floe [N s/m, m/s]: the driving force of the
/// pre-sawn test. Where that were more than brings the floe to that velocity in a step of length h, c h > m, limit()
/// leaves what does.
std::unique_ptr<ForceModule> make_virtual_drag(double coefficient, const Vec3& velocity);

}  // namespace nilas
