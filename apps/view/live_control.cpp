#include "apps/view/live_control.h"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/output/text/phase_progress.h"

namespace nilas::view {

namespace {

/// The run looks this often whether it was told to stop [s].
constexpr std::chrono::milliseconds k_look_every{50};

double factor_of(const nlohmann::json& request) {
  const auto factor = request.find("factor");
  if (factor == request.end() || !factor->is_number()) throw InputError("'slow' needs a number 'factor'");
  const double value = factor->get<double>();
  if (!std::isfinite(value) || value < 0) throw InputError("'factor' must be a finite number >= 0");
  return value;
}

}  // namespace

void LiveControl::request(const std::string& json) {
  const auto request = nlohmann::json::parse(json, nullptr, false);
  const auto action = request.is_object() ? request.find("action") : request.end();
  if (!request.is_object() || action == request.end() || !action->is_string())
    throw InputError("a request is a JSON object with an 'action'");
  const auto name = action->get<std::string>();
  const std::lock_guard lock(mutex_);
  if (name == "pause") {
    paused_ = true;
    stepping_ = false;
  } else if (name == "resume") {
    paused_ = stepping_ = false;
    pace_begins_ = true;
  } else if (name == "step") {
    paused_ = stepping_ = true;
  } else if (name == "slow") {
    factor_ = factor_of(request);
    pace_begins_ = true;
  } else {
    throw InputError("'action' is pause, resume, step or slow; found '" + name + "'");
  }
  ++count_;
  changed_.notify_all();
}

/// How far the run is ahead of its pace at simulated time t [s].
double LiveControl::ahead(double t) {
  if (factor_ <= 0) return 0;
  const double now = output::steady_seconds();
  if (pace_begins_) {
    pace_begins_ = false;
    pace_wall_ = now;
    pace_time_ = t;
  }
  return (t - pace_time_) / factor_ - (now - pace_wall_);
}

void LiveControl::hold(double t, const std::function<bool()>& stopped) {
  std::unique_lock lock(mutex_);
  while (!stopped()) {
    const bool waits = paused_ && !stepping_;
    const double seconds = waits ? 1 : ahead(t);
    if (!waits && seconds <= 0) return;
    changed_.wait_for(lock,
                      std::min<std::chrono::duration<double>>(k_look_every, std::chrono::duration<double>(seconds)));
  }
}

void LiveControl::frame_written() {
  const std::lock_guard lock(mutex_);
  stepping_ = false;
}

LiveControl::State LiveControl::state() const {
  const std::lock_guard lock(mutex_);
  return {nlohmann::json{{"paused", paused_}, {"factor", factor_}}.dump(), count_};
}

}  // namespace nilas::view
