#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static void assign_mooring_line(MooringLineScene& line, const SceneElement& element) {
  line.line = element.place.line;
  assign(line.name, element, "name");
  assign(line.fairlead, element, "fairlead");
  assign(line.anchor, element, "anchor");
  assign(line.length, element, "length");
  assign(line.damping, element, "damping");
  assign(line.break_load, element, "break_load");
  assign(line.break_time, element, "break_time");
  assign(line.turret, element, "turret");
}

static CatenaryScene build_catenary(const SceneElement& element) {
  CatenaryScene line;
  assign_mooring_line(line, element);
  assign(line.weight, element, "weight");
  assign(line.stiffness, element, "stiffness");
  assign(line.bed_friction, element, "bed_friction");
  assign(line.diameter, element, "diameter");
  return line;
}

static SpringLineScene build_spring_line(const SceneElement& element) {
  SpringLineScene line;
  assign_mooring_line(line, element);
  assign(line.stiffness, element, "stiffness");
  assign(line.knee, element, "knee");
  assign(line.second_stiffness, element, "second_stiffness");
  assign(line.table, element, "table");
  return line;
}

MooringScene build_mooring_scene(const SceneElement& element) {
  MooringScene mooring;
  assign(mooring.model, element, "model");
  assign(mooring.start, element, "start");
  assign(mooring.file, element, "file");
  assign(mooring.depth, element, "depth");
  for (const auto& child : element.children) {
    if (child.name == "line") mooring.lines.push_back(build_catenary(child));
    if (child.name == "spring_line") mooring.springs.push_back(build_spring_line(child));
    if (child.name != "turret") continue;
    mooring.turret.emplace();
    assign(mooring.turret->at, child, "at");
    assign(mooring.turret->friction, child, "friction");
  }
  return mooring;
}

}  // namespace nilas::scene
