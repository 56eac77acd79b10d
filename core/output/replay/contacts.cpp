#include "core/output/replay/contacts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "contact/measure/impulse_residual.h"
#include "core/base/union_find.h"
#include "core/output/replay/byte_text.h"

namespace nilas::output::replay {

namespace {

constexpr double k_normal_unit = 127, k_point_units = 4;
constexpr int k_exact_flag = 128, k_stored_flag = 64;
/// Forces of free ice are stored with this many steps up to the largest.
constexpr double k_force_steps = 2000;

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

void add_contacts(const FrameContacts& list, const BodyFrames& frames, std::string& content) {
  add_varint(list.islands.size(), content);
  for (const FrameIsland& island : list.islands) {
    add_varint(static_cast<std::uint64_t>(island.contacts), content);
    add_varint(static_cast<std::uint64_t>(island.iterations), content);
    add_float(island.residual, content);
  }
  double largest = 0;
  for (const FrameContact& c : list.contacts)
    if (!c.exact) largest = std::max(largest, c.force.lpNorm<Eigen::Infinity>());
  const auto unit = static_cast<float>(largest > 0 ? largest / k_force_steps : 1);
  add_varint(list.contacts.size(), content);
  add_number(unit, content);
  for (const FrameContact& c : list.contacts)
    add_byte(static_cast<int>(c.status) + (c.exact ? k_exact_flag : 0) + (c.stored ? k_stored_flag : 0), content);
  std::int64_t last = 0;
  for (const FrameContact& c : list.contacts) add_signed(c.first - std::exchange(last, c.first), content);
  for (const FrameContact& c : list.contacts) add_varint(static_cast<std::uint64_t>(c.second), content);
  for (int k = 0; k < 3; ++k)
    for (const FrameContact& c : list.contacts) {
      const std::int64_t units = in_units(c.p_G[k], frames.quantum()) -
                                 frames.position(static_cast<std::size_t>(c.first))[static_cast<std::size_t>(k)];
      add_signed(in_units(static_cast<double>(units), k_point_units), content);
    }
  for (int k = 0; k < 3; ++k)
    for (const FrameContact& c : list.contacts)
      add_byte(static_cast<int>(std::lround(k_normal_unit * c.n[k])), content);
  for (const FrameContact& c : list.contacts)
    for (int k = 0; k < 3; ++k) {
      if (c.exact)
        add_float(c.force[k], content);
      else
        add_signed(in_units(c.force[k], static_cast<double>(unit)), content);
    }
}

}  // namespace nilas::output::replay
