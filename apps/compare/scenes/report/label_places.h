#pragma once
/// Places for the labels of marks, so that they cover neither each other nor a mark, and few bars.
#include <cstddef>
#include <vector>

namespace nilas::compare {

/// A mark with its bars, and the number of letters of its label. Lengths are in widths of a letter, y upwards.
struct LabelledMark {
  double x = 0, y = 0;
  std::size_t letters = 1;
  double left = x, right = x;  ///< ends of the bar beside it
  double low = y, high = y;    ///< ends of the bar above and below it
};

/// The middle of a label.
struct LabelPlace {
  double x = 0, y = 0;
  bool far = false;             ///< a line should lead to its mark
  double end_x = 0, end_y = 0;  ///< the end of that line, before the label
};

/// The places in the order of the marks, of which the most important come first. Labels stay between 0 and `width`, and
/// 0 and `height`, where there is room.
std::vector<LabelPlace> place_labels(const std::vector<LabelledMark>& marks, double width, double height);

}  // namespace nilas::compare
