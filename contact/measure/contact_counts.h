#pragma once
/// Counts the states of the contacts of a solution.
#include "contact/problem/local_problem.h"

namespace nilas::contact {

/// Contacts that separate, stick and slide. A contact is open where u_N >= d_a r_N; it slides where its slip is more
/// than the friction that is left could stop, and more than ten times the solution's law_map_m_s. Moments are not
/// counted.
struct ContactCounts {
  int open = 0, sticking = 0, sliding = 0;
};
ContactCounts count_contacts(const ContactProblem& problem, const VecX& r, const VecX& u);
ContactCounts count_contacts(const LocalProblem& problem, const VecX& r, const VecX& u);

}  // namespace nilas::contact
