#pragma once
/// Control from outside: another program reads the vessel's motion and sets what rudders, propellers and thrusters are
/// asked for, once per step, over a local socket. docs/howto/control-from-outside.md describes the lines.
#include <memory>
#include <string>

#include "core/base/channels.h"
#include "core/bodies/module.h"

namespace nilas::vessel {

struct RemoteControlSettings {
  std::string socket;   ///< path of the socket's file, of at most k_longest_socket_path bytes
  double timeout = 10;  ///< longest wait for the other program, to connect and for each answer [s of wall time]
  bool force = false;   ///< true: channels force_x, force_y and moment_z are added, and their loads act on the vessel
};

/// Makes the module. It listens from the first step on. At the start of each step it sends one line with the state of
/// the body `vessel` and the commands in force, and waits for one line with commands. They act in this step. The
/// first line has the state of `bodies` at `time` [s]. `commands` are the channels that may be set.
///
/// Loads of the channels force_x, force_y [N] and moment_z [N m]: force (force_x, force_y, 0) at the centre of mass and
/// moment (0, 0, moment_z), in the axes of V.
///
/// begin_step() throws SimulationError, with time and what was received, where the other program does not connect or
/// answer in time, closes the connection, or sends a line that is no command; FileError where there can be no socket;
/// and Interruption where the user asks the program to stop meanwhile.
std::unique_ptr<bodies::Module> make_remote_control(const RemoteControlSettings& settings, int vessel,
                                                    const bodies::Bodies& bodies, double time,
                                                    std::shared_ptr<Channels> commands);

}  // namespace nilas::vessel
