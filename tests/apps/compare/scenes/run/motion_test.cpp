/// Motions read back and compared.
#include "apps/compare/scenes/run/motion.h"

#include <gtest/gtest.h>

#include "core/base/csv.h"
#include "core/base/error.h"
#include "tests/support/scratch_folder.h"

namespace motion_test {

using namespace nilas;
using namespace nilas::compare;

constexpr const char* k_header =
    "time_s,id,name,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s\n";

TEST(CsvColumns, LeaveOutARowThatIsNotWhole) {
  const test::ScratchFolder folder;
  const auto file = folder.write("a.csv", "t,\"name, of it\",x\n0,\"a,b\",1.5\n1,c,2.5\n2,d,3");
  const auto columns = csv_columns(file, {"x", "t"});
  EXPECT_EQ(columns[0], (std::vector<double>{1.5, 2.5}));
  EXPECT_EQ(columns[1], (std::vector<double>{0, 1}));
  EXPECT_THROW(csv_columns(file, {"y"}), InputError);
  EXPECT_THROW(csv_columns(folder.path() / "b.csv", {"y"}), FileError);
}

TEST(Motion, IsReadByTimeAndId) {
  const test::ScratchFolder folder;
  const auto file =
      folder.write("bodies.csv", std::string(k_header) + "0,1,a,0,0,0,1,0,0,0,0,0,0,0,0,0\n" +
                                     "0,2,\"b,c\",5,0,0,1,0,0,0,0,0,0,0,0,0\n" + "1,1,a,3,4,0,1,0,0,0,0,0,0,0,0,0\n");
  const SampledMotion motion = read_motion(file);
  ASSERT_EQ(motion.size(), 2U);
  EXPECT_EQ(motion[0].bodies.size(), 2U);
  EXPECT_EQ(motion[0].bodies.at(2).p.x(), 5);
  EXPECT_DOUBLE_EQ(longest_path(motion), 5);
}

SampledBody at(const Vec3& p, const Vec3& v = Vec3::Zero(), double yaw = 0) {
  return {p, v, Vec3::Zero(), Quat(Eigen::AngleAxisd(yaw, Vec3::UnitZ()))};
}

TEST(Distances, AreThoseOfTheBodiesThatBothHave) {
  const SampledMotion a{{0, {{1, at({0, 0, 0})}, {2, at({1, 0, 0})}}}},
      b{{0, {{1, at({3, 0, 4})}, {2, at({1, 0, 0}, Vec3::Zero(), 0.1)}}}};
  EXPECT_EQ(distances(a, b).size(), 1U);
  SampledMotion longer = a, other = b;
  longer.push_back({1, {{1, at({0, 0, 0})}, {3, at({1, 0, 0})}}});
  other.push_back({1, {{1, at({0, 2, 0})}}});
  const auto both = distances(longer, other);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_DOUBLE_EQ(both[0].largest, 5);
  EXPECT_DOUBLE_EQ(both[0].rms, 5 / std::sqrt(2));
  EXPECT_EQ(both[0].axes, Vec3(3, 0, 4));
  EXPECT_NEAR(both[0].turn, 0.1, 1e-12);
  EXPECT_TRUE(both[0].same_bodies);
  EXPECT_DOUBLE_EQ(both[1].rms, 2);
  EXPECT_FALSE(both[1].same_bodies);
}

TEST(Distances, BridgeTimesThatDifferALittle) {
  const Vec3 v(2, 0, 0);
  const SampledMotion a{{0, {{1, at({0, 0, 0}, v)}}}, {1, {{1, at({2, 0, 0}, v)}}}};
  const SampledMotion b{{0, {{1, at({0, 0, 0}, v)}}}, {1.1, {{1, at({2.2, 0, 0}, v)}}}, {9, {}}};
  const auto apart = distances(a, b);
  ASSERT_EQ(apart.size(), 2U);
  EXPECT_NEAR(apart[1].largest, 0, 1e-15);
}

}  // namespace motion_test
