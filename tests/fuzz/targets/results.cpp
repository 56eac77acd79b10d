/// What runs and other programs hand over: replays, results in JSON, lines of a controller.
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/channels.h"
#include "core/output/replay/piece.h"
#include "core/output/run/run_summary.h"
#include "core/vessel/remote/remote_lines.h"
#include "tests/fuzz/targets.h"

namespace nilas::fuzz {

void replay(std::string_view bytes) {
  read_or_refuse([&] {
    for (const auto& piece : output::replay::pieces_of(bytes, "replay.bin").pieces)
      read_or_refuse([&] { output::replay::unpacked(piece.packed); });
  });
}

void control_lines(std::string_view bytes) {
  static Channels channels = [] {
    Channels made;
    made.add("rudder", "rad", 0);
    made.add("force_x", "N", 0);
    return made;
  }();
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) vessel::obey(line, channels);
}

void json_results(std::string_view bytes) {
  file_with("summary.json", bytes);
  const auto folder = file_with("summary.json", bytes).parent_path();
  read_or_refuse([&] { output::to_json(output::read_run_summary(folder)); });
}

}  // namespace nilas::fuzz
