#pragma once
/// The open-water force: the force of the same tow without ice, which a model basin deducts from the force in ice.
#include <filesystem>
#include <optional>

#include "core/output/loads/ice_load.h"
#include "core/output/loads/run_statistics.h"
#include "core/scene/scene.h"

namespace nilas::commands {

class OpenWater {
 public:
  /// Throws InputError for a scene that tows no vessel.
  static void demand_towed(const scene::Scene& scene);
  /// Tows the scene's vessel without its ice, from start to end. Throws as demand_towed() and Simulation do.
  static OpenWater towed(const scene::Scene& scene, int threads);
  /// Reads the force from the folder of a run without ice. Throws FileError, and InputError if it is no such run.
  static OpenWater stored(const std::filesystem::path& run);

  /// Fills the open-water force of a tow. Returns an empty text, or why nothing is deducted: the carriage does not
  /// move, or the stored run was towed at another speed or with another vessel.
  std::string deduct_from(output::IceLoad& load, const geometry::MassProperties& vessel) const;

 private:
  std::optional<output::RunStatistics> run_;
  double mean_ = 0, speed_ = 0;  ///< mean force [N] and speed [m/s] of a stored run
  struct {
    double mass = 0, pitch_inertia = 0;  ///< [kg], [kg m^2]
  } vessel_;                             ///< the vessel of a stored run
  std::string source_;
};

}  // namespace nilas::commands
