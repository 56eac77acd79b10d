/// The figures that a report computes, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/report/figures/exceedance.h"
#include "apps/report/figures/ice_cover.h"
#include "apps/report/figures/place_load.h"
#include "apps/report/figures/spectrum.h"
#include "apps/report/figures/thin.h"
#include "core/base/error.h"
#include "core/base/statistics.h"

namespace report_figures_test {

using namespace nilas;
using namespace nilas::report;

/// An area under a spectrum between two frequencies [Hz].
double area(const Spectrum& spectrum, double low, double high) {
  double sum = 0;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k)
    if (spectrum.frequency[k] >= low && spectrum.frequency[k] <= high) sum += spectrum.density[k] * spectrum.resolution;
  return sum;
}

/// A sine of amplitude a has the mean square a^2 / 2, at its own frequency.
TEST(ReportFigures, TheSpectrumOfASineHasItsMeanSquareAtItsFrequency) {
  constexpr double h = 0.01, frequency = 6.25, amplitude = 3;
  std::vector<double> series;
  for (int k = 0; k < 4096; ++k) series.push_back(7 + amplitude * std::sin(2 * k_pi * frequency * h * k));
  const auto spectrum = spectrum_of(series, h);
  ASSERT_TRUE(spectrum);
  EXPECT_EQ(spectrum->segment, 512u) << "the longest power of two of which eight fit half over each other";
  EXPECT_EQ(spectrum->segments, 15u);
  EXPECT_NEAR(area(*spectrum, 0, 50), amplitude * amplitude / 2, 1e-4);
  EXPECT_NEAR(area(*spectrum, 5.8, 6.7), amplitude * amplitude / 2, 1e-4);
  EXPECT_LT(area(*spectrum, 0, 5), 1e-4) << "the mean is taken out";
  EXPECT_LT(spectrum->low, 1);
  EXPECT_GT(spectrum->high, 1);
}

/// Parseval's theorem for one segment: the area is the mean square of the windowed deviation over that of the window.
TEST(ReportFigures, TheSpectrumKeepsTheMeanSquare) {
  std::vector<double> series;
  std::uint32_t state = 1;
  for (int k = 0; k < 256; ++k) series.push_back(static_cast<double>((state = 1664525 * state + 1013904223) >> 16));
  const double mean = mean_of(series);
  double squares = 0, windows = 0;
  for (std::size_t k = 0; k < series.size(); ++k) {
    const double window = std::pow(std::sin(k_pi * static_cast<double>(k) / 256), 2);
    squares += std::pow(window * (series[k] - mean), 2);
    windows += window * window;
  }
  const Spectrum spectrum = spectrum_of(series, 0.5, 256);
  EXPECT_EQ(spectrum.segments, 1u);
  EXPECT_NEAR(area(spectrum, 0, 1) / (squares / windows), 1, 1e-12);
  EXPECT_FALSE(spectrum_of(std::vector<double>(71, 1.0), 0.5)) << "too short";
  EXPECT_TRUE(spectrum_of(std::vector<double>(72, 1.0), 0.5));
}

TEST(ReportFigures, ExceedanceCountsStepsAndPeaks) {
  const std::vector<double> loads{0, 5, 3, 0, 2, 8, 8, 1, 4, 0};
  const Curve steps = step_exceedance("steps", loads, 1);
  EXPECT_EQ(steps.x, (std::vector<double>{8, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(steps.y, (std::vector<double>{20, 30, 40, 50, 60, 70, 100})) << "two of ten steps reach 8";
  const auto peaks = local_peaks(loads, 1.5);
  EXPECT_EQ(peaks, (std::vector<double>{5, 8, 4}));
  const Curve curve = peak_exceedance("peaks", peaks, 1e-3);
  EXPECT_EQ(curve.x, (std::vector<double>{8e-3, 5e-3, 4e-3}));
  EXPECT_EQ(curve.y, (std::vector<double>{25, 50, 75}));
  std::vector<double> many(10000);
  std::iota(many.begin(), many.end(), 0.0);
  const Curve thin = step_exceedance("steps", many, 1, 100);
  EXPECT_LE(thin.x.size(), 100u);
  const Curve damaged = step_exceedance("steps", {1, std::nan(""), 3}, 1);
  EXPECT_EQ(damaged.x, (std::vector<double>{3, 1})) << "a cell that is no number does not count";
  EXPECT_EQ(thin.x.front(), 9999) << "the largest loads stay";
  EXPECT_NEAR(thin.y.front(), 0.01, 1e-12);
}

TEST(ReportFigures, ThinningKeepsPeaksAndMeans) {
  std::vector<double> time, load;
  for (int k = 1; k <= 100000; ++k) {
    time.push_back(0.01 * k);
    load.push_back(k == 77777 ? 500 : k % 2);
  }
  load[3] = std::nan("");
  const Curve curve = thinned("load", time, load, 2, 1000);
  ASSERT_EQ(curve.x.size(), 1000u);
  EXPECT_EQ(*std::max_element(curve.high.begin(), curve.high.end()), 1000);
  EXPECT_DOUBLE_EQ(curve.y[500], 1) << "twice the mean of 0 and 1";
  EXPECT_EQ(curve.low[500], 0);
  EXPECT_DOUBLE_EQ(curve.x.back(), 1000);
  const Curve whole = thinned("load", {1, 2}, {3, 4});
  EXPECT_EQ(whole.y, (std::vector<double>{3, 4}));
  EXPECT_TRUE(whole.low.empty());
}

std::vector<Vec3> square(double x, double y, double side) {
  return {{x, y, 0}, {x + side, y, 0}, {x + side, y + side, 0.1}, {x, y + side, 0.1}};
}

TEST(ReportFigures, TheCoverOfKnownSquares) {
  const WaterWindow window{.middle = {5, 1}, .ahead = {1, 0}, .length = 4, .width = 2};
  EXPECT_DOUBLE_EQ(ice_cover({}, window), 0);
  EXPECT_DOUBLE_EQ(ice_cover({square(4, 0.5, 1)}, window), 1.0 / 8);
  EXPECT_DOUBLE_EQ(ice_cover({square(6, 1, 3), square(-1, 0, 1)}, window), 1.0 / 8) << "cut by the window; outside";
  EXPECT_DOUBLE_EQ(ice_cover({square(0, -5, 20)}, window), 1);
  const WaterWindow turned{.middle = {5, 1}, .ahead = {0, 1}, .length = 2, .width = 4};
  EXPECT_DOUBLE_EQ(ice_cover({square(4, 0.5, 1)}, turned), 1.0 / 8) << "the same window, named otherwise";
  auto clockwise = square(4, 0.5, 1);
  std::reverse(clockwise.begin(), clockwise.end());
  EXPECT_DOUBLE_EQ(ice_cover({clockwise}, window), 1.0 / 8);
}

/// A box of 8 m by 2 m by 1 m about the origin.
geometry::TriangleMesh box() {
  geometry::TriangleMesh mesh;
  for (const double x : {-4.0, 4.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-0.5, 0.5}) mesh.vertices.emplace_back(x, y, z);
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

TEST(ReportFigures, TheOutlineIsMeasuredFromTheBow) {
  const WaterlineOutline outline(box(), 0, Vec2::UnitX());
  EXPECT_DOUBLE_EQ(outline.length(), 20);
  EXPECT_NEAR(outline.along({4.5, 0}), 0, 1e-12);
  EXPECT_NEAR(outline.along({4, 0.5}), 0.5, 1e-12) << "to port";
  EXPECT_NEAR(outline.along({3, 1.2}), 2, 1e-12);
  EXPECT_NEAR(outline.along({3, -1}), -2, 1e-12);
  const WaterlineOutline against_drift(box(), 9, -Vec2::UnitX());
  EXPECT_DOUBLE_EQ(against_drift.length(), 20) << "a body that does not reach the water counts as a whole";
  EXPECT_NEAR(against_drift.along({-4, 0}), 0, 1e-12);
  EXPECT_THROW(WaterlineOutline(geometry::TriangleMesh{}, 0, Vec2::UnitX()), InputError);
}

/// Contacts of two steps: two floes at the bow at once, then one on the starboard side.
HullContacts contacts() {
  HullContacts all;
  const auto add = [&](std::int64_t step, std::int64_t floe, const Vec3& place, const Vec3& normal, double force) {
    all.time.push_back(0.1 * static_cast<double>(step));
    all.step.push_back(step);
    all.other.push_back(floe);
    all.place.push_back(place);
    all.normal.push_back(normal);
    all.force.emplace_back(force * normal);
    all.impulse.emplace_back(0.1 * force * normal);
    all.crushes.push_back(true);
  };
  add(1, 7, {4, 0.02, 0.01}, -Vec3::UnitX(), 100);
  add(1, 8, {4, 0.03, 0.02}, -Vec3::UnitX(), 50);
  add(2, 7, {3, -1, 0.01}, Vec3::UnitY(), 120);
  return all;
}

TEST(ReportFigures, LoadByPlaceSumsToTheWholeImpulse) {
  const WaterlineOutline outline(box(), 0, Vec2::UnitX());
  const PlaceLoad load = place_load(contacts(), outline);
  EXPECT_DOUBLE_EQ(load.width, 20.0 / 160);
  ASSERT_EQ(load.cells.size(), 2u);
  EXPECT_NEAR(load.impulse, 0.1 * (100 + 50 + 120), 1e-12);
  EXPECT_NEAR(load.cells[0].impulse + load.cells[1].impulse, load.impulse, 1e-12);
  const PlaceCell &starboard = load.cells[0], &bow = load.cells[1];
  EXPECT_NEAR(starboard.along, -2, load.width);
  EXPECT_NEAR(bow.impulse, 15, 1e-12);
  EXPECT_NEAR(bow.peak, 150, 1e-12) << "both floes press in the same step";
  EXPECT_NEAR(bow.place.y(), (100 * 0.02 + 50 * 0.03) / 150, 1e-12);
}

TEST(ReportFigures, PressureFallsWithTheAreaOfAPanel) {
  const WaterlineOutline outline(box(), 0, Vec2::UnitX());
  const auto panels = panel_pressures(contacts(), outline, 0.5);
  ASSERT_EQ(panels.size(), 4u) << "0.5, 1, 2 and 4 m; a quarter of the outline is 5 m";
  for (const PanelPressure& panel : panels) {
    EXPECT_NEAR(panel.pressure * panel.area, 150, 1e-9) << "both floes at the bow fit on a panel of any size";
    EXPECT_NEAR(panel.time, 0.1, 1e-12);
  }
}

}  // namespace report_figures_test
