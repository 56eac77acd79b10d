#pragma once
/// A scene as plain values: what the XML said, with every default filled in. What is not named is an empty optional or
/// list. The schema table (schema.h) gives each field its XML name, range, default and documentation.
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"

namespace nilas {

struct TimeScene {
  double step = 0.01;  ///< [s]
  double start = 0;    ///< [s]
  double end = 10;     ///< [s]
};

struct FrictionScene {
  std::string material_a = "*", material_b = "*";
  double static_ = 0, kinetic = 0, rolling = 0, spinning = 0, restitution = 0;
};

struct ContactScene {
  std::string law = "coulomb";
  std::string solver = "auto";
  double tolerance = 1e-6;  ///< law_map_m_s; 0: always max_iterations sweeps
  int max_iterations = 1000;
  int substeps = 0;  ///< parts that a step is cut into at impacts, at most
  std::string on_failure = "record";
  std::string integrator = "moreau";
  double theta = 0.5;
  std::string stabilisation = "projection";
  double erp = 0.2;        ///< share of the penetration removed per step
  double slop = 0;         ///< penetration left alone [m]
  double max_speed = 1.0;  ///< of the correction [m/s]
  std::string detection = "continuous";
  std::string narrow_phase = "nilas";
  double margin = 0;  ///< gap within which contacts enter the problem [m]; 0: what the bodies can reach in the step
  bool gyroscopic = true;
  double axes_deg = 0;  ///< turns the contact tangents about the normal
  bool warm_start = true;
  std::string preset;
  std::vector<FrictionScene> friction;
};

struct CurrentScene {
  Vec3 velocity = Vec3::Zero();
};
struct WaterScene {
  double density = 1025, level = 0;
  std::optional<CurrentScene> current;
};

struct DragScene {
  double form = 1.0, skin = 0.005;
};
struct VirtualDragScene {
  double coefficient = 0.1;
  Vec3 velocity = Vec3::Zero();
};
struct HydroScene {
  bool buoyancy = false;
  std::optional<DragScene> drag;
  std::optional<VirtualDragScene> virtual_drag;
};

struct TankScene {
  double length = 10, width = 5, depth = 2, wall_thickness = 0.2;
  bool floor = true;
};

struct MassScene {
  std::optional<double> value;    ///< [kg]
  std::optional<Vec3> cog;        ///< in V [m]
  std::optional<Vec6> inertia;    ///< about the centre of mass in V: xx yy zz xy xz yz [kg m^2]
  std::optional<double> draught;  ///< mass from the displaced volume [m]
};
struct ForceBalanceScene {
  std::string kind = "rigid";
  double stiffness = 1e7, damping = 1e4;
  std::string layout;  ///< absolute path, or empty
};
struct CarriageScene {
  double speed = 0, ramp = 0;
  std::string ramp_shape = "linear";  ///< or smooth
  double heading_deg = 0;             ///< direction of motion in G
  std::optional<Vec3> joint;          ///< in V [m]; default: the centre of mass
  std::array<bool, 6> free{};         ///< surge sway heave roll pitch yaw
  std::string start = "equilibrium";  ///< or as-placed
  std::string path;                   ///< absolute path, or empty
  ForceBalanceScene balance;
};
/// <hull generate=...>: parameters of the generated form; unnamed ones keep the generator's defaults.
struct HullGenerateScene {
  std::string kind = "icebreaker";
  std::map<std::string, double> parameters;  ///< by XML name: length, beam, stem_angle_deg, triangles ...
};
/// The shape and mass of a <body> or of a <part> of the vessel.
struct SolidScene {
  std::string name;
  std::string shape = "box";  ///< box sphere cylinder plane mesh
  Vec3 size = Vec3::Ones();
  double radius = 0.5, height = 1;
  std::string mesh;  ///< absolute path
  std::optional<double> mass, density;
  std::optional<Vec3> cog;      ///< of a part: centre of mass in its own frame [m]
  std::optional<Vec6> inertia;  ///< xx yy zz xy xz yz [kg m^2]
  Vec3 position = Vec3::Zero();
  Vec3 rotation_deg = Vec3::Zero();  ///< yaw pitch roll
  std::string material = "structure";
  int line = 0;
};
/// A part's position and rotation are in V while all joints are at zero.
struct PartScene : SolidScene {
  std::string joint = "hinge";  ///< hinge slider ball free weld
  std::string to;               ///< name of another part or of the vessel; empty: the hull
  std::optional<Vec3> at;       ///< joint point in V [m]; default: the position
  Vec3 axis = Vec3::UnitZ();
  double stiffness = 0, damping = 0;
  double rest_angle_deg = 0, angle_deg = 0, rate_deg = 0;  ///< of a hinge
  double rest_travel = 0, travel = 0, speed = 0;           ///< of a slider [m, m/s]
};
/// A rod from the vessel to a fixed point.
struct RodScene {
  std::string name;
  std::string on;                ///< name of a part or of the vessel; empty: the hull
  Vec3 at = Vec3::Zero();        ///< in V, of a part while all joints are at zero [m]
  Vec3 to = Vec3::Zero();        ///< in G [m]
  std::optional<double> length;  ///< [m]; default: as placed
  int line = 0;
};
struct VesselScene {
  std::string name = "ship";
  std::string hull;  ///< absolute path, or empty when generated
  std::optional<HullGenerateScene> generate;
  Vec3 position = Vec3::Zero();  ///< of the origin of V
  bool position_has_z = true;    ///< two numbers given: z from floating equilibrium
  double heading_deg = 0;
  Vec3 velocity = Vec3::Zero();          ///< free vessel, in G [m/s]
  Vec3 angular_velocity = Vec3::Zero();  ///< free vessel, in G [rad/s]
  MassScene mass;
  bool fixed = false;
  std::optional<CarriageScene> carriage;
  std::vector<PartScene> parts;
  std::vector<RodScene> rods;
};

struct SizeScene {
  std::string distribution = "lognormal";
  double mean = 0.8, sd = 0.3, min = 0.3, max = 1.6, exponent = 1.5;
};
struct ShapeScene {
  std::string kind = "polygon";
  int vertices_min = 5, vertices_max = 9;
  double aspect = 1.5;
  std::string library;  ///< absolute path; empty: `kind`
};
struct FieldScene {
  std::string kind = "packed";
  std::array<double, 4> region{0, 0, 1, 1};  ///< x0 y0 x1 y1 [m]
  double concentration = 0.8;
  bool breakable = false;
  double overlap_tolerance = 1e-3;
  std::optional<double> channel_width;  ///< [m]
  int rows = 1, columns = 1;
  double gap = 0, shear_deg = 0;
  bool stagger = false;
  std::string file;  ///< absolute path of a GeoJSON field
  bool fixed = false;
  Vec3 velocity = Vec3::Zero();
  double z = 0;  ///< offset from floating equilibrium [m]
  std::optional<double> thickness;
  SizeScene size;
  ShapeScene shape;
  std::optional<double> bond;  ///< strength left on the seams of floes that are frozen together
};
struct FloeScene {
  std::string name;
  std::vector<Vec2> outline;  ///< in G [m]
  bool fixed = false, breakable = false;
  Vec3 velocity = Vec3::Zero();
  double z = 0;
  std::optional<double> thickness;
  int line = 0;
};
struct VaryScene {
  std::string property, distribution = "normal";
  double cov = 0;
  double mean = 0;                                           ///< of a strength, in its unit; 0: the ice's own
  double correlation_length = 0;                             ///< [m]; 0: one value per floe
  std::vector<std::pair<std::string, double>> correlations;  ///< with other properties, of the normal scores
  int line = 0;
};
/// Ground frame at the start.
struct WeakLineScene {
  std::vector<Vec2> points;  ///< [m]
  double strength = 1;       ///< share left of flexural strength and fracture toughness
};
struct IceScene {
  double density = 920, youngs_modulus = 6e7, poisson = 0.3, thickness = 0.04;
  std::vector<FieldScene> fields;
  std::vector<FloeScene> floes;
  std::vector<WeakLineScene> weak_lines;
  std::vector<VaryScene> vary;
};

struct CrushingScene {
  std::string model = "seed-limit";
  double coefficient = 1e5, exponent = -0.7;  ///< of model pressure-area [Pa m^(-2 exponent), -]
  bool between_floes = false;
  std::optional<double> clear_volume;  ///< [m^3]
};
struct BendingScene {
  std::string model = "nevel";
  double wedge_angle_deg = 45;
  double speed_slope = 0;  ///< [s/m]
};
struct SplittingScene {
  std::string model = "seed-geometric";
  double multiplier = 2.5;
};
struct CracksScene {
  std::string path = "straight";
  double segment_thicknesses = 2;
};
struct DamageScene {
  double exponent = 13.5, endurance = 0.6;
};
struct FractureScene {
  double flexural_strength = 4e4, compressive_strength = 1e5;  ///< [Pa]
  double fracture_toughness = 3e3;                             ///< [Pa sqrt(m)]
  double min_area = 2e-4;                                      ///< [m^2]
  double max_aspect = 8;
  std::string small_pieces = "brash";
  std::optional<CrushingScene> crushing;
  std::optional<BendingScene> bending;
  std::optional<SplittingScene> splitting;
  std::optional<CracksScene> cracks;
  std::optional<DamageScene> damage;

  /// Whether floes can come apart.
  bool cuts_floes() const { return bending || splitting || (crushing && crushing->clear_volume); }
};

struct BodyScene : SolidScene {
  Vec3 velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();
  bool fixed = false;
};

struct OutputScene {
  std::string folder;             ///< relative to the working directory; empty: runs/<scene>-<time>
  double trajectory_every = 0.1;  ///< [s]; 0: none
  bool tank_walls = false;        ///< in trajectory frames
  std::string contacts = "hull";
  std::string problems = "never";
  double checkpoint_every = 0;                      ///< [s]; 0: none
  std::optional<bool> bodies;                       ///< default: on up to 200 bodies
  std::optional<std::array<double, 2>> statistics;  ///< from, to [s]; default: end of the ramp and first ice, end
  std::optional<double> peak_filter;                ///< averaging time of filtered peaks [s]; default: by the length
};

/// An input file that the scene refers to.
struct InputFile {
  std::string source;  ///< absolute path
  std::string copy;    ///< what the scene as run calls it, relative to the run folder: inputs/ship/fluid.stl
  std::string sha256;  ///< in hexadecimal digits
};

struct Scene {
  std::string name = "scene";
  std::filesystem::path file;  ///< where it was read from
  TimeScene time;
  Vec3 gravity{0, 0, -9.81};
  std::uint64_t seed = 1;
  std::uint64_t twin = 0;  ///< 0: the scene itself; others start next to nothing aside
  ContactScene contact;
  std::optional<WaterScene> water;
  std::optional<HydroScene> hydro;
  std::optional<TankScene> tank;
  std::optional<VesselScene> vessel;
  std::optional<IceScene> ice;
  std::optional<FractureScene> fracture;
  std::vector<BodyScene> bodies;
  OutputScene output;
  std::vector<std::string> notes;  ///< what the reader wants said once, e.g. a default that fell back to a built model
  std::vector<std::string> derived;  ///< defaults that follow from the scene's scale, and why
  std::vector<Fault> warnings;       ///< valid values that can hardly be meant, with their places
  /// Where the first element of each path and its given attributes stand: "vessel/carriage", "vessel/carriage/@speed".
  /// A place is a fault without a message.
  std::map<std::string, Fault> places;
  std::vector<InputFile> inputs;  ///< in the order of the scene, each once
  std::string as_run;             ///< the XML with every default and override written out, and input files by `copy`
  std::string fingerprint;  ///< SHA-256 of it but for time/@end and what of <output> only concerns checkpoints and
                            ///< statistics: what a run's states depend on
};

/// A warning that is placed at `path` ("vessel/carriage/@speed"), or where that is not given at the nearest element
/// above it.
Fault warning_at(const Scene& scene, const std::string& path, const std::string& message);

}  // namespace nilas
