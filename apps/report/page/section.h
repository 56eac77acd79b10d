#pragma once
/// The parts of a report's page.
#include <string>
#include <vector>

#include "apps/report/figures/curve.h"

namespace nilas::report {

struct PageTable {
  std::vector<std::string> head = {};
  std::vector<std::vector<std::string>> rows = {};  ///< the first cell of each names it
  std::string caption = {};                         ///< empty: none
};

/// A drawing as an <svg> element, which takes its colours from the page's style sheet.
struct Drawing {
  std::string svg = {}, caption = {};
};

struct Section {
  std::string id = {}, title = {};
  std::vector<std::string> text = {};  ///< whole sentences, a paragraph each
  std::vector<Drawing> drawings = {};
  std::vector<Plot> plots = {};
  std::vector<PageTable> tables = {};
  std::vector<std::string> gaps = {};  ///< what is not shown, and why
  bool has_hull = false;               ///< true: the page draws the load by place here
};

}  // namespace nilas::report
