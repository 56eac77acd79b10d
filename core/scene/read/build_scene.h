#pragma once
/// Converts a checked and resolved tree to the plain values of a Scene.
#include "core/scene/document/document.h"
#include "core/scene/scene.h"

namespace nilas::scene {

/// Builds everything except file, notes and as_run.
Scene build_scene(const SceneElement& root);

/// Sets the values that <body> and <part> share.
void assign_solid(SolidScene& solid, const SceneElement& element);
/// Sets the values that <field> and <floe> share.
void assign_placement(IcePlacement& placement, const SceneElement& element);
DatabaseScene build_database(const SceneElement& element);
RadiationScene build_radiation(const SceneElement& element);
FieldScene build_field_scene(const SceneElement& field);
VesselScene build_vessel_scene(const SceneElement& vessel);
/// Sets the values of <thrusters> and <control>.
void build_thrusters_scene(VesselScene& scene, const SceneElement& vessel);
CurrentScene build_current(const SceneElement& current);
WindScene build_wind(const SceneElement& wind);
WindAreaScene build_wind_area(const SceneElement& area);
WaveScene build_waves(const SceneElement& waves);
WaveLoadsScene build_wave_loads(const SceneElement& loads);
ManoeuvringScene build_manoeuvring_scene(const SceneElement& manoeuvring);
ManoeuvreScene build_manoeuvre_scene(const SceneElement& manoeuvre);
JetScene build_jet(const SceneElement& jet);
MooringScene build_mooring_scene(const SceneElement& mooring);
/// Builds the values of <ice>. `fracture`: the scene's element, null without one; its strengths are the means for
/// <vary>.
IceScene build_ice_scene(const SceneElement& ice, const SceneElement* fracture);

}  // namespace nilas::scene
