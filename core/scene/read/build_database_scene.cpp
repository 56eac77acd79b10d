#include "core/scene/read/build_scene.h"
#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

DatabaseScene build_database(const SceneElement& element) {
  DatabaseScene database;
  assign(database.file, element, "file");
  assign(database.length, element, "length");
  assign(database.density, element, "density");
  assign(database.gravity, element, "gravity");
  assign(database.depth, element, "depth");
  assign(database.reference, element, "reference");
  assign(database.origin, element, "origin");
  assign(database.rotation_deg, element, "rotation_deg");
  return database;
}

RadiationScene build_radiation(const SceneElement& element) {
  RadiationScene radiation;
  assign(radiation.model, element, "model");
  assign(radiation.error, element, "error");
  assign(radiation.order, element, "order");
  assign(radiation.memory, element, "memory");
  assign(radiation.highest_frequency, element, "highest_frequency");
  return radiation;
}

}  // namespace nilas::scene
