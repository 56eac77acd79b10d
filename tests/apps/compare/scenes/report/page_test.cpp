/// Tests of a comparison's page, with hand-made figures.
#include "apps/compare/scenes/report/page.h"

#include <gtest/gtest.h>

#include "tests/support/file_text.h"
#include "tests/support/mentions.h"
#include "tests/support/scratch_folder.h"

namespace page_test {

using namespace nilas;
using namespace nilas::compare;
using nilas::test::mentions;

/// The page of two settings, the second of which differs by 3 N. The reference changes by `moves` [N] with its step.
std::string page_where_reference_changes_by(double moves) {
  SceneReport report;
  report.study.plan.settings.assign(2, {"auto", "coulomb", "moreau", "projection", 0.01, 1e-6});
  report.study.plan.settings[1].solver = "newton";
  report.study.plan.realisations = 2;
  Findings& found = report.found;
  found.measure = {"load", "N", 100};
  found.shared = {0, 1};
  found.check.moves = moves;
  found.merits.resize(2);
  for (std::size_t k = 0; k < 2; ++k) {
    Merit& m = found.merits[k];
    m.setting = k;
    m.planned = m.done = 2;
    m.realisations = found.shared;
  }
  Merit& second = found.merits[1];
  second.error = 3;
  second.step_load_median = 0.004;
  second.step_load_p95 = 0.25;
  second.significant = true;
  second.from_reference = second.from_own = {{0, 1}, {3, 3}, {0.2, 0.2}, 3, 0.1, 2, Certainty::everywhere};
  const test::ScratchFolder folder;
  write_first_page(folder.path(), report);
  return test::read_text(folder / "compare.html");
}

TEST(Page, PrintsInGreyWhatTheReferenceCannotShow) {
  const std::string page = page_where_reference_changes_by(5);
  EXPECT_TRUE(mentions(page, "<td class=\"n weak\">+3 ± 0.1, less than the reference&#39;s own change</td>")) << page;
  EXPECT_TRUE(mentions(page, "<td class=\"n weak\">3 (less than the reference&#39;s own change)</td>")) << page;
  EXPECT_TRUE(mentions(page, "<td class=\"n\">+3 ± 0.1, significant</td>")) << "from the scene's own setting: " << page;
  EXPECT_TRUE(mentions(page,
                       "With its step doubled the reference changes by 5 N. It cannot show errors below that, "
                       "which the tables mark as less than the reference&#39;s own change."))
      << page;
}

TEST(Page, SaysBesideTheResidualHowFarTheLoadOfAStepIsOff) {
  const std::string page = page_where_reference_changes_by(2);
  EXPECT_TRUE(mentions(page, "<td class=\"n\">0.0e+00</td><td class=\"n\">0.4 / 25</td>")) << page;
}

TEST(Page, PrintsInBlackWhatTheReferenceShows) {
  const std::string page = page_where_reference_changes_by(2);
  EXPECT_TRUE(mentions(page, "<td class=\"n\">3 (3 %)</td>")) << page;
  EXPECT_TRUE(mentions(page, "<td class=\"n\">+3 ± 0.1, significant</td><td class=\"n\">+3 ± 0.1, significant</td>"))
      << page;
}

}  // namespace page_test
