#include "apps/compare/workshop/narrator.h"

#include <unistd.h>

#include <iostream>
#include <sstream>

#include "core/output/text/console.h"

namespace nilas::compare {

void Narrator::line(const std::string& text) const {
  if (!quiet_) (json_ ? std::cerr : std::cout) << text << "\n" << std::flush;
}

void Narrator::sentences(const std::string& text) const {
  const bool terminal = ::isatty(json_ ? STDERR_FILENO : STDOUT_FILENO) != 0;
  std::istringstream lines(text);
  for (std::string one; std::getline(lines, one);)
    line(terminal && !one.starts_with("  ") ? output::wrapped(one, 0) : one);
}

void Narrator::warning(const std::string& sentence) { std::cerr << "warning: " << sentence << "\n"; }

}  // namespace nilas::compare
