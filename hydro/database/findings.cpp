#include <algorithm>
#include <cmath>
#include <sstream>

#include "hydro/database/self_check.h"

namespace nilas::hydro {

namespace {

/// Sentences from parts of text and numbers with four digits.
template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  constexpr int k_digits = 4;
  text.precision(k_digits);
  (text << ... << parts);
  return text.str();
}

void judge_symmetry(const Asymmetry& found, std::vector<Finding>& list) {
  constexpr double k_doubtful = 0.15, k_wrong = 0.5;  // one triangle gives 1, a reversed sign 2
  if (found.share < k_doubtful) return;
  const bool severe = found.share > k_wrong;
  const char* name = found.in_damping ? "B" : "A";
  const int i = found.i + 1, j = found.j + 1;
  list.push_back({severe, sentence("The matrix ", found.in_damping ? "of damping" : "of added mass",
                                   " is not symmetric ", "at w = ", found.frequency, " rad/s: ", name, "(", i, ",", j,
                                   ") = ", found.value, ", but ", name, "(", j, ",", i, ") = ", found.transposed,
                                   severe ? ". Without forward speed both are equal; the file may hold one triangle "
                                            "only, or its modes may stand in another order."
                                          : ". The panels may be too coarse there, or the frequency irregular.")});
}

void judge_damping(const SelfCheck& check, std::vector<Finding>& list) {
  constexpr std::size_t k_shown = 5;
  const std::vector<NegativeDamping>& found = check.negative;
  for (const int mode : check.reversed)
    list.push_back({true, sentence("The damping in ", k_mode_name[mode],
                                   " is negative over the frequencies as a whole; its sign is reversed.")});
  if (found.empty()) return;
  std::string text = found.size() == 1 ? "One value of damping is negative:"
                                       : sentence(found.size(), " values of damping are negative:");
  for (std::size_t n = 0; n < std::min(k_shown, found.size()); ++n)
    text += sentence(n == 0 ? " " : ", ", k_mode_name[found[n].mode], " at w = ", found[n].frequency, " rad/s (",
                     found[n].value, ")");
  text += found.size() > k_shown ? " and more." : ".";
  list.push_back({false, text + " There the body would gain energy from calm water."});
}

void judge_haskind(const SelfCheck& check, std::vector<Finding>& list) {
  constexpr double k_doubtful = 0.03, k_wrong = 0.2;  // of the median; converged files are within 0.005
  std::string values;
  bool severe = false;
  for (const HaskindRatio& ratio : check.haskind) {
    const double off = std::abs(ratio.median - 1);
    if (off < k_doubtful) continue;
    severe = severe || off > k_wrong;
    values += sentence(values.empty() ? "" : ", ", ratio.median, " in ", k_mode_name[ratio.mode]);
  }
  if (values.empty()) return;
  list.push_back({severe, sentence("Excitation and damping do not fit by the relation of Haskind and Newman. Damping "
                                   "from the excitation, divided by that of the file, is ",
                                   values,
                                   ", where it must be 1. A length (ULEN) that is too large by a factor raises this "
                                   "value by that factor, and a gravity lowers it. A wrong depth changes it in long "
                                   "waves.")});
}

void judge_long_wave(const LongWave& wave, std::vector<Finding>& list) {
  constexpr double k_long = 0.1;                      // k times the size of the body
  constexpr double k_doubtful = 0.1, k_wrong = 0.25;  // of the limits
  if (wave.horizontal_sign < 0)
    list.push_back(
        {true, sentence("Horizontal loads of the longest wave lag behind its elevation, where they must "
                        "lead it. Phases are those of exp(-i w t), or headings say where waves come from.")});
  if (wave.steepness > k_long) return;
  if (wave.heave && std::abs(*wave.heave - 1) > k_doubtful)
    list.push_back({std::abs(*wave.heave - 1) > k_wrong,
                    sentence("Heave excitation of the longest wave is ", *wave.heave,
                             " times the stiffness in heave, where it must be 1. Excitation and stiffness have "
                             "different scales.")});
  if (wave.horizontal && wave.horizontal_sign > 0 && std::abs(*wave.horizontal - 1) > k_doubtful)
    list.push_back({false, sentence("Horizontal loads of the longest wave are ", *wave.horizontal,
                                    " times the inertia of the displaced water and the added mass, where they must be "
                                    "1. The volume or the depth is another one.")});
}

void judge_closure(const std::vector<Closure>& closures, std::vector<Finding>& list) {
  constexpr double k_doubtful = 0.02, k_wrong = 0.1;  // of the motion
  for (const Closure& closure : closures)
    if (closure.share > k_doubtful)
      list.push_back({closure.share > k_wrong,
                      sentence("The motion in ", k_mode_name[closure.mode],
                               " that follows from the matrices differs "
                               "from that of the file by ",
                               100 * closure.share,
                               " % of the motion. The mass that was given, the sign of damping or a phase is not that "
                               "of the file.")});
}

}  // namespace

std::vector<Finding> findings(const Database& database, const SelfCheck& check) {
  std::vector<Finding> list;
  for (const std::string& note : database.notes) list.push_back({false, note});
  judge_symmetry(check.asymmetry, list);
  judge_damping(check, list);
  judge_haskind(check, list);
  if (check.long_wave) judge_long_wave(*check.long_wave, list);
  judge_closure(check.closure, list);
  return list;
}

}  // namespace nilas::hydro
