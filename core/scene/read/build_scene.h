#pragma once
/// From a checked and resolved tree to the plain values of a Scene.
#include "core/scene/document/document.h"
#include "core/scene/scene.h"

namespace nilas {

/// Everything but file, notes and as_run.
Scene build_scene(const SceneElement& root);

/// What a <body> and a <part> have in common.
void assign_solid(SolidScene& solid, const SceneElement& element);
/// What a <field> and a <floe> have in common.
void assign_placement(IcePlacement& placement, const SceneElement& element);
FieldScene build_field_scene(const SceneElement& field);
VesselScene build_vessel_scene(const SceneElement& vessel);
/// `fracture`: the scene's element, null without one; its strengths are what <vary> varies about.
IceScene build_ice_scene(const SceneElement& ice, const SceneElement* fracture);

}  // namespace nilas
