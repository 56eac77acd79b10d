#include "core/vessel/remote/remote_lines.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/json_text.h"

namespace nilas::vessel {

namespace {

using Json = nlohmann::ordered_json;

Json array_of(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// The fault of a name that is no command.
std::string no_command(const std::string& name, const Channels& commands) {
  std::vector<std::string> names;
  std::string all;
  for (int k = 0; k < commands.size(); ++k) {
    if (!commands.is_command(k)) continue;
    names.push_back(commands.name(k));
    all += (all.empty() ? "" : ", ") + commands.name(k);
  }
  if (commands.find(name) >= 0) return "'" + name + "' is measured and takes no command; allowed: " + all;
  const std::string near = nearest_name(name, names);
  return "there is no command '" + name + "'; allowed: " + all + (near.empty() ? "" : "; nearest: " + near);
}

/// The values by name, either of commands or of what is measured.
Json values_of(const Channels& channels, bool commands) {
  Json values = Json::object();
  for (int k = 0; k < channels.size(); ++k)
    if (channels.is_command(k) == commands) values[channels.name(k)] = channels[k];
  return values;
}

}  // namespace

std::string line_of(const Measured& state, const Channels& channels) {
  const Mat3 R = state.q.toRotationMatrix();
  Json line;
  line["time_s"] = state.time;
  line["step"] = state.step;
  line["position_m"] = array_of(state.p);
  line["yaw_rad"] = std::atan2(R(1, 0), R(0, 0));
  line["pitch_rad"] = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
  line["roll_rad"] = std::atan2(R(2, 1), R(2, 2));
  line["velocity_m_s"] = array_of(state.v);
  line["speeds_m_s"] = array_of(R.transpose() * state.v);
  line["rates_rad_s"] = array_of(R.transpose() * state.w);
  line["commands"] = values_of(channels, true);
  line["measured"] = values_of(channels, false);
  return line.dump();
}

std::string obey(const std::string& line, Channels& commands) {
  const Json answer = is_nested_deeply(line) ? Json() : Json::parse(line, nullptr, false);
  if (!answer.is_object()) return "allowed: a JSON object such as {\"commands\": {}}";
  for (const auto& [key, value] : answer.items())
    if (key != "commands") return "there is no key '" + key + "'; allowed: commands";
  if (answer.empty()) return "";
  const Json& asked = answer["commands"];
  if (!asked.is_object()) return "commands: allowed: a JSON object of numbers by name";
  std::vector<std::pair<int, double>> values;
  for (const auto& [name, value] : asked.items()) {
    const int channel = commands.find(name);
    if (channel < 0 || !commands.is_command(channel)) return no_command(name, commands);
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      return "command '" + name + "': found " + value.dump() + "; allowed: a finite number";
    values.emplace_back(channel, value.get<double>());
  }
  for (const auto& [channel, value] : values) commands.set(channel, value);
  return "";
}

}  // namespace nilas::vessel
