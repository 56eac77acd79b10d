#include "core/vessel/remote/remote_lines.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace nilas::vessel {

namespace {

using Json = nlohmann::ordered_json;

Json array_of(const Vec3& x) { return {x[0], x[1], x[2]}; }

std::string names_of(const Channels& commands) {
  std::string all;
  for (int k = 0; k < commands.size(); ++k) all += (all.empty() ? "" : ", ") + commands.name(k);
  return all;
}

std::string unknown_channel(const std::string& name, const Channels& commands) {
  std::vector<std::string> names;
  for (int k = 0; k < commands.size(); ++k) names.push_back(commands.name(k));
  const std::string near = nearest_name(name, names);
  return "there is no command '" + name + "'; allowed: " + names_of(commands) +
         (near.empty() ? "" : "; nearest: " + near);
}

}  // namespace

std::string line_of(const Measured& state, const Channels& commands) {
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
  line["commands"] = Json::object();
  for (int k = 0; k < commands.size(); ++k) line["commands"][commands.name(k)] = commands[k];
  return line.dump();
}

std::string obey(const std::string& line, Channels& commands) {
  const Json answer = Json::parse(line, nullptr, false);
  if (!answer.is_object()) return "allowed: a JSON object such as {\"commands\": {}}";
  for (const auto& [key, value] : answer.items())
    if (key != "commands") return "there is no key '" + key + "'; allowed: commands";
  if (answer.empty()) return "";
  const Json& asked = answer["commands"];
  if (!asked.is_object()) return "commands: allowed: a JSON object of numbers by name";
  std::vector<std::pair<int, double>> values;
  for (const auto& [name, value] : asked.items()) {
    const int channel = commands.find(name);
    if (channel < 0) return unknown_channel(name, commands);
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      return "command '" + name + "': found " + value.dump() + "; allowed: a finite number";
    values.emplace_back(channel, value.get<double>());
  }
  for (const auto& [channel, value] : values) commands.set(channel, value);
  return "";
}

}  // namespace nilas::vessel
