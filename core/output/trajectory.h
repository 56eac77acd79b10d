#pragma once
/// trajectory.pvd and trajectory/step-*.vtp: the surfaces of all bodies over time, for ParaView 5.11 and later.
#include <filesystem>
#include <memory>
#include <vector>

#include "core/bodies/bodies.h"
#include "core/output/body_surface.h"
#include "core/output/output_file.h"
#include "core/output/vtp_frame.h"

namespace nilas {

/// Planes have no surface and are left out. The list of frames is closed after every frame.
class Trajectory {
 public:
  /// `keep`: as of OutputFile, for the list. Throws FileError, InputError.
  explicit Trajectory(const std::filesystem::path& run_folder, std::optional<std::int64_t> keep = {});
  /// Writes the bodies at time t [s] as trajectory/step-<step>.vtp, then lists it. Throws FileError.
  void frame(double t, long step, const Bodies& bodies);
  void finish() { list_.close(); }
  const OutputFile& list() const { return list_; }

 private:
  void follow_shapes(const Bodies& bodies);

  std::filesystem::path folder_;
  OutputFile list_;
  std::vector<std::shared_ptr<const Shape>> shapes_;  ///< of the bodies in the newest frame
  std::vector<PolygonSurface> surfaces_;              ///< one per shape
  VtpFrame frame_;
};

}  // namespace nilas
