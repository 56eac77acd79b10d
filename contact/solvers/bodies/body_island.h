#pragma once
/// One island of a contact problem in mass-scaled coordinates of its bodies: no Delassus operator is formed.
///
///   M = L L^T per body,   z = L^T v,   z = z_free + sum_c J_c^T r_c,   u_c = J_c z + w_c,   J_c <- J_c L^-T
///
/// Bodies become nodes of six coordinates each. A body of fewer is filled up with coordinates that nothing moves, one
/// of more, such as a vessel with its carriage, becomes several nodes. So a contact has a side on one node or on
/// several.
#include <array>
#include <span>
#include <vector>

#include "contact/problem/prepared_problem.h"
#include "contact/solvers/bodies/node_block.h"

namespace nilas::solvers {

/// Three numbers (N, T1, T2) per contact, stored by component, so that loops over contacts fill registers.
struct ContactVectors {
  std::array<std::vector<double>, 3> row;

  ContactVectors() = default;
  explicit ContactVectors(std::size_t num_contacts) { resize(num_contacts); }
  void resize(std::size_t num_contacts) {
    for (auto& one : row) one.assign(num_contacts, 0.0);
  }
  Vec3 at(std::size_t c) const { return {row[0][c], row[1][c], row[2][c]}; }
  void set(std::size_t c, const Vec3& x) {
    for (std::size_t i = 0; i < 3; ++i) row[i][c] = x[static_cast<Eigen::Index>(i)];
  }
};

ContactVectors by_component(const VecX& r);
VecX by_contact(const ContactVectors& r);

/// One side of a contact, as its node lists it.
struct NodeEntry {
  int contact = 0;
  int side = 0;
};

class BodyIsland {
 public:
  /// `island`: a problem of one island without moments, whose masses all have a root (has_roots). `threads`: of all
  /// work on this island; the bits do not depend on them.
  explicit BodyIsland(const contact::PreparedProblem& island, int threads = 1);

  int threads() const { return threads_; }

  int num_contacts() const { return static_cast<int>(side_start_.size()) - 1; }
  int num_nodes() const { return num_nodes_; }
  /// Sides are numbered in the order of contacts. Those of contact c end where those of c + 1 begin.
  int first_side(int c) const { return side_start_[static_cast<std::size_t>(c)]; }
  int node(int side) const { return nodes_[static_cast<std::size_t>(side)]; }
  /// J of a contact on the node of one of its sides.
  const NodeRows& rows(int side) const { return rows_[static_cast<std::size_t>(side)]; }
  /// The sides on a node, in the order of contacts.
  std::span<const NodeEntry> entries(int node) const {
    return std::span(entries_).subspan(entry_start_[node], entry_start_[node + 1] - entry_start_[node]);
  }
  const NodeVector& free_motion() const { return free_; }  ///< z_free
  const ContactVectors& prescribed() const { return w_; }  ///< w

  /// z += sum J^T r.
  void add_impulses(const ContactVectors& r, NodeVector& z) const;
  /// u = J z.
  void relative_velocities(const NodeVector& z, ContactVectors& u) const;
  /// The same of the contacts [first, last), by the calling thread.
  void relative_velocities(const NodeVector& z, ContactVectors& u, std::size_t first, std::size_t last) const;

 private:
  void list_entries();

  int threads_ = 1;
  int num_nodes_ = 0;
  std::vector<int> side_start_{0};
  std::vector<int> nodes_;      ///< of each side
  std::vector<NodeRows> rows_;  ///< of each side
  std::vector<std::size_t> entry_start_;
  std::vector<NodeEntry> entries_;
  std::vector<int> chunk_start_;  ///< first nodes of chunks of about the same number of entries
  NodeVector free_;
  ContactVectors w_;
};

/// Whether all masses of a problem are symmetric to rounding and positive definite, as BodyIsland needs them.
bool has_roots(const contact::PreparedProblem& island);

}  // namespace nilas::solvers
