#pragma once
/// Values of <vessel><remote_control>.
#include <string>

namespace nilas::scene {

struct RemoteControlScene {
  std::string socket;   ///< path of the socket's file, relative to the working directory
  double timeout = 10;  ///< [s] of wall time
  bool force = false;

  bool operator==(const RemoteControlScene&) const = default;
};

}  // namespace nilas::scene
