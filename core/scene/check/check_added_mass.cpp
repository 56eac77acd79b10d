#include <Eigen/Eigenvalues>

#include "core/choices/water_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

constexpr std::size_t k_matrix_diagonal = 6, k_matrix_entries = 36;

static void check_added_matrix(const SceneElement& added, const std::vector<double>& numbers,
                               std::vector<Fault>& faults) {
  const auto refuse = [&](const std::string& message) { faults.push_back(fault_of(added, "matrix", message)); };
  if (numbers.size() != k_matrix_diagonal && numbers.size() != k_matrix_entries)
    return refuse("found " + std::to_string(numbers.size()) +
                  " numbers; allowed: 6 for the diagonal, or 36 row by row");
  Mat6 matrix = Mat6::Zero();
  if (numbers.size() == k_matrix_diagonal)
    matrix.diagonal() = Eigen::Map<const Vec6>(numbers.data());
  else
    matrix = Eigen::Map<const Mat6>(numbers.data());
  if (matrix != matrix.transpose())
    return refuse("the matrix of added mass is not symmetric; allowed: equal entries on both sides of the diagonal");
  constexpr double k_rounding = 1e-12;  // of the largest eigenvalue
  const Vec6 values = Eigen::SelfAdjointEigenSolver<Mat6>(matrix, Eigen::EigenvaluesOnly).eigenvalues();
  if (values[0] < -k_rounding * std::abs(values[5]))
    refuse("the matrix of added mass has a negative eigenvalue, " + format_number(values[0]) +
           "; allowed: a matrix that gives no motion a negative energy");
}

void check_added_mass(const SceneElement& root, std::vector<Fault>& faults) {
  const SceneElement* hydro = child_of(root, "hydro");
  const SceneElement* added = hydro ? child_of(*hydro, "added_mass") : nullptr;
  if (!added) return;
  const SceneElement* water = child_of(root, "water");
  const SceneElement* current = water ? child_of(*water, "current") : nullptr;
  for (const char* table : {"profile", "series"})
    if (current && attribute_of(*current, table))
      faults.push_back(fault_of(*added, "added mass refers to one velocity of the water, but the current has a " +
                                            std::string(table) + "; allowed: <current velocity> alone"));
  const auto vessel = choice_of<VesselAddedMass>(*added, "vessel");
  if (!vessel || *vessel == VesselAddedMass::none) return;
  if (!is_named(root, "vessel"))
    faults.push_back(fault_of(*added, "vessel", "the scene has no vessel; allowed: none, or a scene with <vessel>"));
  if (*vessel == VesselAddedMass::database && !is_named(*hydro, "database"))
    faults.push_back(fault_of(*added, "vessel", "the scene names no database; allowed: with <hydro><database>"));
  if (*vessel != VesselAddedMass::matrix) return;
  if (!attribute_of(*added, "matrix"))
    faults.push_back(
        fault_of(*added, "vessel", "found 'matrix' without the attribute matrix; allowed: with 6 or 36 numbers"));
  else if (const auto numbers = numbers_of(*added, "matrix"))
    check_added_matrix(*added, *numbers, faults);
}

}  // namespace nilas::scene
