#include "core/scene/read/build_scene.h"

#include "core/scene/schema/attribute_values.h"

namespace nilas::scene {

static FrictionScene build_friction(const SceneElement& element) {
  FrictionScene friction;
  const auto materials = words_of(element, "between");
  friction.material_a = materials.at(0);
  friction.material_b = materials.at(1);
  assign(friction.static_, element, "static");
  assign(friction.kinetic, element, "kinetic");
  assign(friction.restitution, element, "restitution");
  assign(friction.rolling, element, "rolling");
  assign(friction.spinning, element, "spinning");
  assign(friction.elastic, element, "elastic");
  assign(friction.stiffness, element, "stiffness");
  assign(friction.edge_factor, element, "edge_factor");
  assign(friction.tangential_ratio, element, "tangential_ratio");
  assign(friction.damping_ratio, element, "damping_ratio");
  return friction;
}

static ContactScene build_contact(const SceneElement& element) {
  ContactScene contact;
  assign(contact.preset, element, "preset");
  assign(contact.law, element, "law");
  assign(contact.solver, element, "solver");
  assign(contact.tolerance, element, "tolerance");
  assign(contact.max_iterations, element, "max_iterations");
  assign(contact.on_failure, element, "on_failure");
  assign(contact.warm_start, element, "warm_start");
  assign(contact.axes_deg, element, "axes_deg");
  assign(contact.integrator, element, "integrator");
  assign(contact.theta, element, "theta");
  assign(contact.gyroscopic, element, "gyroscopic");
  assign(contact.detection, element, "detection");
  assign(contact.narrow_phase, element, "narrow_phase");
  assign(contact.substeps, element, "substeps");
  assign(contact.margin, element, "margin");
  assign(contact.stabilisation, element, "stabilisation");
  assign(contact.erp, element, "erp");
  assign(contact.slop, element, "slop");
  assign(contact.max_speed, element, "max_speed");
  for (const auto& child : element.children) contact.friction.push_back(build_friction(child));
  return contact;
}

static WaterScene build_water(const SceneElement& element) {
  WaterScene water;
  assign(water.density, element, "density");
  assign(water.level, element, "level");
  if (const auto* current = child_of(element, "current")) water.current = build_current(*current);
  for (const auto& child : element.children)
    if (child.name == "waves") water.waves.push_back(build_waves(child));
  return water;
}

static HydroScene build_hydro(const SceneElement& element) {
  HydroScene hydro;
  hydro.buoyancy = child_of(element, "buoyancy") != nullptr;
  if (const auto* drag = child_of(element, "drag")) {
    hydro.drag.emplace();
    assign(hydro.drag->form, *drag, "form");
    assign(hydro.drag->skin, *drag, "skin");
  }
  if (const auto* added = child_of(element, "added_mass")) {
    hydro.added_mass.emplace();
    assign(hydro.added_mass->floes, *added, "floes");
    assign(hydro.added_mass->vessel, *added, "vessel");
    assign(hydro.added_mass->matrix, *added, "matrix");
    assign(hydro.added_mass->at, *added, "at");
  }
  if (const auto* loads = child_of(element, "wave_loads")) hydro.wave_loads = build_wave_loads(*loads);
  if (const auto* radiation = child_of(element, "radiation")) hydro.radiation = build_radiation(*radiation);
  hydro.restoring = child_of(element, "restoring") != nullptr;
  if (const auto* database = child_of(element, "database")) hydro.database = build_database(*database);
  if (const auto* drag = child_of(element, "virtual_drag")) {
    hydro.virtual_drag.emplace();
    assign(hydro.virtual_drag->coefficient, *drag, "coefficient");
    assign(hydro.virtual_drag->velocity, *drag, "velocity");
  }
  if (const auto* wash = child_of(element, "propeller_wash"))
    for (const auto& jet : wash->children) hydro.jets.push_back(build_jet(jet));
  return hydro;
}

static TankScene build_tank(const SceneElement& element) {
  TankScene tank;
  assign(tank.length, element, "length");
  assign(tank.width, element, "width");
  assign(tank.depth, element, "depth");
  assign(tank.wall_thickness, element, "wall_thickness");
  assign(tank.floor, element, "floor");
  return tank;
}

static FractureScene build_fracture(const SceneElement& element) {
  FractureScene fracture;
  assign(fracture.flexural_strength, element, "flexural_strength");
  assign(fracture.compressive_strength, element, "compressive_strength");
  assign(fracture.fracture_toughness, element, "fracture_toughness");
  assign(fracture.min_area, element, "min_area");
  assign(fracture.max_aspect, element, "max_aspect");
  assign(fracture.small_pieces, element, "small_pieces");
  if (const auto* crushing = child_of(element, "crushing")) {
    fracture.crushing.emplace();
    assign(fracture.crushing->model, *crushing, "model");
    assign(fracture.crushing->coefficient, *crushing, "coefficient");
    assign(fracture.crushing->exponent, *crushing, "exponent");
    assign(fracture.crushing->between_floes, *crushing, "between_floes");
    assign(fracture.crushing->clear_volume, *crushing, "clear_volume");
  }
  if (const auto* bending = child_of(element, "bending")) {
    fracture.bending.emplace();
    assign(fracture.bending->model, *bending, "model");
    assign(fracture.bending->wedge_angle_deg, *bending, "wedge_angle_deg");
    assign(fracture.bending->speed_slope, *bending, "speed_slope");
  }
  if (const auto* splitting = child_of(element, "splitting")) {
    fracture.splitting.emplace();
    assign(fracture.splitting->model, *splitting, "model");
    assign(fracture.splitting->multiplier, *splitting, "multiplier");
  }
  if (const auto* cracks = child_of(element, "cracks")) {
    fracture.cracks.emplace();
    assign(fracture.cracks->path, *cracks, "path");
    assign(fracture.cracks->segment_thicknesses, *cracks, "segment_thicknesses");
  }
  if (const auto* damage = child_of(element, "damage")) {
    fracture.damage.emplace();
    assign(fracture.damage->exponent, *damage, "exponent");
    assign(fracture.damage->endurance, *damage, "endurance");
  }
  return fracture;
}

static SolidShape build_solid_shape(const SceneElement& element) {
  switch (choice_of<SolidShapeKind>(element, "shape").value_or(SolidScene{}.kind())) {
    case SolidShapeKind::box: {
      BoxScene box;
      assign(box.size, element, "size");
      return box;
    }
    case SolidShapeKind::sphere: {
      SphereScene sphere;
      assign(sphere.radius, element, "radius");
      return sphere;
    }
    case SolidShapeKind::cylinder: {
      CylinderScene cylinder;
      assign(cylinder.radius, element, "radius");
      assign(cylinder.height, element, "height");
      return cylinder;
    }
    case SolidShapeKind::mesh: {
      MeshScene mesh;
      assign(mesh.file, element, "mesh");
      assign(mesh.cog, element, "cog");
      return mesh;
    }
    case SolidShapeKind::plane:
      return PlaneScene{};
  }
  return {};
}

void assign_solid(SolidScene& solid, const SceneElement& element) {
  solid.line = element.place.line;
  assign(solid.name, element, "name");
  solid.shape = build_solid_shape(element);
  assign(solid.material, element, "material");
  assign(solid.mass, element, "mass");
  assign(solid.density, element, "density");
  assign(solid.inertia, element, "inertia");
  assign(solid.position, element, "position");
  assign(solid.rotation_deg, element, "rotation_deg");
}

static BodyScene build_body(const SceneElement& element) {
  BodyScene body;
  assign_solid(body, element);
  assign(body.fixed, element, "fixed");
  assign(body.velocity, element, "velocity");
  assign(body.angular_velocity, element, "angular_velocity");
  return body;
}

static OutputScene build_output(const SceneElement& element) {
  OutputScene output;
  assign(output.folder, element, "folder");
  assign(output.trajectory_every, element, "trajectory_every");
  assign(output.tank_walls, element, "tank_walls");
  assign(output.contacts, element, "contacts");
  assign(output.problems, element, "problems");
  assign(output.checkpoint_every, element, "checkpoint_every");
  assign(output.bodies, element, "bodies");
  assign(output.peak_filter, element, "peak_filter");
  assign(output.load_checks, element, "load_checks");
  if (const auto window = numbers_of(element, "statistics")) output.statistics = {window->at(0), window->at(1)};
  return output;
}

static ViewScene build_view(const SceneElement& element) {
  ViewScene view;
  assign(view.camera_elevation_deg, element, "camera_elevation_deg");
  assign(view.camera_heading_deg, element, "camera_heading_deg");
  assign(view.camera_distance, element, "camera_distance");
  assign(view.target, element, "target");
  assign(view.mesh, element, "mesh");
  assign(view.wireframe, element, "wireframe");
  assign(view.normals, element, "normals");
  return view;
}

static void build_time(TimeScene& time, const SceneElement& element) {
  assign(time.step, element, "step");
  assign(time.start, element, "start");
  assign(time.end, element, "end");
}

static void build_seed(Scene& scene, const SceneElement& element) {
  scene.seed = static_cast<std::uint64_t>(number_of(element, "value").value());
  scene.twin = static_cast<std::uint64_t>(number_of(element, "twin").value());
}

static void build_element(Scene& scene, const SceneElement& element) {
  const std::string& name = element.name;
  if (name == "time") build_time(scene.time, element);
  if (name == "gravity") assign(scene.gravity, element, "value");
  if (name == "seed") build_seed(scene, element);
  if (name == "contact") scene.contact = build_contact(element);
  if (name == "water") scene.water = build_water(element);
  if (name == "hydro") scene.hydro = build_hydro(element);
  if (name == "wind") scene.wind = build_wind(element);
  if (name == "tank") scene.tank = build_tank(element);
  if (name == "vessel") scene.vessel = build_vessel_scene(element);
  if (name == "fracture") scene.fracture = build_fracture(element);
  if (name == "body") scene.bodies.push_back(build_body(element));
  if (name == "output") scene.output = build_output(element);
  if (name == "view") scene.view = build_view(element);
}

Scene build_scene(const SceneElement& root) {
  Scene scene;
  assign(scene.name, root, "name");
  assign(scene.scale, root, "scale");
  for (const auto& element : root.children) build_element(scene, element);
  if (const auto* ice = child_of(root, "ice")) scene.ice = build_ice_scene(*ice, child_of(root, "fracture"));
  return scene;
}

}  // namespace nilas::scene
