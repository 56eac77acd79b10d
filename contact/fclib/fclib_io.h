#pragma once
/// Data that FCLIB does not define lie in vectors/{mu_static,force_limit,compliance}; a list of defaults is absent.
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/problem/local_problem.h"
#include "contact/solvers/solver.h"

namespace nilas {

struct FclibProblem {
  std::variant<LocalProblem, ContactProblem> problem;
  std::string title, description;
  double asymmetry = 0;  ///< asymmetry of W (local) or M (global): largest |A_ij - A_ji| over the largest |A_ij|
  std::vector<int> dof_of_file;  ///< row of M in the file for each velocity of the problem; empty for the local form
  std::optional<VecX> guess;     ///< 3 nc impulses
  std::optional<VecX> solution;  ///< 3 nc impulses

  int num_contacts() const;
  int num_velocities() const;  ///< 0 for the local form
};

/// Throws FileError where the file cannot be opened, InputError naming file and dataset where its content is wrong or
/// not supported: two dimensions, bilateral constraints, rolling friction in the local form, a contact where nothing
/// can move, W or M with an asymmetry above 1e-2.
FclibProblem read_fclib(const std::filesystem::path& path);

/// Writes a problem, and a solution where one is given. Throws FileError, InputError for spinning friction, which FCLIB
/// has no row for.
void write_fclib(const std::filesystem::path& path, const FclibProblem& problem, const ContactSolution* solution);
void write_fclib(const std::filesystem::path& path, const LocalProblem& problem, const ContactSolution* solution);
void write_fclib(const std::filesystem::path& path, const ContactProblem& problem, const ContactSolution* solution);

}  // namespace nilas
