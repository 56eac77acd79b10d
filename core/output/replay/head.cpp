#include "core/output/replay/head.h"

#include <nlohmann/json.hpp>

namespace nilas::output::replay {

namespace {

using Json = nlohmann::ordered_json;

Json view_json(const scene::ViewScene& view) {
  return {{"camera_elevation_deg", view.camera_elevation_deg},
          {"camera_heading_deg", view.camera_heading_deg},
          {"camera_distance", view.camera_distance},
          {"target", {view.target.x(), view.target.y(), view.target.z()}},
          {"mesh", std::string(choice_text(view.mesh).name)},
          {"wireframe", view.wireframe},
          {"normals", view.normals}};
}

Json channels_json(const Channels& channels) {
  Json list = Json::array();
  for (const Channel& channel : channels.list())
    list.push_back({{"name", channel.name}, {"unit", channel.unit}, {"group", channel.group}});
  return list;
}

}  // namespace

std::string waves_text(const sim::RunInfo& info) {
  Json trains = Json::array();
  for (const bodies::DrawnSea& sea : info.seas) {
    Json components = Json::array();
    for (const bodies::DrawnWave& wave : sea.waves)
      components.push_back({wave.amplitude, wave.frequency, wave.number.x(), wave.number.y(), wave.phase, wave.decay});
    trains.push_back({{"start", sea.start},
                      {"ramp", sea.ramp},
                      {"edge", {sea.edge.x(), sea.edge.y()}},
                      {"inward", {sea.inward.x(), sea.inward.y()}},
                      {"components", components}});
  }
  return trains.empty() ? std::string() : Json{{"trains", trains}}.dump();
}

std::string head_text(const scene::Scene& scene, const sim::RunInfo& info, const Channels& channels,
                      bool has_contact_table) {
  Json head{{"scene", info.scene_name}, {"step", scene.time.step}, {"every", scene.output.trajectory_every},
            {"until", scene.time.end},  {"water_level", nullptr},  {"tank", nullptr},
            {"view", nullptr},          {"hull", nullptr}};
  if (scene.water) head["water_level"] = scene.water->level;
  if (scene.tank)
    head["tank"] = {{"length", scene.tank->length}, {"width", scene.tank->width}, {"depth", scene.tank->depth}};
  if (scene.view) head["view"] = view_json(*scene.view);
  if (info.has_vessel) head["hull"] = {{"length", info.vessel_length}};
  head["contacts"] = has_contact_table ? std::string(choice_text(scene.output.contacts).name) : "none";
  head["damage"] = scene.fracture && scene.fracture->damage;
  head["channels"] = channels_json(channels);
  return head.dump();
}

}  // namespace nilas::output::replay
