/// Tests of paired differences in words, with hand-made figures.
#include "apps/compare/scenes/report/paired_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace paired_text_test {

using namespace nilas::compare;

/// A difference of the same value in each of `count` realisations, in which chance makes up to 0.2 N.
PairedDifference difference_of(double mean, Certainty certainty, std::size_t count = 2) {
  PairedDifference d;
  for (std::size_t k = 0; k < count; ++k) d.realisations.push_back(static_cast<int>(k));
  d.values.assign(count, mean);
  d.limits.assign(count, 0.2);
  d.mean = mean;
  d.half_width = count > 1 ? 0.1 : std::numeric_limits<double>::quiet_NaN();
  d.beyond_chance = certainty == Certainty::in_realisations ? static_cast<int>(count) : 0;
  d.certainty = certainty;
  return d;
}

/// Loads of 100 N of three settings, the second of which differs by this and the third by 0.01 N, which may be chance.
/// They differ by as much from the first setting as from the reference, which its own step changes by 5 N.
Findings found_with(const PairedDifference& second) {
  Findings found;
  found.measure = {"load", "N", 100};
  found.shared = second.realisations;
  found.check.moves = 5;
  found.merits.resize(3);
  for (std::size_t k = 0; k < 3; ++k) found.merits[k].setting = k;
  found.merits[1].from_reference = found.merits[1].from_own = second;
  found.merits[2].from_reference = found.merits[2].from_own =
      difference_of(0.01, Certainty::none, second.realisations.size());
  return found;
}

std::vector<std::string> from_reference(const Findings& found) {
  return difference_lines(found, &Merit::from_reference, "the reference", {"own setting", "newton", "pgs"});
}

std::vector<std::string> from_own(const Findings& found) {
  return difference_lines(found, &Merit::from_own, "the scene's own setting", {"own setting", "newton", "pgs"});
}

using Lines = std::vector<std::string>;

TEST(PairedText, OfACellSaysWhetherTheDifferenceIsSignificant) {
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::everywhere), 0), "+0.35 +- 0.1, significant");
  EXPECT_EQ(difference_cell(difference_of(-0.35, Certainty::in_realisations, 1), 0),
            "-0.35, significant in this realisation");
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::in_realisations), 0),
            "+0.35 +- 0.1, significant in 2 of 2 realisations");
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::unknown, 1), 0), "+0.35, effect of chance not known");
  EXPECT_EQ(difference_cell({}, 0), "");
}

TEST(PairedText, OfACellCallsNothingSignificantThatTheReferenceCannotShow) {
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::everywhere), 0.5),
            "+0.35 +- 0.1, less than the reference's own change");
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::everywhere), 0.3), "+0.35 +- 0.1, significant");
  EXPECT_EQ(difference_cell(difference_of(0.35, Certainty::none), 0.5), "+0.35 +- 0.1, may be chance");
}

TEST(PairedText, NamesNoDifferenceThatTheReferenceCannotShow) {
  const Findings found = found_with(difference_of(3, Certainty::everywhere));
  EXPECT_EQ(from_reference(found),
            Lines{"Compared run by run on the same ice, no setting's mean ice load differs from that of the reference "
                  "by more than both chance (up to 0.2 N, 95 %) and the reference's own change with its step (5 N)."});
}

TEST(PairedText, NamesDifferencesFromTheOwnSettingWhateverTheReferenceChanges) {
  const Findings found = found_with(difference_of(3, Certainty::everywhere));
  EXPECT_EQ(from_own(found),
            Lines{"Compared run by run on the same ice, the mean ice load differs significantly from that of the "
                  "scene's own setting (95 %, over realisations 0 and 1): \"newton\" by +3 N +- 0.1 N (+3 %)."});
}

TEST(PairedText, NamesDifferencesThatExceedTheReferencesChange) {
  Findings found = found_with(difference_of(3, Certainty::everywhere));
  found.check.moves = 2;
  EXPECT_EQ(from_reference(found),
            Lines{"Compared run by run on the same ice, the mean ice load differs significantly from that of the "
                  "reference (95 %, over realisations 0 and 1): \"newton\" by +3 N +- 0.1 N (+3 %)."});
}

TEST(PairedText, OfTheSameIceSaysOnceThatOtherIceMayDiffer) {
  Findings found = found_with(difference_of(3, Certainty::everywhere));
  found.same_ice = true;
  EXPECT_EQ(from_own(found),
            Lines{"Compared run by run on the same ice, the mean ice load differs significantly from that of the "
                  "scene's own setting (the same ice twice; chance is negligible): \"newton\" by +3 N +- 0.1 N (+3 %). "
                  "This says nothing about other ice."});
}

TEST(PairedText, OfOneRealisationSaysWhatChanceMakesThere) {
  EXPECT_EQ(from_own(found_with(difference_of(3, Certainty::in_realisations, 1))),
            Lines{"In the one realisation that was run, the mean ice load differs significantly from that of the "
                  "scene's own setting (chance alone makes at most 0.2 N there, 95 %): \"newton\" by +3 N (+3 %). "
                  "This says nothing about other ice."});
}

TEST(PairedText, SaysWhereNothingDiffersSignificantly) {
  EXPECT_EQ(from_reference(found_with(difference_of(0.1, Certainty::none))),
            Lines{"No setting's mean ice load differs significantly from that of the reference, not even run by run on "
                  "the same ice, where chance alone makes up to 0.2 N (95 %)."});
  Findings unknown = found_with(difference_of(0.1, Certainty::unknown, 1));
  unknown.merits[2].from_reference.certainty = Certainty::unknown;
  EXPECT_EQ(from_reference(unknown), Lines{}) << "the effect of chance is not known";
}

}  // namespace paired_text_test
