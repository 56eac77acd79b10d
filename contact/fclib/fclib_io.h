#pragma once
/// Frictional contact problems in FCLIB format (HDF5), three-dimensional, in local or global form.
///
///   /fclib_local   spacedim, W, vectors/{q,mu}        u = W r + q
///   /fclib_global  spacedim, M, H, vectors/{f,w,mu}   M v = f + H r,  u = H^T v + w
///   /fclib_global_rolling   the same with five rows (N, T1, T2, R1, R2) per contact, and vectors/mu_r [m]
///
/// Each of these groups also has info/{title,description,math_info}. A file holds one of them, and beside it
/// /solution/r and /guesses/1/r where it has impulses. Those that are all zero are placeholders and count as absent.
/// Solutions are written with their velocities: /solution/u, and /solution/v in the global forms.
///
/// FCLIB has no place for a coefficient of static friction, a force limit and compliances. They lie in
/// vectors/{mu_static,force_limit,compliance,tangential_compliance}. Such a list is left out where all its values are
/// the defaults, which are mu, infinity and 0.
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/problem/local_problem.h"
#include "contact/solvers/solver.h"

namespace nilas::contact {

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

/// Writes a problem with its guess where it has one, and a solution where one is given. Throws FileError, InputError
/// for spinning friction, which FCLIB has no row for.
void write_fclib(const std::filesystem::path& path, const FclibProblem& problem, const ContactSolution* solution);
void write_fclib(const std::filesystem::path& path, const LocalProblem& problem, const ContactSolution* solution);
void write_fclib(const std::filesystem::path& path, const ContactProblem& problem, const ContactSolution* solution);

}  // namespace nilas::contact
