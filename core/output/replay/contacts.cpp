#include "core/output/replay/contacts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/measure/impulse_residual.h"
#include "core/base/union_find.h"

namespace nilas::output::replay {

namespace {

/// The place of the body with this id, -1: it has broken since. Ids ascend with the places.
int place_of(std::int64_t id, const bodies::Bodies& bodies) {
  const auto found = std::lower_bound(bodies.id.begin(), bodies.id.end(), id);
  return found != bodies.id.end() && *found == id ? static_cast<int>(found - bodies.id.begin()) : -1;
}

/// The integrator "reference" solves for accelerations, and keeps no impulses of a step.
bool has_impulses(const contact::SolvedProblem& solved) {
  const std::size_t n = solved.points.size();
  const auto rows = 3 * static_cast<Eigen::Index>(n);
  return solved.impulses.size() == n && solved.touching.size() == n && solved.problem.mu.size() >= n &&
         solved.solution.r.size() >= rows && solved.solution.u.size() >= rows;
}

/// The contacts of a step, gathered over its substeps.
class Gathering {
 public:
  Gathering(const bodies::Bodies& bodies, const ContactChoice& choice, double h)
      : bodies_(bodies), choice_(choice), h_(h), joined_(bodies.id.size()), residual_(bodies.id.size(), 0) {}

  void add(const contact::SolvedProblem& solved) {
    if (!has_impulses(solved)) return;
    const std::vector<ContactRow> rows = contact_rows(solved, choice_.loaded, true);
    iterations_ += solved.solution.iterations;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const int first = place_of(rows[i].body, bodies_), second = place_of(rows[i].other, bodies_);
      add_row(rows[i], first, second);
      join(first, second, residual_of(solved, i));
    }
  }

  FrameContacts result() {
    for (auto& [pair, sum] : sums_) {
      if (sum.weight > 0) sum.contact.p_G /= sum.weight;
      const double size = sum.contact.n.norm();
      if (size > 0) sum.contact.n /= size;
      list_.contacts.push_back(sum.contact);
    }
    number_islands();
    return std::move(list_);
  }

 private:
  /// Contacts of one pair of free bodies, weighted with their forces.
  struct Sum {
    FrameContact contact;
    double weight = 0;
  };

  bool is_loaded(const ContactRow& row, int first) const {
    const auto structure = [&](std::int64_t id) {
      return std::binary_search(choice_.loaded.structures.begin(), choice_.loaded.structures.end(), id);
    };
    return choice_.loaded.is_of_vessel(first) || structure(row.body) || structure(row.other);
  }

  void add_row(const ContactRow& row, int first, int second) {
    if (first < 0) return;
    if (second < 0) second = first;
    const bool loaded = is_loaded(row, first);
    FrameContact contact{.first = first,
                         .second = second,
                         .status = row.status,
                         .exact = loaded || choice_.of_all_bodies,
                         .stored = choice_.in_table && (loaded || choice_.of_all_bodies),
                         .p_G = row.p_G,
                         .n = row.n,
                         .force = row.impulse / h_};
    if (contact.exact) {
      list_.contacts.push_back(contact);
      return;
    }
    const double weight = contact.force.norm();
    if (weight == 0) return;
    auto [place, is_new] = sums_.try_emplace({first, second});
    Sum& sum = place->second;
    if (is_new) {
      sum.contact = contact;
      sum.contact.p_G = sum.contact.n = sum.contact.force = Vec3::Zero();
    }
    sum.contact.p_G += weight * contact.p_G;
    sum.contact.n += weight * contact.n;
    sum.contact.force += contact.force;
    sum.contact.status = std::max(sum.contact.status, contact.status);
    sum.weight += weight;
  }

  double residual_of(const contact::SolvedProblem& solved, std::size_t i) const {
    if (i >= solved.d.size() || solved.solution.v.size() == 0) return 0;
    const double gap_speed = solved.problem.h > 0 ? std::max(0.0, solved.points[i].gap) / solved.problem.h : 0;
    return solved.d[i] * contact::impulse_residual(solved.problem, static_cast<int>(i), solved.d[i], solved.solution.r,
                                                   solved.solution.v, gap_speed)
                             .law.norm();
  }

  void join(int first, int second, double residual) {
    for (const int b : {first, second}) {
      if (b < 0 || !bodies_.moves(b)) continue;
      residual_[static_cast<std::size_t>(b)] = std::max(residual_[static_cast<std::size_t>(b)], residual);
      ++touched_[b];
    }
    if (first >= 0 && second >= 0 && bodies_.moves(first) && bodies_.moves(second))
      joined_.join(static_cast<std::size_t>(first), static_cast<std::size_t>(second));
  }

  void number_islands() {
    list_.island_of.assign(bodies_.id.size(), 0);
    std::map<std::size_t, int> number;
    std::map<int, int> ends;
    for (const auto& [b, count] : touched_) {
      const auto [place, is_new] =
          number.try_emplace(joined_.find(static_cast<std::size_t>(b)), static_cast<int>(list_.islands.size()) + 1);
      if (is_new) list_.islands.push_back({.iterations = iterations_});
      list_.island_of[static_cast<std::size_t>(b)] = place->second;
      FrameIsland& island = list_.islands[static_cast<std::size_t>(place->second - 1)];
      island.residual = std::max(island.residual, residual_[static_cast<std::size_t>(b)]);
    }
    for (const FrameContact& contact : list_.contacts) {
      const int of_first = list_.island_of[static_cast<std::size_t>(contact.first)];
      const int of = of_first > 0 ? of_first : list_.island_of[static_cast<std::size_t>(contact.second)];
      if (of > 0) ++list_.islands[static_cast<std::size_t>(of - 1)].contacts;
    }
  }

  const bodies::Bodies& bodies_;
  const ContactChoice& choice_;
  double h_;
  int iterations_ = 0;
  FrameContacts list_;
  std::map<std::pair<int, int>, Sum> sums_;
  UnionFind joined_;
  std::vector<double> residual_;  ///< per body
  std::map<int, int> touched_;    ///< number of contacts of each body that has any
};

}  // namespace

FrameContacts frame_contacts(const std::vector<contact::SolvedProblem>& substeps, const bodies::Bodies& bodies,
                             const ContactChoice& choice, double h) {
  Gathering gathering(bodies, choice, h);
  for (const auto& solved : substeps) gathering.add(solved);
  return gathering.result();
}

}  // namespace nilas::output::replay
