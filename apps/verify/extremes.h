#pragma once
/// Where the numerics hold: scenes at the edge of what can be asked, over solvers and integrators.
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/verify/verdicts.h"

namespace nilas {

/// holds: all limits kept. short_of_it: a limit is broken, and the run had said that its solver stopped short. stopped:
/// the run ended with a message. refused: the scene is not taken, which fails too. stated: a limit is broken as the
/// manual says it is. fails: a limit is broken and nothing was said.
enum class Hold { holds, short_of_it, stopped, refused, stated, fails };
const char* to_string(Hold hold);

/// One scene at one level with one solver and integrator.
struct Cell {
  std::string extreme, level;
  Model model;
  Hold hold = Hold::fails;
  double energy_won = 0;      ///< share of the scene's scale of energy
  double momentum_error = 0;  ///< largest of a step, share of its scale
  double penetration = 0;     ///< at the end, share of the body's size
  double drift = 0;           ///< of what should rest, share of the body's size, or of a kept quantity
  double residual = 0;        ///< largest law_map_m_s [m/s]
  long short_steps = 0;       ///< in which the solver missed its tolerance, and said so
  std::string message;
};

/// Names of the extremes, for messages and --case.
std::vector<std::string> extreme_names();
/// All cells of the extremes named (empty: all) in a fixed order. Throws InputError for an unknown name.
std::vector<Cell> run_extremes(const Selection& selection, int threads, const std::function<void(double)>& done);

std::string extremes_text(const std::vector<Cell>& cells);
nlohmann::ordered_json extremes_json(const std::vector<Cell>& cells);
std::string extremes_csv(const std::vector<Cell>& cells);
/// extremes.csv, extremes.png and extremes.svg. Throws FileError.
void write_extremes(const std::filesystem::path& folder, const std::vector<Cell>& cells);

}  // namespace nilas
