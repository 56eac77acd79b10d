#include "core/output/tables/vessel_csv.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/csv_table.h"
#include "tests/support/file_text.h"

namespace nilas::output {
namespace vessel_csv_test {

using test::cells_of;
using test::full_record;
using test::full_run;
using test::lines_of;
using test::ScratchFolder;

/// File of one row for the record.
std::vector<std::string> written(const sim::RunInfo& info, const sim::StepRecord& record) {
  const ScratchFolder folder;
  const VesselChannels channels(info);
  std::vector<double> values;
  channels.read(*record.vessel, values);
  VesselCsv csv(folder / "vessel.csv", channels);
  csv.row(record.t, values);
  csv.finish();
  return lines_of(folder / "vessel.csv");
}

TEST(VesselCsv, HasTheColumnsOfEveryModuleInOrder) {
  EXPECT_EQ(written(full_run(), full_record()).at(0),
            "time_s,contact_fx_N,contact_fy_N,contact_fz_N,contact_mx_Nm,contact_my_Nm,contact_mz_Nm,"
            "carriage_fx_N,carriage_fy_N,carriage_fz_N,carriage_mx_Nm,carriage_my_Nm,carriage_mz_Nm,"
            "hull_fx_N,hull_fy_N,hull_fz_N,hull_mx_Nm,hull_my_Nm,hull_mz_Nm,"
            "cell1_N,cell2_N,cell3_N,cell4_N,cell5_N,cell6_N,"
            "cell1_tared_N,cell2_tared_N,cell3_tared_N,cell4_tared_N,cell5_tared_N,cell6_tared_N,"
            "hydro_fx_N,hydro_fy_N,hydro_fz_N,hydro_mx_Nm,hydro_my_Nm,hydro_mz_Nm,"
            "x_m,y_m,z_m,yaw_deg,pitch_deg,roll_deg,vx_m_s,vy_m_s,vz_m_s,"
            "roll_rate_deg_s,pitch_rate_deg_s,yaw_rate_deg_s,wx_rad_s,wy_rad_s,wz_rad_s,"
            "ice_resistance_N,ice_side_N");
}

TEST(VesselCsv, LeavesOutTheColumnsOfAbsentModules) {
  sim::RunInfo info = full_run();
  info.has_carriage = info.has_cells = info.has_hydro = false;
  sim::StepRecord record = full_record();
  record.vessel->carriage.reset();
  record.vessel->hydro.reset();
  const auto rows = written(info, record);
  EXPECT_EQ(rows.at(0),
            "time_s,contact_fx_N,contact_fy_N,contact_fz_N,contact_mx_Nm,contact_my_Nm,contact_mz_Nm,"
            "x_m,y_m,z_m,yaw_deg,pitch_deg,roll_deg,vx_m_s,vy_m_s,vz_m_s,"
            "roll_rate_deg_s,pitch_rate_deg_s,yaw_rate_deg_s,wx_rad_s,wy_rad_s,wz_rad_s,"
            "ice_resistance_N,ice_side_N");
  EXPECT_EQ(cells_of(rows.at(1)).size(), cells_of(rows.at(0)).size());
}

TEST(VesselCsv, WritesEachValueUnderItsName) {
  sim::StepRecord record = full_record();
  record.vessel->state.pose.q = Quat(Eigen::AngleAxisd(30 * k_deg, Vec3::UnitZ()));
  record.vessel->state.w = Vec3(0, 0, 0.5);
  const auto rows = written(full_run(), record);
  ASSERT_EQ(rows.size(), 2u);
  const auto names = cells_of(rows[0]), values = cells_of(rows[1]);
  ASSERT_EQ(values.size(), names.size());
  const std::vector<double> expected{0.01, 1,   2,    3,  4,  5,  6,           11, 12, 13,  14, 15, 16, 21,
                                     22,   23,  24,   25, 26, 31, 32,          33, 34, 35,  36, 28, 30, 33,
                                     33,   33,  36.5, 41, 42, 43, 44,          45, 46, 51,  52, 53, 30, 0,
                                     0,    0.3, 0,    62, 0,  0,  0.5 / k_deg, 0,  0,  0.5, -1, 2};
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NEAR(std::stod(values[k]), expected[k], 1e-12 + 1e-15 * expected[k]) << names[k];
    EXPECT_EQ(values[k].size() - values[k].find('.'), 13u) << names[k];
  }
  EXPECT_EQ(values[44], "0.000000000000") << "a velocity that rounds to zero has no sign";
}

TEST(VesselCsv, LoadsComeBeforeMotion) {
  const VesselChannels channels(full_run());
  ASSERT_EQ(channels.load_names().size(), 32u);
  EXPECT_EQ(channels.names()[35], "hydro_mz_Nm");
  EXPECT_EQ(channels.names()[36], "x_m");
}

TEST(VesselCsv, LoadsHoldTheTaredCellsWithoutTheRawOnes) {
  const VesselChannels channels(full_run());
  const std::vector<std::string> names = channels.load_names();
  std::vector<double> values;
  channels.read(*full_record().vessel, values);
  const std::vector<double> loads = channels.loads(values);
  ASSERT_EQ(loads.size(), names.size());
  const auto place = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  EXPECT_EQ(place("cell1_N"), static_cast<std::ptrdiff_t>(names.size()));
  EXPECT_EQ(loads.at(static_cast<std::size_t>(place("cell2_tared_N"))), 32 - 2);
  EXPECT_EQ(loads.at(static_cast<std::size_t>(place("hydro_fx_N"))), 41);
  EXPECT_EQ(loads.back(), full_record().vessel->ice.y());
}

TEST(VesselCsv, ARunWithoutRestHasNothingToTare) {
  sim::RunInfo info = full_run();
  info.tare.reset();
  const VesselChannels channels(info);
  std::vector<double> values;
  channels.read(*full_record().vessel, values);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(values[18 + k], values[24 + k]);
}

TEST(VesselCsv, TellsOfGimbalLockAndWritesZeroRates) {
  sim::VesselRecord record = *full_record().vessel;
  record.state.pose.q = Quat(Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitY()));
  record.state.w = Vec3(1, 2, 3);
  const VesselChannels channels(full_run());
  std::vector<double> values;
  EXPECT_FALSE(channels.read(record, values));
  EXPECT_EQ(std::vector<double>(values.end() - 8, values.end() - 2), (std::vector<double>{0, 0, 0, 1, 2, 3}));
  record.state.pose.q = Quat::Identity();
  EXPECT_TRUE(channels.read(record, values));
}

TEST(VesselCsv, ARecordWithoutWhatTheRunHasIsABrokenContract) {
  sim::VesselRecord record = *full_record().vessel;
  record.hydro.reset();
  std::vector<double> values;
  EXPECT_THROW(VesselChannels(full_run()).read(record, values), ContractError);
}

/// A reader of the file alone finds m dv/dt = sum of the loads within 1e-6 of the largest, weight included.
TEST(VesselCsv, RoundingKeepsNewtonsLaw) {
  const double mass = 1500, h = 0.01;
  const Vec3 load(123.456789012345678, -0.00123456789012345, 14715.0 + 1.0 / 3);
  const Vec3 before(0.3, 1.0 / 7, -0.001), after = before + h / mass * (load + Vec3(0, 0, -9.81 * mass));
  sim::RunInfo info = full_run();
  info.has_carriage = info.has_cells = false;
  sim::StepRecord record = full_record();
  record.vessel->carriage.reset();
  record.vessel->contact.force.setZero();
  record.vessel->hydro->force = load;
  const auto read = [&](const Vec3& v, int first) {
    record.vessel->state.v = v;
    const auto values = cells_of(written(info, record).at(1));
    Vec3 x;
    for (int k = 0; k < 3; ++k) x[k] = std::stod(values[first + k]);
    return x;
  };
  const Vec3 found = mass * (read(after, 19) - read(before, 19)) / h - read(after, 7) - Vec3(0, 0, -9.81 * mass);
  EXPECT_LT(found.norm(), 1e-6 * 9.81 * mass * 1e-4);
}

}  // namespace vessel_csv_test
}  // namespace nilas::output
