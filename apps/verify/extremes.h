#pragma once
/// Scenes with extreme values, run with every solver and integrator, and whether each run keeps the limits.
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas::verify {

/// The verdict on a run.
/// holds: It keeps all limits.
/// short_of_it: It breaks a limit, and it reported that its solver missed the tolerance.
/// stopped: It ended early with an error message.
/// refused: The scene was refused with an error message, which counts as a failure.
/// stated: It breaks a limit, as docs/theory/dynamics.md states.
/// fails: It breaks a limit and reported nothing.
enum class Hold { holds, short_of_it, stopped, refused, stated, fails };
const char* to_string(Hold hold);

/// The result of one extreme at one level with one solver and integrator.
struct Cell {
  std::string extreme, level;
  Model model;
  Hold hold = Hold::fails;
  double energy_won = 0;      ///< largest energy gained since the start, over the scene's scale of energy
  double momentum_error = 0;  ///< largest momentum imbalance of a step over the largest momentum scale
  double penetration = 0;     ///< largest penetration, or that at the end, over the body's size
  double drift = 0;           ///< largest value of what should stay zero [m, m/s, rad/s or 1]
  double residual = 0;        ///< largest law_map_m_s [m/s]
  long short_steps = 0;       ///< number of steps in which the solver reported that it missed its tolerance
  std::string message;
};

/// Returns the names of the extremes, as --case takes them.
std::vector<std::string> extreme_names();
/// Runs the selected extremes (none named: all) and returns their cells in a fixed order. `done` is called with the
/// share of the cells that has begun. Throws InputError for an unknown name, or where nothing is left to run.
std::vector<Cell> run_extremes(const Selection& selection, int threads, const std::function<void(double)>& done);

std::string extremes_text(const std::vector<Cell>& cells);
nlohmann::ordered_json extremes_json(const std::vector<Cell>& cells);
std::string extremes_csv(const std::vector<Cell>& cells);
/// Writes extremes.csv, extremes.png and extremes.svg. Throws FileError.
void write_extremes(const std::filesystem::path& folder, const std::vector<Cell>& cells);

}  // namespace nilas::verify
