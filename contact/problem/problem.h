#pragma once
/// One step's contact problem: a value that holds all that a solver needs.
///
///   M v = f + H r,   u = H^T v + w,   u_hat = u + mu |u_T| n,   K* contains u_hat, perpendicular to r in K
///
/// Letters and ordering are those of FCLIB's global form, normal first: (N, T1, T2) per contact. The impulse r [N s]
/// acts on body B and -r on body A. The normal n points from A to B, so that u_N > 0 separates them. Sizes: nb blocks,
/// nv = sum of block sizes, nc contacts, 3 nc rows.
#include <cstdint>
#include <limits>
#include <vector>

#include "contact/problem/contact_coefficients.h"
#include "core/base/math.h"

namespace nilas::contact {

/// ContactCoefficients adds the law and, per contact, friction, force limit, compliance and key.
struct ContactProblem : ContactCoefficients {
  /// One contact row triple between two blocks; a block index of -1 is a prescribed or fixed side.
  struct Pair {
    int a = -1;  ///< block of body A
    int b = -1;  ///< block of body B
    bool operator==(const Pair&) const = default;
  };

  double h = 0;  ///< step [s]

  std::vector<int> block_offset{0};         ///< nb + 1: block k holds v[offset[k] .. offset[k+1])
  std::vector<std::size_t> mass_offset{0};  ///< nb + 1, into mass_data
  std::vector<double> mass_data;  ///< symmetric positive definite blocks, column-major; stiffness and damping of a
                                  ///< stiff block already folded in
  VecX f;                         ///< nv: momentum of the motion without contact, M v_free

  std::vector<Pair> pairs;  ///< nc
  std::vector<std::size_t> jacobian_offset{
      0};  ///< nc + 1, into jacobian_data: J_A (3 x n_a) then J_B (3 x n_b), row-major; u = J_A v_A + J_B v_B + w
  std::vector<double> jacobian_data;
  VecX w;  ///< 3 nc: prescribed motion, gap, restitution and stabilisation folded in [m/s]

  /// Rolling and spinning friction: the moment (S, R1, R2) about a contact's normal and tangents, divided by its
  /// lengths, is a row triple of its own (contact/law/moment_cone.h). Empty where no contact has one.
  struct Moment {
    int contact = -1;    ///< contact whose normal impulse bounds this moment, a lower index; -1 for a contact
    int moment = -1;     ///< moment of this contact, -1: none
    double rolling = 0;  ///< length by which R1 and R2 of a moment are divided, 0 without rolling friction [m]
    bool operator==(const Moment&) const = default;
  };
  std::vector<Moment> moments;  ///< empty or nc

  bool has_moments() const { return !moments.empty(); }
  bool is_moment(int c) const { return has_moments() && moments[c].contact >= 0; }
  /// Index of the moment of contact c, -1: none.
  int moment_of(int c) const { return has_moments() ? moments[c].moment : -1; }
  /// Returns the number of contacts, their moments not counted; num_contacts() counts moments too.
  int num_points() const;

  int num_blocks() const { return static_cast<int>(block_offset.size()) - 1; }
  int num_contacts() const { return static_cast<int>(pairs.size()); }
  int num_velocities() const { return block_offset.back(); }
  int block_size(int k) const { return block_offset[static_cast<std::size_t>(k) + 1] - block_offset[k]; }

  using ConstMatrix = Eigen::Map<const MatX>;
  using RowMajor = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
  using ConstJacobian = Eigen::Map<const RowMajor>;
  ConstMatrix mass(int k) const;          ///< n_k x n_k
  ConstJacobian jacobian_a(int c) const;  ///< 3 x n_a (3 x 0 when side A is prescribed)
  ConstJacobian jacobian_b(int c) const;

  /// Appends a mass block, returns its index. f gets as many zero rows.
  int add_block(const Eigen::Ref<const MatX>& mass);
  /// Appends a contact with defaults for mu (0), limit and compliance; returns its index. w gets three zero rows.
  int add_contact(int block_a, const Eigen::Ref<const MatX>& jacobian_a, int block_b,
                  const Eigen::Ref<const MatX>& jacobian_b, std::uint64_t key);
  /// Appends the moment of a contact between the same blocks: rows of u = (S, R1, R2), already times their lengths.
  /// Returns its index. Throws ContractError where the contact is itself a moment, or has one.
  int add_moment(int contact, const Eigen::Ref<const MatX>& jacobian_a, const Eigen::Ref<const MatX>& jacobian_b,
                 double rolling, std::uint64_t key);

  bool operator==(const ContactProblem&) const = default;
};

/// Throws ContractError naming the field when sizes, signs or finiteness are wrong, a mass is not symmetric within 1e-2
/// of its largest entry or not positive definite, a key occurs twice, or a contact and its moment do not name each
/// other.
void validate(const ContactProblem& problem);

/// W_aa = sum over sides of J M^-1 J^T per contact (3 x 3 each), the diagonal blocks of the Delassus operator [1/kg].
std::vector<Mat3> delassus_diagonal(const ContactProblem& problem);

/// v = M^-1 (f + H r).
VecX velocities(const ContactProblem& problem, const VecX& r);
/// u = H^T v + w.
VecX contact_velocities(const ContactProblem& problem, const VecX& v);

}  // namespace nilas::contact
