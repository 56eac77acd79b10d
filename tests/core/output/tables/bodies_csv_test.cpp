#include "core/output/tables/bodies_csv.h"

#include <gtest/gtest.h>

#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"

namespace nilas::output {
namespace bodies_csv_test {

TEST(BodiesCsv, WritesEveryBodyWithAllItsDigits) {
  const test::ScratchFolder folder;
  bodies::Bodies bodies = test::sample_bodies();
  bodies.p_GB[0].x() = 1.0 / 3;
  bodies.q_GB[0] = Quat(0.5, -0.5, 0.5, -0.5);
  bodies.w_GB[0] = Vec3(7, 8, 9);
  BodiesCsv csv(folder / "bodies.csv");
  csv.rows(0, bodies);
  csv.rows(0.1, bodies);
  const auto rows = test::lines_of(folder / "bodies.csv");
  ASSERT_EQ(rows.size(), 1u + 2 * 4);
  EXPECT_EQ(rows[0], "time_s,id,name,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s");
  EXPECT_EQ(rows[5],
            "0.10000000000000001,1,floe-1,0.33333333333333331,2,0,0.5,-0.5,0.5,-0.5,0.29999999999999999,"
            "0.40000000000000002,0,7,8,9");
  EXPECT_EQ(rows[8], "0.10000000000000001,4,\"wall,\"\"north\"\"\",0,9,0,1,0,0,0,0,0,0,0,0,0");
}

}  // namespace bodies_csv_test
}  // namespace nilas::output
