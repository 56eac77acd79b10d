#pragma once
/// Default values that a scene and the modules share, each at its one place. Defaults that only a scene has stand in
/// core/scene/elements.
#include "core/base/math.h"

namespace nilas::defaults {

// time and forces
constexpr double k_gravity = 9.81;         ///< [m/s^2]
constexpr double k_water_density = 1025;   ///< [kg/m^3]
constexpr double k_form_drag = 1.0;        ///< coefficient on faces that meet the flow
constexpr double k_skin_friction = 0.005;  ///< coefficient on every wet face

// contact solvers
constexpr double k_tolerance = 1e-6;  ///< tolerance on law_map_m_s [m/s]
constexpr int k_max_iterations = 1000;

// floes of a packed field, as in a model basin
constexpr double k_concentration = 0.8;
constexpr double k_overlap_tolerance = 1e-3;  ///< share of the mean floe size
constexpr double k_floe_mean = 0.8, k_floe_sd = 0.3, k_floe_min = 0.3, k_floe_max = 1.6;  ///< values of sqrt(area) [m]
constexpr double k_size_exponent = 1.5;                                                   ///< a in n(D) ~ D^-(1 + a)
constexpr int k_vertices_min = 5, k_vertices_max = 9;
constexpr double k_aspect = 1.5;

// breaking
constexpr double k_wedge_angle_deg = 45;
constexpr double k_split_multiplier = 2.5;   ///< longest chord that splits by geometry, in breaking lengths
constexpr double k_max_aspect = 8;           ///< limit for a piece that geometric splitting leaves
constexpr double k_segment_thicknesses = 2;  ///< longest segment of a curved crack

// generated hulls, at a length of k_hull_length
constexpr double k_hull_length = 6, k_hull_beam = 1.2, k_hull_draught = 0.35, k_hull_depth = 0.6;  ///< [m]
constexpr double k_bow_length = 1.8, k_stern_length = 1.0;                                         ///< [m]
constexpr double k_stem_angle_deg = 25, k_entrance_angle_deg = 30, k_flare_angle_deg = 8;
constexpr int k_hull_triangles = 6000;

}  // namespace nilas::defaults
