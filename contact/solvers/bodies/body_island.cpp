#include "contact/solvers/bodies/body_island.h"

#include <algorithm>

#include "contact/problem/row_of.h"
#include "contact/solvers/linear/wide_clones.h"

namespace nilas::solvers {

namespace {

/// First node and coordinates of a block.
struct Place {
  int first_node = 0, size = 0;
  int num_nodes() const { return (size + k_node_size - 1) / k_node_size; }
};

std::vector<Place> place_blocks(const contact::ContactProblem& problem) {
  std::vector<Place> places;
  int next = 0;
  for (int k = 0; k < problem.num_blocks(); ++k) {
    places.push_back({next, problem.block_size(k)});
    next += places.back().num_nodes();
  }
  return places;
}

/// Adds the scaled rows of one side to the sides of its contact from `first` on.
void add_side(const contact::MassInverse& masses, int block, const Place& place,
              const contact::ContactProblem::ConstJacobian& jacobian, std::size_t first, std::vector<NodeSide>& sides) {
  std::vector<double> scaled(static_cast<std::size_t>(place.size));
  for (int node = 0; node < place.num_nodes(); ++node) {
    const int wanted = place.first_node + node;
    const auto found = std::find_if(sides.begin() + static_cast<std::ptrdiff_t>(first), sides.end(),
                                    [&](const NodeSide& side) { return side.node == wanted; });
    if (found == sides.end()) sides.push_back({wanted, {}});
  }
  for (int i = 0; i < 3; ++i) {
    masses.apply_root(block, jacobian.data() + i * jacobian.cols(), scaled.data());
    for (std::size_t s = first; s < sides.size(); ++s) {
      const int from = k_node_size * (sides[s].node - place.first_node);
      for (int k = 0; k < k_node_size; ++k)
        if (from >= 0 && from + k < place.size) sides[s].rows.row[i][k] += scaled[from + k];
    }
  }
}

}  // namespace

ContactVectors by_component(const VecX& r) {
  ContactVectors out(static_cast<std::size_t>(r.size() / 3));
  for (std::size_t c = 0; c < out.row[0].size(); ++c) out.set(c, r.segment<3>(contact::row_of(c)));
  return out;
}

VecX by_contact(const ContactVectors& r) {
  VecX out(contact::row_of(r.row[0].size()));
  for (std::size_t c = 0; c < r.row[0].size(); ++c) out.segment<3>(contact::row_of(c)) = r.at(c);
  return out;
}

BodyIsland::BodyIsland(const contact::PreparedProblem& island) : w_(by_component(island.problem().w)) {
  const contact::ContactProblem& problem = island.problem();
  const auto places = place_blocks(problem);
  for (int k = 0; k < problem.num_blocks(); ++k) {
    std::vector<double> scaled(static_cast<std::size_t>(places[k].size));
    island.masses().apply_root(k, problem.f.data() + problem.block_offset[k], scaled.data());
    for (int node = 0; node < places[k].num_nodes(); ++node) {
      free_.emplace_back();
      for (int i = 0; i < k_node_size && k_node_size * node + i < places[k].size; ++i)
        free_.back().value[i] = scaled[k_node_size * node + i];
    }
  }
  num_nodes_ = static_cast<int>(free_.size());
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    const std::size_t first = sides_.size();
    if (pair.a >= 0) add_side(island.masses(), pair.a, places[pair.a], problem.jacobian_a(c), first, sides_);
    if (pair.b >= 0) add_side(island.masses(), pair.b, places[pair.b], problem.jacobian_b(c), first, sides_);
    side_start_.push_back(sides_.size());
  }
}

namespace {

/// The sides of all contacts and where those of each begin, as the loops below read them.
struct SideLists {
  const NodeSide* side;
  const std::size_t* start;
  int num_contacts;
};

NILAS_WIDE_CLONES void add_to_nodes(const SideLists& sides, const double* n, const double* t1, const double* t2,
                                    NodeNumbers* z) {
  for (int c = 0; c < sides.num_contacts; ++c)
    for (std::size_t s = sides.start[c]; s < sides.start[c + 1]; ++s) {
      const auto& row = sides.side[s].rows.row;
      double* const to = z[sides.side[s].node].value;
      for (int k = 0; k < k_node_width; ++k) to[k] += row[0][k] * n[c] + row[1][k] * t1[c] + row[2][k] * t2[c];
    }
}

NILAS_WIDE_CLONES void velocities_of_nodes(const SideLists& sides, const NodeNumbers* z, double* n, double* t1,
                                           double* t2) {
  constexpr int half = k_node_width / 2;
  for (int c = 0; c < sides.num_contacts; ++c) {
    double sum[3][half] = {};
    for (std::size_t s = sides.start[c]; s < sides.start[c + 1]; ++s) {
      const auto& row = sides.side[s].rows.row;
      const double* const at = z[sides.side[s].node].value;
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < half; ++k) sum[i][k] += row[i][k] * at[k] + row[i][half + k] * at[half + k];
    }
    n[c] = (sum[0][0] + sum[0][1]) + (sum[0][2] + sum[0][3]);
    t1[c] = (sum[1][0] + sum[1][1]) + (sum[1][2] + sum[1][3]);
    t2[c] = (sum[2][0] + sum[2][1]) + (sum[2][2] + sum[2][3]);
  }
}

}  // namespace

void BodyIsland::add_impulses(const ContactVectors& r, NodeVector& z) const {
  add_to_nodes({sides_.data(), side_start_.data(), num_contacts()}, r.row[0].data(), r.row[1].data(), r.row[2].data(),
               z.data());
}

void BodyIsland::relative_velocities(const NodeVector& z, ContactVectors& u) const {
  velocities_of_nodes({sides_.data(), side_start_.data(), num_contacts()}, z.data(), u.row[0].data(), u.row[1].data(),
                      u.row[2].data());
}

bool has_roots(const contact::PreparedProblem& island) {
  for (int k = 0; k < island.problem().num_blocks(); ++k)
    if (!island.masses().has_root(k)) return false;
  return island.masses().first_bad_block() < 0;
}

}  // namespace nilas::solvers
