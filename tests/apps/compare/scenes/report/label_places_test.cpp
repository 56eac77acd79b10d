/// Places of labels in pictures.
#include "apps/compare/scenes/report/label_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace label_places_test {

using namespace nilas::compare;

/// Fails where two labels of one height overlap.
void expect_apart(const std::vector<LabelledMark>& marks, const std::vector<LabelPlace>& places) {
  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const double wide = static_cast<double>(marks[a].letters + marks[b].letters) / 2;
      EXPECT_TRUE(std::abs(places[a].x - places[b].x) >= wide || std::abs(places[a].y - places[b].y) >= 1.7)
          << a << " and " << b;
    }
}

TEST(LabelPlaces, AMarkAloneHasItsLabelBesideIt) {
  const auto places = place_labels({{20, 20, 2}}, 60, 60);
  EXPECT_NEAR(std::hypot(places[0].x - 20, places[0].y - 20), 1.9, 1e-12);
  EXPECT_FALSE(places[0].far);
}

TEST(LabelPlaces, LabelsOfMarksAtOnePlaceLieApart) {
  std::vector<LabelledMark> marks;
  for (int k = 0; k < 9; ++k) marks.push_back({30 + 0.3 * k, 30, 2});
  expect_apart(marks, place_labels(marks, 60, 60));
}

TEST(LabelPlaces, LabelsStayInThePicture) {
  for (const auto& place : place_labels({{0, 0, 3}, {60, 60, 3}, {60, 0, 3}}, 60, 60)) {
    EXPECT_GE(place.x, 1.5);
    EXPECT_LE(place.x, 58.5);
    EXPECT_GE(place.y, 0.9);
    EXPECT_LE(place.y, 59.1);
  }
}

/// A row of many marks, as settings make whose errors may be chance: each has its label, and far ones have a line.
TEST(LabelPlaces, ARowOfMarksFansOut) {
  std::vector<LabelledMark> marks;
  for (int k = 0; k < 14; ++k) marks.push_back({20 + 1.1 * k, 10, 2});
  const auto places = place_labels(marks, 60, 60);
  expect_apart(marks, places);
  for (std::size_t k = 0; k < marks.size(); ++k)
    if (!places[k].far) {
      EXPECT_LT(std::hypot(places[k].x - marks[k].x, places[k].y - marks[k].y), 2.8) << k;
    }
}

}  // namespace label_places_test
