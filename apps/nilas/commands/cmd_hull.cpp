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

namespace nilas::commands {

namespace {

struct HullOptions {
  std::string mesh, generate, out = "hull";
  std::string forward = "x", up = "z";  ///< axes of the mesh file
  std::map<std::string, double> parameters;
  HullPreparation preparation;
  std::vector<std::string> preparation_flags;  ///< flags of `preparation` that the user gave, in the order of the help
  bool json = false, force = false, quiet = false;
};

/// A flag of a generated form. Its name is that of the attribute of <hull generate=...> in a scene, which has '_' for
/// '-'.
struct FormFlag {
  const char* name;
  const char* help;
};
constexpr FormFlag k_form_flags[] = {
    {"length", "Sets the length over all [m]."},
    {"beam", "Sets the beam at the design waterline [m]."},
    {"draught",
     "Sets the design draught [m], at which the report takes the waterline. The default for a mesh is half its "
     "height."},
    {"depth", "Sets the depth from keel to deck [m]."},
    {"stem_angle_deg", "Sets the angle between the stem and the still water surface [deg]."},
    {"entrance_angle_deg", "Sets the half angle of the waterline at the stem [deg]."},
    {"bow_length", "Sets the length of the forebody [m]."},
    {"stern_length", "Sets the length of the run, the part of the hull that narrows aft [m]."},
    {"flare_angle_deg", "Sets the angle of the sides from the vertical [deg]."},
    {"triangles", "Sets the number of triangles, which is met within 5 %."},
};

/// The flag of a parameter: "--stem-angle-deg" for "stem_angle_deg".
std::string dashed(const std::string& parameter) {
  std::string flag = "--" + parameter;
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

/// Throws InputError for a flag of a generated form, except --draught: they mean nothing for a mesh.
void demand_no_form(const HullOptions& options) {
  for (const auto& [name, value] : options.parameters)
    if (name != "draught")
      throw InputError(
          "nilas hull: found " + dashed(name) +
          " with MESH; it belongs to --generate, and --draught is the only flag of a form that a mesh allows");
}

/// Throws InputError for a flag that states how a mesh file is read, mended and cut, where no mesh file is read.
void demand_no_preparation(const HullOptions& options, const std::string& beside, const std::string& allowed) {
  if (options.preparation_flags.empty()) return;
  throw InputError(
      "nilas hull: found " + options.preparation_flags.front() + " with " + beside +
      "; it states how a mesh file is treated, but nothing is read, mended or cut here; allowed: " + allowed);
}

/// Throws InputError for a flag that would do nothing.
void demand_used_flags(const HullOptions& options) {
  if (options.generate.empty() == options.mesh.empty())
    throw InputError("nilas hull: allowed: either MESH or --generate, and --generate takes icebreaker or wedge");
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

/// Draws hull.png. Returns why it could not be drawn, else an empty text: the hull is complete without it.
std::string try_to_draw(const hull::Hull& hull, double level, const std::filesystem::path& folder) {
  try {
    draw_hull(hull, level, folder);
    return "";
  } catch (const FileError& e) {
    return e.what();
  }
}

/// Throws InputError if the new hull would replace the mesh file, which a failure would then lose.
void demand_mesh_stays(const std::filesystem::path& mesh, const hull::NewHullFolder& folder) {
  std::error_code ignored;
  if (folder.replaces(mesh) || std::filesystem::equivalent(mesh, folder.path(), ignored))
    throw InputError(mesh.string() + ": --out " + folder.path().string() + " would replace it; choose another folder");
}

/// The preparation that the flags ask for. `progress` is told of its stages. Throws InputError for axes that are not
/// across each other.
HullPreparation preparation_of(const HullOptions& options, output::PhaseProgress& progress) {
  HullPreparation how = options.preparation;
  how.stage_done = [&progress](const std::string& stage) {
    progress.next(stage == "read"   ? "mending the mesh"
                  : stage == "mend" ? "cutting the solid into convex parts"
                                    : "measuring the hull");
  };
  how.axes = {hull::mesh_axis(options.forward), hull::mesh_axis(options.up)};
  if (!how.axes.across())
    throw InputError("nilas hull: found --forward " + options.forward + " with --up " + options.up +
                     "; allowed: axes at right angles to each other");
  if (const auto given = options.parameters.find("draught"); given != options.parameters.end())
    how.draught = given->second;
  return how;
}

PreparedHull generated(const hull::HullForm& form) {
  PreparedHull made;
  made.hull = hull::generate_hull(form);
  made.draught = form.draught;
  return made;
}

/// The origin of the hull, for advice on it.
hull::HullUse use_of(const HullOptions& options, const PreparedHull& made) {
  hull::HullUse use;
  use.generated = !options.generate.empty();
  if (options.parameters.contains("draught")) use.draught = made.draught;
  if (use.generated) return use;
  const std::filesystem::path mesh = options.mesh;
  use.file = (is_folder(mesh) ? mesh / "fluid.stl" : mesh).string();
  use.drawn = {hull::mesh_axis(options.forward), hull::mesh_axis(options.up)};
  use.scale = options.preparation.scale;
  return use;
}

void warn(const std::string& text) { std::cerr << "warning: " << output::wrapped(text, 2) << "\n"; }

int hull(const HullOptions& options) {
  demand_used_flags(options);
  hull::NewHullFolder folder(options.out, options.force);
  if (!options.mesh.empty()) demand_mesh_stays(options.mesh, folder);
  output::PhaseProgress progress(std::cerr, output::phase_style(options.quiet, options.json),
                                 options.mesh.empty() ? "generating the hull" : "reading the mesh");
  PreparedHull made = options.mesh.empty() ? generated(hull::hull_form(options.generate, options.parameters))
                                           : prepare_hull(options.mesh, preparation_of(options, progress), folder);
  progress.next("measuring the hull");
  made.use = use_of(options, made);
  auto result = hull_report(made);
  if (const std::string missed = missed_tolerance(made, options.preparation.most_parts); !missed.empty())
    result["warnings"].push_back(missed);
  progress.next("writing the hull and its picture");
  nlohmann::ordered_json description = result;
  add_origin(description, options);
  hull::write_hull(made.hull, folder.staging(), description.dump(2) + "\n");
  const std::string no_picture =
      try_to_draw(made.hull, waterline_level(made.hull.fluid, made.draught), folder.staging());
  folder.publish();
  progress.end();
  if (!no_picture.empty()) std::cerr << "There is no picture: " << no_picture << "\n";
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
      command
          .add_option("--scale", how.scale,
                      "States how many metres a unit of the mesh file is, above 0: 0.001 for millimetres.")
          ->check(positive())
          ->capture_default_str(),
      command.add_option("--forward", options.forward, "Names the axis of the mesh file that points to the bow.")
          ->check(CLI::IsMember(axes))
          ->capture_default_str(),
      command.add_option("--up", options.up, "Names the axis of the mesh file that points up.")
          ->check(CLI::IsMember(axes))
          ->capture_default_str(),
      command
          .add_option("--gap", how.gap,
                      "Merges points that are this close [m], above 0. The default is 1e-5 of the longest side.")
          ->check(positive()),
      command
          .add_option("--fill-holes", how.largest_hole,
                      "Fills holes up to this wide [m], above 0. The default is 1/20 of the longest side.")
          ->check(positive()),
      command
          .add_option("--tolerance", how.tolerance,
                      "Allows the convex parts to deviate this far from the mesh [m], above 0. The default is 1/1000 "
                      "of the longest "
                      "side.")
          ->check(positive()),
      command.add_option("--parts", how.most_parts, "Limits the number of convex parts.")
          ->check(CLI::Range(1, 1000))
          ->capture_default_str(),
      command
          .add_option("--threads", how.threads,
                      "Computes on this many threads, at least 1. The default is one per core. The results do not "
                      "depend on the "
                      "number.")
          ->check(at_least(1)),
  };
}

}  // namespace

void add_hull(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("hull", "Generates or mends a hull, reports on it and writes a hull folder for scenes.");
  auto options = std::make_shared<HullOptions>();
  command->add_option("mesh", options->mesh,
                      "Reads the hull from this STL, OBJ, OFF or PLY file, or from this hull folder.");
  command->add_option("--generate", options->generate, "Generates a hull of this form: icebreaker or wedge.");
  command->add_option("--out", options->out, "Writes the hull folder here.")->capture_default_str();
  command->add_flag("--force", options->force,
                    "Writes into the folder even if it is not empty. An earlier hull there is replaced.");
  add_form_flags(*command, options);
  const auto preparation = add_preparation_flags(*command, *options);
  command->add_flag("--json", options->json, "Prints the report as JSON on standard output.");
  command->add_flag("--quiet", options->quiet, "Prints no progress.");
  command->callback([&action, options, preparation] {
    for (const auto* flag : preparation)
      if (flag->count() > 0) options->preparation_flags.push_back(flag->get_name());
    action = [options] { return hull(*options); };
  });
}

}  // namespace nilas::commands
