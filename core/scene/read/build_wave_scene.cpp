#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

WaveScene build_waves(const SceneElement& element) {
  WaveScene waves;
  waves.line = element.place.line;
  assign(waves.kind, element, "kind");
  assign(waves.height, element, "height");
  assign(waves.period, element, "period");
  assign(waves.heading_deg, element, "heading_deg");
  assign(waves.phase_deg, element, "phase_deg");
  assign(waves.gamma, element, "gamma");
  assign(waves.components, element, "components");
  assign(waves.shortest_period, element, "shortest_period");
  assign(waves.spreading, element, "spreading");
  assign(waves.ramp, element, "ramp");
  assign(waves.depth, element, "depth");
  assign(waves.attenuation, element, "attenuation");
  assign(waves.attenuation_rate, element, "attenuation_rate");
  if (const auto edge = numbers_of(element, "ice_edge")) waves.ice_edge = Vec2(edge->at(0), edge->at(1));
  assign(waves.ice_edge_deg, element, "ice_edge_deg");
  return waves;
}

WaveLoadsScene build_wave_loads(const SceneElement& element) {
  WaveLoadsScene loads;
  assign(loads.vessel, element, "vessel");
  assign(loads.diffraction, element, "diffraction");
  assign(loads.floes, element, "floes");
  assign(loads.drift, element, "drift");
  return loads;
}

}  // namespace nilas::scene
