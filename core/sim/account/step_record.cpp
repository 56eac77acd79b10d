#include "core/sim/account/step_record.h"

namespace nilas::sim {

const char* to_string(Phase phase) {
  switch (phase) {
    case Phase::hydro:
      return "hydro";
    case Phase::detection:
      return "detection";
    case Phase::assembly:
      return "assembly";
    case Phase::solver:
      return "solver";
    case Phase::integration:
      return "integration";
    case Phase::fracture:
      return "fracture";
    case Phase::output:
      return "output";
  }
  return "";
}

std::vector<std::string> warning_texts(const RunInfo& info) {
  std::vector<std::string> texts;
  for (const Fault& warning : info.warnings) texts.push_back(warning.text());
  return texts;
}

}  // namespace nilas::sim
