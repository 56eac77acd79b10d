#include "hydro/radiation/passive_fit.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "hydro/radiation/passivity.h"
#include "tests/hydro/radiation/radiation_cases.h"

namespace nilas::hydro::passive_fit_test {

using radiation_cases::closed_database;
using radiation_cases::closed_poles;
using radiation_cases::closed_transform;
using radiation_cases::sphere_database;

struct Prepared {
  RadiationDamping damping;
  Retardation kernel;
  RadiationSamples samples;
};
Prepared prepare(const Database& database) {
  RadiationDamping damping = prepare_damping(database);
  Retardation kernel = retardation(damping);
  RadiationSamples samples = radiation_samples(damping, kernel);
  return {std::move(damping), std::move(kernel), std::move(samples)};
}

/// Four poles are those of the function itself. The samples err by the spline's 1e-5, and so do the poles.
TEST(PassiveFit, RecoversARationalFunction) {
  const Prepared data = prepare(closed_database());
  for (const auto& modes : data.damping.groups) {
    const PassiveFit fit = passive_fit(data.samples, modes, 4);
    EXPECT_LT(fit.error, 1e-3);
    ASSERT_EQ(fit.model.poles.pair.size(), 2);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT(std::abs(fit.model.poles.pair[k] - closed_poles()[k]), 2e-2);
    // Heave has the peak 1000 max Re H of its own; compare the shape by the ratio to the closed form.
    const double scale = data.damping.scale[modes[0]] * data.damping.scale[modes[0]];
    const double size = radiation_cases::closed_matrix()(modes[0], modes[0]);
    for (const double w : {0.1, 0.7, 1.0, 2.0, 5.0})
      EXPECT_LT(std::abs(fit.model({0, w})(0, 0) * scale / size - closed_transform({0, w})), 2e-3) << w;
    EXPECT_LT(std::abs(fit.model(0.0)(0, 0)), 1e-12);
    EXPECT_TRUE(is_passive(fit.model, 1e-6));
  }
}

/// The same order is found by the error that is asked for; two poles cannot do it.
TEST(PassiveFit, ChoosesTheOrderByTheError) {
  const Prepared data = prepare(closed_database());
  EXPECT_EQ(chosen_fit(data.samples, {2}, 0.01).model.poles.count(), 4);
  EXPECT_EQ(chosen_fit(data.samples, {2}, 0.01, 3).model.poles.count(), 3);
  EXPECT_THROW(chosen_fit(data.samples, {2}, 1e-12), InputError);
}

/// The retardation function of the model against the integral over the damping: Parseval's theorem makes their
/// difference that of the damping, within 1 %.
TEST(PassiveFit, OfTheSphereIsPassiveAndWithinOnePercent) {
  const Prepared data = prepare(sphere_database());
  for (const auto& modes : data.damping.groups) {
    const PassiveFit fit = chosen_fit(data.samples, modes, 0.01);
    double difference = 0, whole = 0;
    const auto& t = data.kernel.scaled.knots();
    for (std::size_t k = 0; k < t.size(); ++k)
      for (std::size_t i = 0; i < modes.size(); ++i)
        for (std::size_t j = 0; j < modes.size(); ++j) {
          double of_model = 0;
          std::size_t at = 0;
          const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
          for (const double p : fit.model.poles.real)
            of_model += (fit.model.residues[at++](row, column) * std::exp(p * t[k])).real();
          for (const auto& p : fit.model.poles.pair)
            of_model += 2 * (fit.model.residues[at++](row, column) * std::exp(p * t[k])).real();
          const double of_file = data.kernel.scaled.values()(static_cast<Eigen::Index>(k), modes[i] + 6 * modes[j]);
          difference += std::pow(of_model - of_file, 2);
          whole += of_file * of_file;
        }
    EXPECT_LT(fit.error, 0.01);
    EXPECT_LT(std::sqrt(difference / whole), 0.012);
    EXPECT_TRUE(is_passive(fit.model, 1e-6));
    double lowest = 1;
    for (double w = 1e-3; w < 1e3; w *= 1.01) lowest = std::min(lowest, lowest_damping(fit.model, w));
    EXPECT_GT(lowest, -1e-12);  // rounding of a damping whose peak is 1
  }
}

/// A real ship with sway, roll and yaw coupled, whose file has irregular frequencies: it is cut where the damping turns
/// negative, 3.16 rad/s, which is a wave of 6 m for a hull of 200 m. The fit stays passive.
TEST(PassiveFit, OfAShipIsPassive) {
  DatabaseSettings settings;
  settings.length = 1;
  settings.density = 1025;
  settings.gravity = 9.81;
  settings.volume = 97960.9;
  const Prepared data =
      prepare(read_database(std::filesystem::path(NILAS_SOURCE_DIR) / "tests/data/hydro/mss/fpso.1", settings));
  ASSERT_EQ(data.damping.groups, (std::vector<std::vector<int>>{{0, 2, 4}, {1, 3, 5}}));
  for (const auto& modes : data.damping.groups) {
    const PassiveFit fit = chosen_fit(data.samples, modes, 0.05);
    EXPECT_LT(fit.error, 0.05);
    EXPECT_TRUE(is_passive(fit.model, 1e-6));
    double lowest = 1;
    for (double w = 1e-3; w < 1e3; w *= 1.01) lowest = std::min(lowest, lowest_damping(fit.model, w));
    EXPECT_GT(lowest, -1e-12);
  }
}

/// The damping of the closed form is positive. Turning the sign of its slower pole pair makes it negative around 1
/// rad/s, and the Hamiltonian matrix must give both ends of that range. The ends follow from a fine search.
TEST(Passivity, FindsTheRangeOfNegativeDamping) {
  const Prepared data = prepare(closed_database());
  PassiveFit fit = passive_fit(data.samples, {2}, 4);
  EXPECT_TRUE(crossings(fit.model, 1e-6).empty());
  fit.model.residues[0] *= -0.3;
  const double margin = 1e-3;
  const std::vector<double> found = crossings(fit.model, margin);
  EXPECT_FALSE(is_passive(fit.model, margin));
  std::vector<double> searched;
  const double step = 1e-4;
  for (double w = step; w < 50; w += step)
    if ((lowest_damping(fit.model, w) + margin) * (lowest_damping(fit.model, w + step) + margin) < 0)
      searched.push_back(w + 0.5 * step);
  ASSERT_FALSE(searched.empty());
  ASSERT_EQ(found.size(), searched.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], searched[k], step);
}

}  // namespace nilas::hydro::passive_fit_test
