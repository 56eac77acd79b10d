#pragma once
/// MoorDyn 2 (https://github.com/FloatingArrayDesign/MoorDyn, BSD-3-Clause), found when the program runs.
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/math.h"

namespace nilas::vessel {

/// The functions of MoorDyn's C interface (MoorDyn2.h, Point.h, Line.h of version 2) that are called here. Handles are
/// opaque; functions return 0 where they succeed.
struct MoordynApi {
  std::string name;               ///< file of the library, for messages
  std::shared_ptr<void> library;  ///< keeps it loaded
  void* (*create)(const char* file) = nullptr;
  int (*close)(void* system) = nullptr;
  int (*set_verbosity)(void* system, int level) = nullptr;
  int (*coupled_dof)(void* system, unsigned* n) = nullptr;
  int (*init)(void* system, const double* x, const double* v) = nullptr;
  int (*step)(void* system, const double* x, const double* v, double* f, double* t, double* dt) = nullptr;
  int (*number_of_points)(void* system, unsigned* n) = nullptr;
  void* (*point)(void* system, unsigned number) = nullptr;  ///< numbers count from 1
  int (*point_type)(void* point, int* type) = nullptr;      ///< -1: coupled
  int (*point_place)(void* point, double* place) = nullptr;
  int (*point_force)(void* point, double* force) = nullptr;
  int (*number_of_lines)(void* system, unsigned* n) = nullptr;
  void* (*line)(void* system, unsigned number) = nullptr;
  int (*line_id)(void* line, int* id) = nullptr;
  int (*greatest_tension)(void* line, double* tension) = nullptr;
  int (*serialize)(void* system, std::size_t* size, std::uint64_t* data) = nullptr;
  int (*deserialize)(void* system, const std::uint64_t* data) = nullptr;
};

/// Loads the library that the environment variable NILAS_MOORDYN names, else libmoordyn.so.2 where the dynamic loader
/// finds it. Throws InputError where there is none, or one without these functions.
MoordynApi load_moordyn();

/// A mooring in MoorDyn whose coupled points follow the hull. Heights are those above still water.
class MoordynSystem {
 public:
  /// Reads MoorDyn's input file. Throws InputError, with the file's absolute path, where MoorDyn cannot read it, where
  /// it has no coupled point, or where it couples bodies or rods.
  MoordynSystem(const MoordynApi& api, const std::string& file);
  /// Places of the coupled points in the file, in their order [m].
  const std::vector<Vec3>& points() const { return points_; }
  /// Brings the lines to rest with the coupled points at these places and returns the forces on them [N]. Throws
  /// InputError where MoorDyn fails.
  std::vector<Vec3> start(const std::vector<Vec3>& places);
  /// Moves the coupled points from one place to another within h from t on, and returns the forces on them at the end.
  /// Throws SimulationError, with the time, where MoorDyn fails; with the line too, where a tension is not finite.
  std::vector<Vec3> advance(const std::vector<Vec3>& from, const std::vector<Vec3>& to, double t, double h);
  /// Ids of the lines as in the file, and the greatest tension in each [N].
  const std::vector<int>& lines() const { return ids_; }
  std::vector<double> tensions() const;

  /// The state as MoorDyn writes it.
  std::vector<std::int64_t> state() const;
  void restore(const std::vector<std::int64_t>& state);

 private:
  MoordynApi api_;
  std::string file_;
  std::unique_ptr<void, int (*)(void*)> system_;
  std::vector<void*> coupled_, line_handles_;
  std::vector<Vec3> points_;
  std::vector<int> ids_;
};

}  // namespace nilas::vessel
