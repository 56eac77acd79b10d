#pragma once
/// trajectory.pvd and the files of trajectory/: the run over time in named parts, for ParaView 5.11 and later.
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/file/flush.h"
#include "core/output/file/output_file.h"
#include "core/output/tables/contact_rows.h"
#include "core/output/vtk/body_surface.h"
#include "core/output/vtk/vtp_frame.h"
#include "core/scene/scene.h"

namespace nilas::output {

/// Damage of the floe with this id.
using FloeDamage = std::function<double(std::int64_t)>;

/// Data of a step that its frame shows in addition to the bodies.
struct ShownStep {
  std::vector<ContactRow> contacts;
  double h = 1;       ///< length of the step [s]
  FloeDamage damage;  ///< empty: no floe is damaged
};

/// The trajectory with its parts: ice floes, vessel, bodies, contact forces, water surface, and tank walls where the
/// scene asks for them. Planes have no surface and are left out. The list of frames is closed after every frame.
class Trajectory {
 public:
  /// Opens the list of frames. `has_forces`: the run stores contacts. `keep`: as in OutputFile, for the list. Throws
  /// FileError, InputError.
  Trajectory(const std::filesystem::path& run_folder, const scene::Scene& scene, bool has_forces,
             std::optional<std::int64_t> keep = {});
  /// Writes the bodies at time t [s] and the data of the step as trajectory/step-<step>-<part>.vtp, and lists them.
  /// Fixed things are written at step 0. Throws FileError.
  void frame(double t, long step, const bodies::Bodies& bodies, const ShownStep& shown = {});
  /// Returns when all frames are on the disk. Throws FileError.
  void sync() { unflushed_.flush(); }
  void finish() { list_.close(); }
  const OutputFile& list() const { return list_; }

 private:
  /// A part of the list; `stem` ends the names of its files.
  struct Part {
    const char *name, *stem;
    bodies::BodyKind kind;
  };

  void write(const std::string& name, const std::string& document);
  void follow_shapes(const bodies::Bodies& bodies);
  const std::string& surfaces_of(bodies::BodyKind kind, const bodies::Bodies& bodies, const FloeDamage& damage);
  void write_what_stays(const bodies::Bodies& bodies);
  std::string water_document(const bodies::Bodies& bodies) const;

  std::filesystem::path folder_;
  std::vector<Part> moving_;
  bool has_forces_, has_walls_, has_damage_;
  std::optional<double> water_level_;  ///< [m]
  std::optional<scene::TankScene> tank_;
  UnflushedFiles unflushed_;
  OutputFile list_;
  std::vector<std::shared_ptr<const geometry::Shape>> shapes_;  ///< shapes of the bodies in the newest frame
  std::vector<PolygonSurface> surfaces_;                        ///< one per shape
  VtpFrame frame_;
};

}  // namespace nilas::output
