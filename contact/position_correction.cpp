#include "contact/position_correction.h"

#include <algorithm>

#include "contact/islands.h"
#include "contact/solvers/pgs.h"
#include "core/base/error.h"

namespace nilas {

namespace {

/// The step's contact graph with what stands still taken out.
ContactProblem movable_graph(const AssembledContacts& contacts, bool move_articulated) {
  ContactProblem graph;
  graph.block_offset = contacts.problem.block_offset;
  graph.pairs = contacts.problem.pairs;
  if (move_articulated) return graph;
  for (auto& pair : graph.pairs) {
    if (pair.a >= contacts.first_articulated_block) pair.a = -1;
    if (pair.b >= contacts.first_articulated_block) pair.b = -1;
  }
  return graph;
}

/// Contacts of all islands with something to move and a depth beyond `smallest` [m].
std::vector<int> contacts_to_correct(const ContactProblem& graph, const std::vector<ContactPoint>& points,
                                     double smallest) {
  std::vector<int> chosen;
  if (std::none_of(points.begin(), points.end(), [&](const ContactPoint& c) { return -c.gap > smallest; }))
    return chosen;
  for (const auto& island : find_islands(graph)) {
    const auto& first = graph.pairs[static_cast<std::size_t>(island.front())];
    if (first.a < 0 && first.b < 0) continue;
    const bool deep = std::any_of(island.begin(), island.end(),
                                  [&](int c) { return -points[static_cast<std::size_t>(c)].gap > smallest; });
    if (deep) chosen.insert(chosen.end(), island.begin(), island.end());
  }
  return chosen;
}

double least_speed(const ContactPoint& point, const CorrectionSettings& settings) {
  const double depth = -point.gap;
  if (depth > settings.slop) return std::min(settings.erp * (depth - settings.slop) / settings.h, settings.max_speed);
  return depth < 0 ? depth / settings.h : 0;
}

/// The frictionless problem of a correction, built contact by contact from the step's problem.
class CorrectionProblem {
 public:
  CorrectionProblem(const ContactProblem& step, const CorrectionSettings& settings)
      : step_(step), settings_(settings), place_(static_cast<std::size_t>(step.num_blocks()), -1) {
    problem_.h = settings.h;
    problem_.law = Law::frictionless;
  }

  /// Takes over contact c between the blocks of `pair` (-1: stands still).
  void add(int c, const ContactProblem::Pair& pair, const ContactPoint& point) {
    if (pair.a >= 0) append(step_.jacobian_a(c));
    if (pair.b >= 0) append(step_.jacobian_b(c));
    problem_.jacobian_offset.push_back(problem_.jacobian_data.size());
    problem_.pairs.push_back({block_for(pair.a), block_for(pair.b)});
    problem_.key.push_back(step_.key[static_cast<std::size_t>(c)]);
    least_speeds_.push_back(least_speed(point, settings_));
  }

  const ContactProblem& finish() {
    const std::size_t count = problem_.pairs.size();
    problem_.f = VecX::Zero(problem_.num_velocities());
    problem_.w = VecX::Zero(3 * static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i) problem_.w[3 * static_cast<Eigen::Index>(i)] = -least_speeds_[i];
    problem_.mu.assign(count, 0.0);
    problem_.mu_static.assign(count, 0.0);
    problem_.force_limit.assign(count, std::numeric_limits<double>::infinity());
    problem_.compliance.assign(count, 0.0);
    return problem_;
  }

  /// Velocities of this problem's blocks put where the step's problem has them.
  void scatter(const VecX& v, VecX& step_v) const {
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
      const int size = step_.block_size(blocks_[k]);
      step_v.segment(step_.block_offset[static_cast<std::size_t>(blocks_[k])], size) =
          v.segment(problem_.block_offset[k], size);
    }
  }

 private:
  void append(const ContactProblem::ConstJacobian& rows) {
    problem_.jacobian_data.insert(problem_.jacobian_data.end(), rows.data(), rows.data() + rows.size());
  }

  int block_for(int k) {
    if (k < 0) return -1;
    int& place = place_[static_cast<std::size_t>(k)];
    if (place < 0) {
      place = static_cast<int>(blocks_.size());
      blocks_.push_back(k);
      const auto mass = step_.mass(k);
      problem_.block_offset.push_back(problem_.block_offset.back() + step_.block_size(k));
      problem_.mass_data.insert(problem_.mass_data.end(), mass.data(), mass.data() + mass.size());
      problem_.mass_offset.push_back(problem_.mass_data.size());
    }
    return place;
  }

  const ContactProblem& step_;
  const CorrectionSettings& settings_;
  ContactProblem problem_;
  std::vector<int> place_;   ///< of the step's blocks among this problem's, -1: not in it
  std::vector<int> blocks_;  ///< of the step's problem
  std::vector<double> least_speeds_;
};

}  // namespace

PositionCorrection position_correction(const AssembledContacts& contacts, const std::vector<ContactPoint>& points,
                                       const CorrectionSettings& settings) {
  NILAS_DEMAND(settings.h > 0 && points.size() == contacts.problem.pairs.size());
  PositionCorrection out;
  out.v = VecX::Zero(contacts.problem.num_velocities());
  const ContactProblem graph = movable_graph(contacts, settings.move_articulated);
  // a speed below the solver's tolerance would be met by standing still
  const double smallest = settings.slop + settings.solver.tolerance * settings.h / settings.erp;
  const std::vector<int> chosen = settings.erp > 0 ? contacts_to_correct(graph, points, smallest) : std::vector<int>{};
  if (chosen.empty()) return out;

  CorrectionProblem correction(contacts.problem, settings);
  for (const int c : chosen) {
    const auto i = static_cast<std::size_t>(c);
    correction.add(c, graph.pairs[i], points[i]);
  }
  const ContactSolution solution = PgsSolver({.shared = settings.solver}).solve(correction.finish(), {});
  correction.scatter(solution.v, out.v);
  out.contacts = static_cast<int>(chosen.size());
  out.status = solution.status;
  out.iterations = solution.iterations;
  return out;
}

PositionCorrection correction_velocities(const AssembledContacts& contacts, const std::vector<ContactPoint>& points,
                                         const CorrectionSettings& settings, std::vector<Vec3>& v,
                                         std::vector<Vec3>& w) {
  NILAS_DEMAND(v.size() == contacts.block_of_body.size() && w.size() == contacts.block_of_body.size());
  PositionCorrection out = position_correction(contacts, points, settings);
  for (std::size_t body = 0; body < contacts.block_of_body.size(); ++body) {
    const int block = contacts.block_of_body[body];
    if (block < 0 || block >= contacts.first_articulated_block) continue;
    const int first = contacts.problem.block_offset[static_cast<std::size_t>(block)];
    v[body] = out.v.segment<3>(first);
    w[body] = out.v.segment<3>(first + 3);
  }
  return out;
}

}  // namespace nilas
