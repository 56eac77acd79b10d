#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "apps/nilas/commands.h"
#include "core/base/error.h"
#include "core/bodies/mass_properties.h"
#include "core/vessel/hull.h"
#include "hydro/wetted.h"

namespace nilas {

namespace {

struct HullOptions {
  std::string mesh, generate, out = "hull";
  std::map<std::string, double> parameters;
  std::optional<double> draught;
  bool json = false;
};

/// Flag and what it sets; the names are those of <hull generate=...> in a scene, with '-' for '_'.
struct FormFlag {
  const char* name;
  const char* help;
};
constexpr FormFlag k_form_flags[] = {
    {"length", "length over all [m]"},
    {"beam", "beam at the design waterline [m]"},
    {"draught", "design draught [m]; also the waterline of the report"},
    {"depth", "keel to deck [m]"},
    {"stem_angle_deg", "stem against still water [deg]"},
    {"entrance_angle_deg", "half angle of the waterline at the stem [deg]"},
    {"bow_length", "length of the forebody [m]"},
    {"stern_length", "length of the run [m]"},
    {"flare_angle_deg", "sides from vertical [deg]"},
    {"triangles", "number of triangles, within 5 %"},
};

double wetted_area(const TriangleMesh& mesh, double level) {
  std::vector<WettedFace> faces;
  wetted_faces(mesh, Mat3::Identity(), Vec3::Zero(), level, faces);
  double area = 0;
  for (const auto& face : faces) area += face.area;
  return area;
}

bool symmetric(const TriangleMesh& mesh) {
  std::set<std::array<double, 3>> points;
  for (const auto& p : mesh.vertices) points.insert({p.x(), p.y() + 0.0, p.z()});
  for (const auto& p : mesh.vertices)
    if (!points.count({p.x(), 0.0 - p.y(), p.z()})) return false;
  return true;
}

nlohmann::ordered_json report(const Hull& hull, double draught) {
  const MassProperties unit = mesh_properties(hull.fluid, 1.0);
  double keel = hull.fluid.vertices.front().z();
  for (const auto& p : hull.fluid.vertices) keel = std::min(keel, p.z());
  const double level = keel + draught;
  const Submerged wet = submerged_mesh(hull.fluid, Mat3::Identity(), Vec3::Zero(), level);
  const Waterplane plane = waterplane(hull.fluid, Mat3::Identity(), Vec3::Zero(), level);
  const double kb = wet.volume > 0 ? wet.centre.z() - keel : 0, bm = wet.volume > 0 ? plane.yy / wet.volume : 0;
  const Mat3& i = unit.inertia;
  return {{"volume_m3", unit.mass},
          {"centre_m", {unit.com.x(), unit.com.y(), unit.com.z()}},
          {"inertia_per_density_m5", {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)}},
          {"parts", hull.parts.size()},
          {"deviation_m", 0.0},
          {"draught_m", draught},
          {"displaced_m3", wet.volume},
          {"kb_m", kb},
          {"bm_m", bm},
          {"gm_m", kb + bm - (unit.com.z() - keel)},
          {"wetted_area_m2", wetted_area(hull.fluid, level)},
          {"waterplane_area_m2", plane.area},
          {"symmetric", symmetric(hull.fluid)},
          {"closed", find_defects(hull.fluid).closed()},
          {"triangles", hull.fluid.triangles.size()},
          {"mended", nlohmann::ordered_json::array()}};
}

int hull(const HullOptions& options) {
  if (options.generate.empty() == options.mesh.empty())
    throw InputError("nilas hull: give either MESH or --generate icebreaker|wedge");
  const HullForm form = options.generate.empty() ? HullForm{} : hull_form(options.generate, options.parameters);
  const Hull made = options.generate.empty() ? read_hull(options.mesh) : generate_hull(form);
  const auto draught = options.parameters.find("draught");
  auto result = report(made, draught != options.parameters.end() ? draught->second : form.draught);
  nlohmann::ordered_json description = result;
  if (!options.generate.empty()) description["generate"] = options.generate;
  for (const auto& [name, value] : options.parameters) description["parameters"][name] = value;
  write_hull(made, options.out, description.dump(2) + "\n");
  if (options.json) {
    std::cout << result.dump(2) << "\n";
    return exit_done;
  }
  for (const auto& [name, value] : result.items()) std::cout << fmt::format("  {:<24} {}\n", name, value.dump());
  std::cout << "written: " << options.out << "\n";
  return exit_done;
}

}  // namespace

void add_hull(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("hull", "generates or reads a hull, reports it, writes a hull folder for scenes");
  auto options = std::make_shared<HullOptions>();
  command->add_option("mesh", options->mesh, "hull folder, or a closed convex STL file in metres");
  command->add_option("--generate", options->generate, "form to generate: icebreaker or wedge");
  command->add_option("--out", options->out, "folder to write")->capture_default_str();
  for (const auto& flag : k_form_flags) {
    std::string dashed = flag.name;
    for (auto& c : dashed) c = c == '_' ? '-' : c;
    std::string names = "--" + dashed;
    if (dashed.size() > 4 && dashed.substr(dashed.size() - 4) == "-deg")
      names += ",--" + dashed.substr(0, dashed.size() - 4);
    command->add_option_function<double>(
        names, [options, name = std::string(flag.name)](const double& value) { options->parameters[name] = value; },
        flag.help);
  }
  command->add_flag("--json", options->json, "the report as JSON on stdout");
  command->callback([&action, options] { action = [options] { return hull(*options); }; });
}

}  // namespace nilas
