#include <algorithm>
#include <iostream>
#include <map>

#include "apps/nilas/commands/commands.h"
#include "apps/nilas/reports/hull_picture.h"
#include "apps/nilas/reports/prepare_hull.h"
#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/output/text/console.h"
#include "core/output/text/phase_progress.h"

namespace nilas {

namespace {

struct HullOptions {
  std::string mesh, generate, out = "hull";
  std::string forward = "x", up = "z";  ///< axes of the mesh file
  std::map<std::string, double> parameters;
  HullPreparation preparation;
  std::vector<std::string> preparation_flags;  ///< as given
  bool json = false, force = false, quiet = false;
};

/// Flag and what it sets; the names are those of <hull generate=...> in a scene, with '-' for '_'.
struct FormFlag {
  const char* name;
  const char* help;
};
constexpr FormFlag k_form_flags[] = {
    {"length", "length over all [m]"},
    {"beam", "beam at the design waterline [m]"},
    {"draught", "design draught [m]; also the waterline of the report (a mesh: half its height)"},
    {"depth", "keel to deck [m]"},
    {"stem_angle_deg", "stem against still water [deg]"},
    {"entrance_angle_deg", "half angle of the waterline at the stem [deg]"},
    {"bow_length", "length of the forebody [m]"},
    {"stern_length", "length of the run [m]"},
    {"flare_angle_deg", "sides from vertical [deg]"},
    {"triangles", "number of triangles, within 5 %"},
};

/// --stem-angle-deg for stem_angle_deg.
std::string dashed(const std::string& parameter) {
  std::string flag = "--" + parameter;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// Flags of a generated form, but for the draught, say nothing about a mesh.
void demand_no_form(const HullOptions& options) {
  for (const auto& [name, value] : options.parameters)
    if (name != "draught")
      throw InputError("nilas hull: found " + dashed(name) +
                       " beside MESH; it belongs to --generate, and of a form's flags a mesh allows --draught alone");
}

/// Flags that say how a mesh file is read, mended and cut do nothing where none is.
void demand_no_preparation(const HullOptions& options, const std::string& beside, const std::string& allowed) {
  if (options.preparation_flags.empty()) return;
  throw InputError(
      "nilas hull: found " + options.preparation_flags.front() + " beside " + beside +
      "; it says how a mesh file is treated, and here nothing is read, mended or cut; allowed: " + allowed);
}

/// Throws InputError for a flag that would do nothing.
void demand_used_flags(const HullOptions& options) {
  if (options.generate.empty() == options.mesh.empty())
    throw InputError("nilas hull: give either MESH or --generate icebreaker|wedge");
  if (options.mesh.empty()) {
    std::string allowed = "--out, --force, --json, --quiet";
    for (const auto& flag : k_form_flags) allowed += ", " + dashed(flag.name);
    demand_no_preparation(options, "--generate", allowed);
    return;
  }
  demand_no_form(options);
  if (is_folder(options.mesh))
    demand_no_preparation(options, "the hull folder " + options.mesh, "--draught, --out, --force, --json, --quiet");
}

void add_origin(nlohmann::ordered_json& description, const HullOptions& options) {
  if (options.generate.empty()) {
    description["mesh"] = options.mesh;
    if (is_folder(options.mesh)) return;
    description["scale"] = options.preparation.scale;
    description["forward"] = options.forward;
    description["up"] = options.up;
    return;
  }
  description["generate"] = options.generate;
  for (const auto& [name, value] : options.parameters) description["parameters"][name] = value;
}

/// The folder is worth having without a picture. Returns why there is none, else an empty text.
std::string try_to_draw(const Hull& hull, double level, const std::filesystem::path& folder) {
  try {
    draw_hull(hull, level, folder);
    return "";
  } catch (const FileError& e) {
    return e.what();
  }
}

/// A mesh among the files that the new hull replaces would be lost where that fails.
void demand_mesh_stays(const std::filesystem::path& mesh, const NewHullFolder& folder) {
  std::error_code ignored;
  if (folder.replaces(mesh) || std::filesystem::equivalent(mesh, folder.path(), ignored))
    throw InputError(mesh.string() + ": --out " + folder.path().string() + " would replace it; choose another folder");
}

/// Tells `progress` of the stages.
HullPreparation preparation_of(const HullOptions& options, PhaseProgress& progress) {
  HullPreparation how = options.preparation;
  how.stage_done = [&progress](const std::string& stage) {
    progress.next(stage == "read"   ? "mending the mesh"
                  : stage == "mend" ? "cutting the solid into convex parts"
                                    : "measuring the hull");
  };
  how.axes = {mesh_axis(options.forward), mesh_axis(options.up)};
  if (!how.axes.across())
    throw InputError("nilas hull: found --forward " + options.forward + " beside --up " + options.up +
                     "; allowed: axes across each other");
  if (const auto given = options.parameters.find("draught"); given != options.parameters.end())
    how.draught = given->second;
  return how;
}

PreparedHull generated(const HullForm& form) {
  PreparedHull made;
  made.hull = generate_hull(form);
  made.draught = form.draught;
  return made;
}

/// What advice on the hull says where it is from.
HullUse use_of(const HullOptions& options, const PreparedHull& made) {
  HullUse use;
  use.generated = !options.generate.empty();
  if (options.parameters.contains("draught")) use.draught = made.draught;
  if (use.generated) return use;
  const std::filesystem::path mesh = options.mesh;
  use.file = (is_folder(mesh) ? mesh / "fluid.stl" : mesh).string();
  use.drawn = {mesh_axis(options.forward), mesh_axis(options.up)};
  use.scale = options.preparation.scale;
  return use;
}

void warn(const std::string& text) { std::cerr << "warning: " << wrapped(text, 2) << "\n"; }

int hull(const HullOptions& options) {
  demand_used_flags(options);
  NewHullFolder folder(options.out, options.force);
  if (!options.mesh.empty()) demand_mesh_stays(options.mesh, folder);
  PhaseProgress progress(std::cerr, phase_style(options.quiet, options.json),
                         options.mesh.empty() ? "generating the hull" : "reading the mesh");
  PreparedHull made = options.mesh.empty() ? generated(hull_form(options.generate, options.parameters))
                                           : prepare_hull(options.mesh, preparation_of(options, progress), folder);
  progress.next("measuring the hull");
  made.use = use_of(options, made);
  auto result = hull_report(made);
  if (const std::string missed = missed_tolerance(made, options.preparation.most_parts); !missed.empty())
    result["warnings"].push_back(missed);
  progress.next("writing the hull and its picture");
  nlohmann::ordered_json description = result;
  add_origin(description, options);
  write_hull(made.hull, folder.staging(), description.dump(2) + "\n");
  const std::string no_picture =
      try_to_draw(made.hull, waterline_level(made.hull.fluid, made.draught), folder.staging());
  folder.publish();
  progress.end();
  if (!no_picture.empty()) std::cerr << "no picture: " << no_picture << "\n";
  for (const auto& warning : result["warnings"]) warn(warning.get<std::string>());
  std::cout << (options.json ? result.dump(2) + "\n" : report_text(result) + "written: " + options.out + "\n");
  return exit_done;
}

void add_form_flags(CLI::App& command, const std::shared_ptr<HullOptions>& options) {
  for (const auto& flag : k_form_flags) {
    std::string names = dashed(flag.name);
    if (names.ends_with("-deg")) names += "," + names.substr(0, names.size() - 4);
    command.add_option_function<double>(
        names, [options, name = std::string(flag.name)](const double& value) { options->parameters[name] = value; },
        flag.help);
  }
}

CLI::Validator positive() {
  return {[](const std::string& text) -> std::string {
            double value = 0;
            if (CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value)) return "";
            return "found " + text + "; allowed: a number above 0";
          },
          ""};
}

std::vector<CLI::Option*> add_preparation_flags(CLI::App& command, HullOptions& options) {
  HullPreparation& how = options.preparation;
  const std::vector<std::string> axes{"x", "-x", "y", "-y", "z", "-z"};
  return {
      command.add_option("--scale", how.scale, "metres per unit of the mesh file: 0.001 for mm")
          ->check(positive())
          ->capture_default_str(),
      command
          .add_option("--forward", options.forward, "the mesh file's axis that points to the bow: x, -x, y, -y, z, -z")
          ->check(CLI::IsMember(axes))
          ->capture_default_str(),
      command.add_option("--up", options.up, "the mesh file's axis that points up, likewise")
          ->check(CLI::IsMember(axes))
          ->capture_default_str(),
      command.add_option("--gap", how.gap, "points this close are one [m]; default 1e-5 of the length")
          ->check(positive()),
      command.add_option("--fill-holes", how.largest_hole, "fill holes up to this far across [m]; default length / 20")
          ->check(positive()),
      command.add_option("--tolerance", how.tolerance, "of the convex parts [m]; default length / 1000")
          ->check(positive()),
      command.add_option("--parts", how.most_parts, "convex parts, at most")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str(),
      command.add_option("--threads", how.threads, "threads, by default all; the results do not depend on it")
          ->check(at_least(1)),
  };
}

}  // namespace

void add_hull(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("hull", "makes or mends a hull, reports it, writes a hull folder for scenes");
  auto options = std::make_shared<HullOptions>();
  command->add_option("mesh", options->mesh, "STL, OBJ, OFF or PLY file of a hull, or a hull folder");
  command->add_option("--generate", options->generate, "form to generate: icebreaker or wedge");
  command->add_option("--out", options->out, "folder to write")->capture_default_str();
  command->add_flag("--force", options->force, "write into a folder that is not empty; replaces an earlier hull in it");
  add_form_flags(*command, options);
  const auto preparation = add_preparation_flags(*command, *options);
  command->add_flag("--json", options->json, "the report as JSON on stdout");
  command->add_flag("--quiet", options->quiet, "no progress");
  command->callback([&action, options, preparation] {
    for (const auto* flag : preparation)
      if (flag->count() > 0) options->preparation_flags.push_back(flag->get_name());
    action = [options] { return hull(*options); };
  });
}

}  // namespace nilas
