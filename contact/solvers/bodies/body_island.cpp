#include "contact/solvers/bodies/body_island.h"

#include <algorithm>

#include "contact/problem/row_of.h"
#include "contact/solvers/bodies/node_products.h"
#include "contact/solvers/linear/wide_clones.h"
#include "core/base/parallel.h"

namespace nilas::solvers {

namespace {

/// Entries of nodes that one thread adds up in turn.
constexpr std::size_t k_entries_per_chunk = 256;

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

/// Adds the scaled rows of one body to the sides of its contact, which begin at `first`. `scaled`: room.
void add_side(const contact::MassInverse& masses, int block, const Place& place,
              const contact::ContactProblem::ConstJacobian& jacobian, std::size_t first, std::vector<double>& scaled,
              std::vector<int>& nodes, std::vector<NodeRows>& rows) {
  scaled.resize(static_cast<std::size_t>(place.size));
  for (int node = place.first_node; node < place.first_node + place.num_nodes(); ++node)
    if (std::find(nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end(), node) == nodes.end())
      nodes.push_back(node);
  rows.resize(nodes.size());
  for (int i = 0; i < 3; ++i) {
    masses.apply_root(block, jacobian.data() + i * jacobian.cols(), scaled.data());
    for (std::size_t s = first; s < nodes.size(); ++s) {
      const int from = k_node_size * (nodes[s] - place.first_node);
      for (int k = 0; k < k_node_size; ++k)
        if (from >= 0 && from + k < place.size) rows[s].row[i][k] += scaled[from + k];
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

BodyIsland::BodyIsland(const contact::PreparedProblem& island, int threads)
    : threads_(threads), w_(by_component(island.problem().w)) {
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
  const std::size_t usual_sides = 2 * problem.pairs.size();
  side_start_.reserve(problem.pairs.size() + 1);
  nodes_.reserve(usual_sides);
  rows_.reserve(usual_sides);
  std::vector<double> room;
  for (int c = 0; c < problem.num_contacts(); ++c) {
    const auto& pair = problem.pairs[c];
    const std::size_t first = nodes_.size();
    if (pair.a >= 0)
      add_side(island.masses(), pair.a, places[pair.a], problem.jacobian_a(c), first, room, nodes_, rows_);
    if (pair.b >= 0)
      add_side(island.masses(), pair.b, places[pair.b], problem.jacobian_b(c), first, room, nodes_, rows_);
    side_start_.push_back(static_cast<int>(nodes_.size()));
  }
  list_entries();
}

void BodyIsland::list_entries() {
  entry_start_.assign(static_cast<std::size_t>(num_nodes_) + 1, 0);
  for (const int node : nodes_) ++entry_start_[node + 1];
  for (int k = 0; k < num_nodes_; ++k) entry_start_[k + 1] += entry_start_[k];
  std::vector<std::size_t> next(entry_start_.begin(), entry_start_.end() - 1);
  entries_.resize(nodes_.size());
  for (int c = 0; c < num_contacts(); ++c)
    for (int s = first_side(c); s < first_side(c + 1); ++s) entries_[next[nodes_[s]]++] = {c, s};
  chunk_start_.assign(1, 0);
  for (int k = 1; k <= num_nodes_; ++k)
    if (k == num_nodes_ || entry_start_[k] - entry_start_[chunk_start_.back()] >= k_entries_per_chunk)
      chunk_start_.push_back(k);
}

namespace {

/// The sides of all contacts and where those of each begin, as a loop below reads them.
struct SideLists {
  const NodeRows* rows;
  const int *node, *start;
};

/// Adds to the nodes [first, last).
NILAS_WIDE_CLONES void add_to_nodes(const NodeRows* rows, const NodeEntry* entry, const std::size_t* start, int first,
                                    int last, const double* n, const double* t1, const double* t2, NodeNumbers* z) {
  for (int node = first; node < last; ++node) {
    NodeNumbers sum = z[node];
    for (std::size_t e = start[node]; e < start[node + 1]; ++e) {
      const auto& row = rows[entry[e].side].row;
      const int c = entry[e].contact;
      for (int k = 0; k < k_node_width; ++k) sum.value[k] += row[0][k] * n[c] + row[1][k] * t1[c] + row[2][k] * t2[c];
    }
    z[node] = sum;
  }
}

/// Of the contacts [first, last).
NILAS_WIDE_CLONES void velocities_of_nodes(const SideLists& sides, std::size_t first, std::size_t last,
                                           const NodeNumbers* z, double* n, double* t1, double* t2) {
  const auto sum_of = [](const FourNumbers& x) { return (x[0] + x[1]) + (x[2] + x[3]); };
  for (std::size_t c = first; c < last; ++c) {
    FourNumbers sum[3] = {};
    for (int s = sides.start[c]; s < sides.start[c + 1]; ++s) {
      const auto* const at = reinterpret_cast<const FourNumbers*>(z[sides.node[s]].value);
      for (int i = 0; i < 3; ++i) {
        const auto* const row = reinterpret_cast<const FourNumbers*>(sides.rows[s].row[i]);
        sum[i] += row[0] * at[0] + row[1] * at[1];
      }
    }
    n[c] = sum_of(sum[0]);
    t1[c] = sum_of(sum[1]);
    t2[c] = sum_of(sum[2]);
  }
}

}  // namespace

void BodyIsland::add_impulses(const ContactVectors& r, NodeVector& z) const {
  parallel_for(static_cast<std::ptrdiff_t>(chunk_start_.size()) - 1, threads_, [&](std::ptrdiff_t k) {
    add_to_nodes(rows_.data(), entries_.data(), entry_start_.data(), chunk_start_[k], chunk_start_[k + 1],
                 r.row[0].data(), r.row[1].data(), r.row[2].data(), z.data());
  });
}

void BodyIsland::relative_velocities(const NodeVector& z, ContactVectors& u) const {
  parallel_chunks(num_contacts(), k_chunk, threads_, [&](std::ptrdiff_t, std::ptrdiff_t first, std::ptrdiff_t last) {
    relative_velocities(z, u, static_cast<std::size_t>(first), static_cast<std::size_t>(last));
  });
}

void BodyIsland::relative_velocities(const NodeVector& z, ContactVectors& u, std::size_t first,
                                     std::size_t last) const {
  velocities_of_nodes({rows_.data(), nodes_.data(), side_start_.data()}, first, last, z.data(), u.row[0].data(),
                      u.row[1].data(), u.row[2].data());
}

bool has_roots(const contact::PreparedProblem& island) {
  for (int k = 0; k < island.problem().num_blocks(); ++k)
    if (!island.masses().has_root(k)) return false;
  return island.masses().first_bad_block() < 0;
}

}  // namespace nilas::solvers
