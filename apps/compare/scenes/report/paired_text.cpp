#include "apps/compare/scenes/report/paired_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/compare/scenes/judge/pairing.h"
#include "apps/compare/scenes/report/scene_report.h"

namespace nilas::compare {

namespace {

constexpr std::size_t k_most_named = 4;

std::string signed_force(double newton) { return (newton > 0 ? "+" : "") + quantity_text(newton, "N"); }

std::string amount(const PairedDifference& d, double scale) {
  const std::string width = d.certainty == Certainty::everywhere ? uncertainty_text(d.mean, d.half_width, "N") : "";
  return fmt::format("{}{} ({:+.2g} %)", signed_force(d.mean), width, 100 * d.mean / scale);
}

/// The change of the reference with its own step, below which it shows no difference [N]. The reference has no part in
/// differences from another setting: for them it is 0.
double least_shown(const Findings& found, PairedDifference Merit::*member) {
  return member == &Merit::from_reference ? found.check.moves.value_or(0) : 0;
}

/// The merits whose difference has this certainty, the largest mean first, without those that the reference cannot
/// show.
std::vector<const Merit*> of_certainty(const Findings& found, PairedDifference Merit::*member, Certainty certainty) {
  std::vector<const Merit*> list;
  for (const auto& m : found.merits)
    if ((m.*member).certainty == certainty && !is_below_change(m.*member, least_shown(found, member)))
      list.push_back(&m);
  std::stable_sort(list.begin(), list.end(), [&](const Merit* a, const Merit* b) {
    return std::abs((a->*member).mean) > std::abs((b->*member).mean);
  });
  return list;
}

/// The settings in words: those with a difference above k_target by name, up to a limit, and the number of the others.
template <class Text>
std::string named(const std::vector<const Merit*>& list, const Findings& found, PairedDifference Merit::*member,
                  const Text& text) {
  const auto matter = static_cast<std::size_t>(std::count_if(list.begin(), list.end(), [&](const Merit* m) {
    return std::abs((m->*member).mean) > k_target * found.measure.scale;
  }));
  std::string names;
  const std::size_t shown = std::min(matter, k_most_named);
  for (std::size_t k = 0; k < shown; ++k) names += (k > 0 ? "; " : "") + text(*list[k]);
  if (matter > shown) names += fmt::format("; {} more by more than {:g} %", matter - shown, 100 * k_target);
  if (list.size() > matter)
    names += fmt::format("{}{} setting{} by less than {:g} %", names.empty() ? "" : "; ", list.size() - matter,
                         list.size() - matter == 1 ? "" : "s", 100 * k_target);
  return names;
}

using Member = PairedDifference Merit::*;

std::string by_setting(const std::vector<const Merit*>& list, const Findings& found, Member member,
                       const std::vector<std::string>& labels) {
  return named(list, found, member, [&](const Merit& m) {
    return fmt::format("\"{}\" by {}", labels[m.setting], amount(m.*member, found.measure.scale));
  });
}

/// The realisations on which significance rests, and its level.
std::string basis_text(const Findings& found) {
  constexpr double k_negligible = 1e-3;
  if (!found.same_ice || found.shared.size() < 2) return "95 %, over " + realisations_text(found.shared);
  const std::string times =
      found.shared.size() == 2 ? "the same ice twice" : fmt::format("the same ice {} times", found.shared.size());
  return times + (found.common_floor < k_negligible * found.measure.scale ? "; chance is negligible" : "; 95 %");
}

/// The sentence about differences whose mean over the realisations is significant by Student's t.
std::string everywhere_line(const std::vector<const Merit*>& list, const Findings& found, Member member,
                            const std::string& other, const std::vector<std::string>& labels) {
  return fmt::format(
      "Compared run by run on the same ice, the mean ice load differs significantly from that of {} ({}): {}.{}", other,
      basis_text(found), by_setting(list, found, member, labels),
      found.same_ice ? " This says nothing about other ice." : "");
}

std::string one_realisation_line(const std::vector<const Merit*>& list, const Findings& found, Member member,
                                 const std::string& other, const std::vector<std::string>& labels) {
  return fmt::format(
      "In the one realisation that was run, the mean ice load differs significantly from that of {} (chance alone "
      "makes at most {} there, 95 %): {}. This says nothing about other ice.",
      other, quantity_text(widest_limit(found.merits, member), "N"), by_setting(list, found, member, labels));
}

std::string some_realisations_line(const std::vector<const Merit*>& list, const Findings& found, Member member,
                                   const std::string& other, const std::vector<std::string>& labels) {
  return fmt::format(
      "In some of the realisations the mean ice load differs from that of {} by more than chance makes (95 %), "
      "although the mean over the realisations does not: {}.",
      other, named(list, found, member, [&](const Merit& m) {
        const PairedDifference& d = m.*member;
        return fmt::format("\"{}\" in {} of {}, by {} on average", labels[m.setting], d.beyond_chance,
                           d.realisations.size(), amount(d, found.measure.scale));
      }));
}

/// The sentence where no setting differs significantly. A difference may still be significant and smaller than what the
/// reference can show.
std::string no_difference_line(const Findings& found, Member member, const std::string& other) {
  const double chance = widest_limit(found.merits, member), least = least_shown(found, member);
  const std::string limit = quantity_text(chance, "N");
  const bool hidden = std::any_of(found.merits.begin(), found.merits.end(),
                                  [&](const Merit& m) { return is_below_change(m.*member, least); });
  if (hidden)
    return fmt::format(
        "Compared run by run on the same ice, no setting's mean ice load differs from that of {} by more than both "
        "chance{} and the reference's own change with its step ({}).",
        other, chance > 0 ? " (up to " + limit + ", 95 %)" : "", quantity_text(least, "N"));
  return fmt::format(
      "No setting's mean ice load differs significantly from that of {}, not even run by run on the same ice{}.", other,
      chance > 0 ? ", where chance alone makes up to " + limit + " (95 %)" : "");
}

}  // namespace

const char* name_of(Certainty certainty) {
  switch (certainty) {
    case Certainty::everywhere:
      return "everywhere";
    case Certainty::in_realisations:
      return "in realisations";
    case Certainty::none:
      return "none";
    case Certainty::unknown:
      break;
  }
  return "unknown";
}

std::string difference_cell(const PairedDifference& d, double reference_moves) {
  if (d.realisations.empty()) return "";
  std::string text = (d.mean > 0 ? "+" : "") + three_digits(d.mean) + uncertainty_text(d.mean, d.half_width, "");
  if (is_below_change(d, reference_moves)) return text + ", less than the reference's own change";
  switch (d.certainty) {
    case Certainty::everywhere:
      return text + ", significant";
    case Certainty::in_realisations:
      return text + (d.realisations.size() == 1 ? ", significant in this realisation"
                                                : fmt::format(", significant in {} of {} realisations", d.beyond_chance,
                                                              d.realisations.size()));
    case Certainty::none:
      return text + ", may be chance";
    case Certainty::unknown:
      break;
  }
  return text + ", effect of chance not known";
}

std::vector<std::string> difference_lines(const Findings& found, PairedDifference Merit::*member,
                                          const std::string& other, const std::vector<std::string>& labels) {
  std::vector<std::string> lines;
  const auto everywhere = of_certainty(found, member, Certainty::everywhere),
             somewhere = of_certainty(found, member, Certainty::in_realisations);
  if (!everywhere.empty()) lines.push_back(everywhere_line(everywhere, found, member, other, labels));
  if (!somewhere.empty())
    lines.push_back(found.shared.size() == 1 ? one_realisation_line(somewhere, found, member, other, labels)
                                             : some_realisations_line(somewhere, found, member, other, labels));
  const bool known = std::any_of(found.merits.begin(), found.merits.end(),
                                 [&](const Merit& m) { return (m.*member).certainty != Certainty::unknown; });
  if (lines.empty() && known) lines.push_back(no_difference_line(found, member, other));
  return lines;
}

std::string realisations_text(const std::vector<int>& realisations) {
  std::string list;
  for (std::size_t k = 0; k < realisations.size(); ++k)
    list += (k == 0 ? "" : k + 1 == realisations.size() ? " and " : ", ") + std::to_string(realisations[k]);
  return fmt::format("realisation{} {}", realisations.size() == 1 ? "" : "s", list);
}

}  // namespace nilas::compare
