#pragma once
/// A frictional contact problem, and how well impulses solve it.
///
///   M v = f + H r,   u = H^T v + w,   u + mu |u_T| n in K*, perpendicular to r in K
///
/// K is the friction cone. Each contact has three rows: normal, then two tangents. The impulse r [N s] acts on body b
/// and -r on body a, and a positive normal velocity u separates them. Matrices are dense and row by row.
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "nilas/export.h"

namespace nilas {

class NILAS_API Problem {
 public:
  /// A problem without bodies and contacts, for add_body() and add_contact().
  Problem();
  /// A problem in its local form, u = W r + q. W: (3 nc) x (3 nc) [1/kg]; q: 3 nc [m/s]; mu: nc. Throws Error,
  /// which names the list that does not fit the others.
  static Problem local(std::span<const double> W, std::span<const double> q, std::span<const double> mu);
  /// Reads a file in FCLIB's format (HDF5). Throws Error.
  static Problem read(const std::filesystem::path& file);

  Problem(const Problem& other);
  Problem(Problem&& other) noexcept;
  Problem& operator=(const Problem& other);
  Problem& operator=(Problem&& other) noexcept;
  ~Problem();

  /// Adds a body with n velocities and returns its index. mass: n x n, symmetric and positive definite; momentum: n,
  /// that of the motion without contact, M v_free. Throws Error.
  int add_body(std::span<const double> mass, std::span<const double> momentum);
  /// Adds a contact between two bodies and returns its index. Body -1 does not move, and its jacobian is empty.
  /// jacobian_a, jacobian_b: 3 x n each, so that u = J_a v_a + J_b v_b + w; w: 3 [m/s]; mu: coefficient of friction.
  /// Throws Error.
  int add_contact(int body_a, std::span<const double> jacobian_a, int body_b, std::span<const double> jacobian_b,
                  std::span<const double> w, double mu);

  int num_contacts() const;
  int num_velocities() const;  ///< 0 in the local form
  bool is_local() const;
  std::vector<double> mu() const;  ///< nc
  /// The Delassus operator W = H^T M^-1 H, (3 nc) x (3 nc) [1/kg]. Throws Error above 3000 contacts.
  std::vector<double> delassus() const;
  std::vector<double> q() const;  ///< 3 nc: velocities at the contacts without impulses [m/s]
  /// Velocities at the contacts under the impulses r, 3 nc [m/s]. Throws Error where r has another length.
  std::vector<double> contact_velocities(std::span<const double> r) const;
  /// Velocities of the bodies under the impulses r; empty in the local form. Throws Error.
  std::vector<double> velocities(std::span<const double> r) const;
  std::vector<double> guess() const;     ///< first guess that a file gives, 3 nc [N s]; empty: none
  std::vector<double> solution() const;  ///< solution that a file gives, 3 nc [N s]; empty: none

  /// Writes the problem in FCLIB's format, and beside it the impulses as its solution, if there are any. Throws Error.
  void write(const std::filesystem::path& file, std::span<const double> impulses = {}) const;

  struct Content;
  const Content& content() const { return *content_; }  ///< for the library itself

 private:
  explicit Problem(std::unique_ptr<Content> content);
  friend class Simulation;
  std::unique_ptr<Content> content_;
};

/// The residuals of impulses, all independent of the solver. docs/theory/contact.md has the formulas.
struct Residuals {
  double law_map_m_s = 0;      ///< distance from the law asked for, on which every solver stops [m/s]
  double natural_map_m_s = 0;  ///< distance from exact Coulomb friction [m/s]
  double natural_map_rms_m_s = 0;
  double ccp_map_m_s = 0;           ///< distance from the convex cone [m/s]
  double penetration_rate_m_s = 0;  ///< fastest approach that is left [m/s]
  double complementarity_J = 0;
  double cone_violation_m_s = 0;
  double slip_angle_deg = 0;  ///< largest angle between friction and the reverse of the slip
  double creep_m_s = 0;       ///< slip of contacts that should stick [m/s]
  double bipotential_J = 0;
  double momentum_sqrtJ = 0;
};

}  // namespace nilas
