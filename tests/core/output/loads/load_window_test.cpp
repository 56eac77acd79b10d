#include "core/output/loads/load_window.h"

#include <gtest/gtest.h>

namespace nilas::output {
namespace load_window_test {

LoadCourse course_of_ten_seconds() {
  return {.start = 0, .h = 0.01, .steps = 1000, .asked = {}, .ramp_end = {}, .first_ice = {}};
}

TEST(LoadWindow, IsAsAskedInWholeSteps) {
  LoadCourse course = course_of_ten_seconds();
  course.asked = {4, 10};
  course.ramp_end = 5;
  const LoadWindow window = load_window(course);
  EXPECT_EQ(window.reason, "as asked; it holds the ramp (to 5 s)");
  EXPECT_EQ(window.first, 400u);
  EXPECT_EQ(window.last, 1000u);
  EXPECT_DOUBLE_EQ(window.from, 4);
  EXPECT_DOUBLE_EQ(window.to, 10);
  std::vector<double> series(1000, 1);
  series[400] = 2;
  EXPECT_EQ(window.of(series).size(), 600u);
  EXPECT_EQ(window.of(series).front(), 2);
}

TEST(LoadWindow, BeginsWithIceOrWithTheEndOfTheRampWhicheverIsLater) {
  LoadCourse course = course_of_ten_seconds();
  EXPECT_EQ(load_window(course).reason, "the whole run");
  course.ramp_end = 2;
  EXPECT_EQ(load_window(course).first, 200u);
  course.first_ice = 1.5;
  EXPECT_EQ(load_window(course).first, 200u);
  course.first_ice = 6.25;
  EXPECT_EQ(load_window(course).first, 625u);
  EXPECT_EQ(load_window(course).reason, "from the first contact with ice");
}

TEST(LoadWindow, SaysWhereTheRampOutlastsTheRun) {
  LoadCourse course = course_of_ten_seconds();
  course.ramp_end = 20;
  course.first_ice = 3;
  const LoadWindow window = load_window(course);
  EXPECT_EQ(window.first, 300u);
  EXPECT_NE(window.reason.find("the ramp lasts until 20 s"), std::string::npos) << window.reason;
  course.first_ice.reset();
  EXPECT_EQ(load_window(course).first, 0u);
}

TEST(LoadWindow, OfARunThatStoppedBeforeItIsTheWholeRun) {
  LoadCourse course = course_of_ten_seconds();
  course.asked = {12, 20};
  const LoadWindow window = load_window(course);
  EXPECT_EQ(window.steps(), 1000u);
  EXPECT_NE(window.reason.find("no step in the window asked for"), std::string::npos);
}

}  // namespace load_window_test
}  // namespace nilas::output
