#include "core/output/tables/events_csv.h"

#include <gtest/gtest.h>

#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/scratch_folder.h"

namespace nilas::output {
namespace events_csv_test {

TEST(EventsCsv, HasARowPerBrokenFloe) {
  test::ScratchFolder folder;
  EventsCsv csv(folder / "events.csv");
  csv.rows({});
  fracture::FractureEvent event;
  event.t = 1.25;
  event.kind = "bending";
  event.floe = 7;
  event.p_G = Vec3(1, -2, 0.5);
  event.energy = 0.125;
  event.length = 3;
  event.radius = 0.5;
  event.ratio = 1.5;
  event.brash = 0.25;
  event.extruded = 0.75;
  event.pieces = {9, 10, 11};
  csv.rows({event, event});
  csv.finish();
  const auto rows = test::lines_of(folder / "events.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0],
            "time_s,kind,floe_id,x_m,y_m,z_m,energy_J,length_m,pieces,radius_m,load_ratio,brash_kg,extruded_kg");
  EXPECT_EQ(rows[1], "1.25,bending,7,1,-2,0.5,0.125,3,9;10;11,0.5,1.5,0.25,0.75");
  EXPECT_EQ(rows[2], rows[1]);
}

}  // namespace events_csv_test
}  // namespace nilas::output
