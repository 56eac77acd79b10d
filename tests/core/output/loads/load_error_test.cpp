#include "core/output/loads/load_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/output/loads/load_error_json.h"
#include "tests/core/output/sample_run.h"

namespace nilas::output {
namespace load_error_test {

const std::vector<std::string> k_names{"contact_fx_N",   "contact_fy_N",  "contact_fz_N",    "contact_mx_Nm",
                                       "contact_my_Nm",  "contact_mz_Nm", "carriage_fx_N",   "carriage_fy_N",
                                       "carriage_mx_Nm", "hydro_fx_N",    "ice_resistance_N"};

/// Every channel with the values given, over one second.
struct Series {
  std::vector<std::vector<double>> values = std::vector<std::vector<double>>(k_names.size());
  mutable StepSeries table{k_names.size()};

  /// Valid until the next call.
  LoadRecord record() const {
    table = StepSeries(k_names.size());
    for (std::size_t k = 0; k < values[0].size(); ++k) {
      std::vector<double> row;
      for (const auto& channel : values) row.push_back(channel[k]);
      table.append(row);
    }
    return {k_names, SeriesPart(table, 0), {0, 1, 0, values[0].size(), ""}};
  }
};

Series all_channels(const std::vector<double>& values) {
  Series series;
  for (auto& channel : series.values) channel = values;
  return series;
}

/// The residuals of some steps.
struct Residuals {
  StepSeries table{LoadResiduals::k_columns};

  void add(const sim::StepRecord& record) {
    std::vector<double> row;
    LoadResiduals::add_to(row, record);
    table.append(row);
  }
  LoadResiduals told() const { return LoadResiduals(SeriesPart(table, 0)); }
};

Residuals residuals_of(int steps, double solver, double law) {
  Residuals residuals;
  sim::StepRecord record;
  sim::VesselRecord& vessel = record.vessel.emplace();
  vessel.solver_residual.force.x() = solver;
  vessel.law_residual.force.x() = law;
  for (int k = 0; k < steps; ++k) residuals.add(record);
  return residuals;
}

std::optional<LoadError> error_of(const LoadRecord& run, const Residuals& residuals,
                                  const TwinStatistics* twins = nullptr) {
  return load_error(run, residuals.told(), twins);
}

TEST(LoadError, IsThatOfTheLoadAlongTheCourseFirst) {
  Series series = all_channels({99, 99});
  series.values[10] = {1, -5};
  const auto error = error_of(series.record(), residuals_of(2, 0.5, 0));
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->channels.size(), 9u) << "moments about the joint and water loads are not mapped";
  const ChannelError& headline = error->channels[error->headline];
  EXPECT_EQ(headline.channel, "ice_resistance_N");
  EXPECT_EQ(headline.mean, -2);
  EXPECT_FALSE(headline.chaos.has_value()) << "two steps";
  EXPECT_EQ(headline.total, 0.5) << "the course is x";
  EXPECT_EQ(error->channels[6].total, 0.5);
}

TEST(LoadError, AddsPartsThatHoldStillAndChaosAsIndependent) {
  const Series series = all_channels(std::vector<double>(100, 7));
  TwinStatistics twins;
  twins.mean_loads.assign(k_names.size(), {7, 9});
  twins.horizon = 0.4;
  const Residuals residuals = residuals_of(100, 1, -2);
  EXPECT_DOUBLE_EQ(residuals.told().solver(0, series.record().window), 1);
  EXPECT_DOUBLE_EQ(residuals.told().law(0, series.record().window), 2 + 2 * 2 / 10.0);
  const auto error = error_of(series.record(), residuals, &twins);
  EXPECT_TRUE(error->from_twins);
  EXPECT_EQ(error->channels[0].mean, 8);
  const double chaos = 12.7062 * std::sqrt(3.0);  // one more draw of two
  EXPECT_NEAR(*error->channels[0].chaos, chaos, 1e-3);
  EXPECT_NEAR(error->channels[0].total, std::hypot(chaos, 3.4), 1e-3);
  EXPECT_EQ(*error_of(series.record(), residuals)->channels[0].chaos, 0) << "a constant load";
}

TEST(LoadError, TwinsThatPartTooLateDoNotStandForChaos) {
  std::vector<double> values;
  for (int k = 0; k < 640; ++k) values.push_back(k / 10 % 2 == 0 ? 1 : -1);  // 64 batches, up and down
  Series series = all_channels(values);
  for (std::size_t c = 6; c < series.values.size(); ++c) series.values[c].assign(640, 3);
  TwinStatistics twins;
  twins.mean_loads.assign(k_names.size(), {0, 0, 0});
  const auto chaos = [&](std::optional<double> horizon) {
    twins.horizon = horizon;
    const auto error = error_of(series.record(), residuals_of(640, 0, 0), &twins);
    EXPECT_EQ(error->chaos_from_twins, horizon == 0.3);
    EXPECT_EQ(*error->channels[6].chaos, *error->channels[0].chaos) << "of the carriage that of the contact load";
    return *error->channels[0].chaos;
  };
  EXPECT_EQ(chaos(0.3), 0);
  EXPECT_EQ(chaos(0.8), chaos(std::nullopt));
  EXPECT_EQ(chaos(0.8), *error_of(series.record(), residuals_of(640, 0, 0))->channels[0].chaos);
}

TEST(LoadError, CountsTheWindowAlone) {
  std::vector<double> values(100, 3);
  for (std::size_t k = 50; k < 100; ++k) values[k] = 7;
  const Series series = all_channels(values);
  LoadRecord record = series.record();
  record.window.first = 50;
  Residuals residuals = residuals_of(50, 4, 0);
  for (int k = 0; k < 50; ++k) {
    sim::StepRecord step;
    sim::VesselRecord& vessel = step.vessel.emplace();
    vessel.course = Vec2(0.6, 0.8);
    vessel.solver_residual.force = Vec3(1, 2, 0);
    vessel.law_residual.force = Vec3(-1, 2, 0);
    residuals.add(step);
  }
  const auto error = error_of(record, residuals);
  EXPECT_EQ(error->channels.back().mean, 7);
  EXPECT_EQ(error->channels.front().solver, 1) << "fx";
  EXPECT_DOUBLE_EQ(error->channels.back().solver, 0.6 * 1 + 0.8 * 2) << "along the course, if none cancel";
  EXPECT_DOUBLE_EQ(error->channels.back().law, (-0.6 + 1.6) * (1 + 2 / std::sqrt(50.0)));
}

/// A load that swings once over the window: batches of a 16th and shorter see a slow course, not chance.
std::vector<double> one_swing() {
  std::vector<double> values;
  constexpr int k_steps = 640;
  for (int k = 0; k < k_steps; ++k) values.push_back(10 + 5 * std::sin(2 * k_pi * k / k_steps));
  return values;
}

TEST(LoadError, WhereIceBrokeSlowChangesAreChanceToo) {
  const Series series = all_channels(one_swing());
  const Residuals none = residuals_of(640, 0, 0);
  LoadRecord run = series.record();
  const auto whole = error_of(run, none);
  run.ice_broke = true;
  const auto broken = error_of(run, none);
  EXPECT_FALSE(whole->ice_broke);
  EXPECT_TRUE(broken->ice_broke);
  EXPECT_LT(*whole->channels[0].chaos, 0.5);
  EXPECT_GT(*broken->channels[0].chaos, 1.5);
  EXPECT_NE(load_error_json(*whole, nullptr)["methods"]["chaos"],
            load_error_json(*broken, nullptr)["methods"]["chaos"]);
}

TEST(LoadError, IsALowerBoundWhereTheSolverStoppedShortInTheWindow) {
  const Series series = all_channels(std::vector<double>(200, 7));
  Residuals residuals;
  sim::StepRecord record;
  record.vessel.emplace();
  for (int k = 0; k < 200; ++k) {
    record.solver_short = k < 3;
    residuals.add(record);
  }
  LoadRecord run = series.record();
  EXPECT_DOUBLE_EQ(residuals.told().share_short(run.window, false), 3.0 / 200);
  EXPECT_TRUE(error_of(run, residuals)->solver_at_least);
  run.window.first = 2;
  EXPECT_FALSE(error_of(run, residuals)->solver_at_least) << "one step in 198";
}

TEST(LoadError, IsALowerBoundWhereIceBrokeAndResidualsAreLargeForTheSpeed) {
  const Series series = all_channels(std::vector<double>(100, 7));
  const auto at_least = [&](double residual, double speed, bool ice_broke) {
    sim::StepRecord record;
    record.residuals.law_map_m_s = residual;
    record.vessel.emplace().carriage.emplace();
    record.vessel->state.v = Vec3(speed, 0, 0);
    Residuals residuals;
    for (int k = 0; k < 100; ++k) residuals.add(record);
    LoadRecord run = series.record();
    run.ice_broke = ice_broke;
    return error_of(run, residuals)->solver_at_least;
  };
  EXPECT_TRUE(at_least(5e-4, 0.3, true)) << "the solver met the tolerance that it was given";
  EXPECT_FALSE(at_least(2e-4, 0.3, true));
  EXPECT_FALSE(at_least(5e-4, 0.3, false)) << "nothing that a small error can turn";
  EXPECT_FALSE(at_least(5e-4, 0, true)) << "no speed to hold it against";
}

TEST(LoadError, IsWrittenWithItsMethods) {
  const Series series = all_channels(std::vector<double>(100, 7));
  const auto json = load_error_json(*error_of(series.record(), residuals_of(100, 1, 0)), nullptr);
  EXPECT_EQ(json["channel"], "ice_resistance_N");
  EXPECT_TRUE(json["step_N"].is_null());
  EXPECT_EQ(json["known"].size(), 3u);
  EXPECT_EQ(json["runs"], 1);
  EXPECT_EQ(json["channels"]["contact_fx_N"]["solver"], 1);
  for (const char* part : {"solver", "law", "chaos", "step"}) EXPECT_TRUE(json["methods"].contains(part)) << part;
}

TEST(LoadError, NothingWithoutAVessel) {
  const StepSeries none(0);
  EXPECT_FALSE(error_of({{}, SeriesPart(none, 0), {}}, {}).has_value());
  EXPECT_FALSE(error_of({{}, SeriesPart(none, 0), {0, 1, 0, 100, ""}}, {}).has_value()) << "of a run with steps";
}

TEST(LoadError, OfALawThatErrsIsALowerBound) {
  const Series series = all_channels(std::vector<double>(100, 7));
  const auto exact = error_of(series.record(), residuals_of(100, 1, 0));
  const auto other = error_of(series.record(), residuals_of(100, 1, -2));
  EXPECT_FALSE(exact->law_at_least || exact->at_least());
  EXPECT_TRUE(other->law_at_least && other->at_least());
  EXPECT_FALSE(other->solver_at_least) << "all steps were solved";
  EXPECT_EQ(load_error_json(*other, nullptr)["law_at_least"], true);
}

}  // namespace load_error_test
}  // namespace nilas::output
