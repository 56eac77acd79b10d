#pragma once
/// Changes of a contact problem that must not change the motion, or change it in a known way.
#include <cmath>
#include <cstdint>
#include <vector>

#include "contact/problem/problem.h"

namespace nilas::test {

/// The same problem without its contacts.
inline contact::ContactProblem without_contacts(const contact::ContactProblem& problem) {
  contact::ContactProblem out = problem;
  out.pairs.clear();
  out.jacobian_offset = {0};
  out.jacobian_data.clear();
  contact::for_each_list(out, problem, [](auto& list, const auto&) { list.clear(); });
  out.w.resize(0);
  return out;
}

/// Appends contact c of `from`, with a new key and optionally with its bodies' roles swapped (rows keep their sign).
inline void copy_contact(const contact::ContactProblem& from, int c, std::uint64_t key, bool swapped,
                         contact::ContactProblem& to) {
  const auto i = static_cast<std::size_t>(c);
  const auto& pair = from.pairs[i];
  if (swapped)
    to.add_contact(pair.b, from.jacobian_b(c), pair.a, from.jacobian_a(c), key);
  else
    to.add_contact(pair.a, from.jacobian_a(c), pair.b, from.jacobian_b(c), key);
  contact::for_each_list(to, from, [i](auto& list, const auto& source) { list.back() = source[i]; });
  to.key.back() = key;
  to.w.tail<3>() = from.w.segment<3>(3 * c);
}

/// The same problem with its contacts in another order.
inline contact::ContactProblem with_order(const contact::ContactProblem& problem, const std::vector<int>& order) {
  contact::ContactProblem out = without_contacts(problem);
  for (const int c : order) copy_contact(problem, c, problem.key[c], false, out);
  return out;
}

/// The same problem with block lists swapped: A's rows take the place of B's. Velocities and impulses stay the same.
inline contact::ContactProblem with_swapped_sides(const contact::ContactProblem& problem) {
  contact::ContactProblem out = without_contacts(problem);
  for (int c = 0; c < problem.num_contacts(); ++c) copy_contact(problem, c, problem.key[c], true, out);
  return out;
}

/// The same problem with every contact twice. Bounds of the impulse hold for each copy.
inline contact::ContactProblem with_duplicates(const contact::ContactProblem& problem) {
  contact::ContactProblem out = problem;
  for (int c = 0; c < problem.num_contacts(); ++c)
    copy_contact(problem, c, 1000000 + static_cast<std::uint64_t>(c), false, out);
  return out;
}

/// The same problem with the tangent rows of every contact turned about the normal, each by its own multiple of
/// `angle`.
inline contact::ContactProblem with_turned_tangents(contact::ContactProblem problem, double angle) {
  for (int contact = 0; contact < problem.num_contacts(); ++contact) {
    const double c = std::cos(angle * (1 + contact)), s = std::sin(angle * (1 + contact));
    for (const auto& rows : {problem.jacobian_a(contact), problem.jacobian_b(contact)}) {
      const auto n = rows.cols();
      double* const data = problem.jacobian_data.data() + (rows.data() - problem.jacobian_data.data());
      for (Eigen::Index j = 0; j < n; ++j) {
        double &t1 = data[n + j], &t2 = data[2 * n + j];
        const double old = t1;
        t1 = c * old + s * t2;
        t2 = c * t2 - s * old;
      }
    }
    const double w1 = problem.w[3 * contact + 1], w2 = problem.w[3 * contact + 2];
    problem.w[3 * contact + 1] = c * w1 + s * w2;
    problem.w[3 * contact + 2] = c * w2 - s * w1;
  }
  return problem;
}

/// The same problem with all masses and momenta times a factor: velocities stay the same, impulses are multiplied by
/// the factor.
inline contact::ContactProblem with_mass_scale(contact::ContactProblem problem, double factor) {
  for (double& m : problem.mass_data) m *= factor;
  problem.f *= factor;
  for (double& limit : problem.force_limit) limit *= factor;
  for (double& compliance : problem.compliance) compliance /= factor;
  for (double& compliance : problem.tangential_compliance) compliance /= factor;
  return problem;
}

/// The same problem with all velocities times a factor.
inline contact::ContactProblem with_speed_scale(contact::ContactProblem problem, double factor) {
  problem.f *= factor;
  problem.w *= factor;
  for (double& limit : problem.force_limit) limit *= factor;
  return problem;
}

}  // namespace nilas::test
