#include "core/output/tables/steps_csv.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"

namespace nilas::output {
namespace steps_csv_test {

using test::full_record;
using test::full_run;
using test::lines_of;
using test::ScratchFolder;

TEST(StepsCsv, HasItsColumnsInOrder) {
  const ScratchFolder folder;
  StepsCsv csv(folder / "steps.csv", full_run());
  EXPECT_EQ(lines_of(folder / "steps.csv").at(0),
            "time_s,floes,contacts,islands,iterations,status,law_map_m_s,natural_map_m_s,natural_map_rms_m_s,"
            "ccp_map_m_s,penetration_rate_m_s,complementarity_J,cone_violation_m_s,slip_angle_deg,creep_m_s,"
            "bipotential_J,momentum_sqrtJ,penetration_max_m,penetration_mean_m,kinetic_J,potential_J,work_drag_J,"
            "work_carriage_J,friction_J,impact_J,stabilisation_J,fracture_J,crushing_J,integrator_J,imbalance_J,"
            "momentum_imbalance_Ns,angular_momentum_imbalance_Nms,momentum_scale_Ns,angular_momentum_scale_Nms,"
            "ms_hydro,ms_detection,ms_assembly,ms_solver,ms_integration,ms_fracture,ms_output,state_hash");
}

TEST(StepsCsv, WritesARecord) {
  const ScratchFolder folder;
  StepsCsv csv(folder / "steps.csv", full_run());
  csv.row(full_record());
  EXPECT_EQ(lines_of(folder / "steps.csv").at(1),
            "0.01,2,3,1,17,converged,1e-07,0,0,0,0,0,0,0,0,0,0.1,0.002,0.001,5,-6,7,-8,0.5,0.25,0.125,0,0,-0.0625,"
            "1e-12,1e-13,2e-13,2,4,1,2,3,4,5,6,7,00000000000000ab");
}

TEST(StepsCsv, ElasticContactsAddTheirEnergyAndTheirLoss) {
  const ScratchFolder folder;
  sim::RunInfo info = full_run();
  info.elastic_contacts = true;
  StepsCsv csv(folder / "steps.csv", info);
  sim::StepRecord record = full_record();
  record.ledger.elastic = 3;
  record.ledger.damping = 4;
  csv.row(record);
  const auto lines = lines_of(folder / "steps.csv");
  EXPECT_NE(lines.at(0).find("potential_J,elastic_J,work_drag_J,work_carriage_J,damping_J,friction_J"),
            std::string::npos);
  EXPECT_NE(lines.at(1).find(",5,-6,3,7,-8,4,0.5,"), std::string::npos) << lines.at(1);
}

TEST(StepsCsv, ALedgerOfOtherWorksIsABrokenContract) {
  const ScratchFolder folder;
  StepsCsv csv(folder / "steps.csv", full_run());
  sim::StepRecord record = full_record();
  record.ledger.works.pop_back();
  EXPECT_THROW(csv.row(record), ContractError);
}

TEST(StepsCsv, AFullDiskEndsIt) { EXPECT_THROW(StepsCsv("/dev/full", full_run()), FileError); }

}  // namespace steps_csv_test
}  // namespace nilas::output
