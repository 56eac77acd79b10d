#include "core/vessel/remote/remote_control.h"

#include <fmt/format.h>

#include <utility>

#include "core/base/error.h"
#include "core/vessel/remote/line_server.h"
#include "core/vessel/remote/remote_lines.h"

namespace nilas::vessel {

namespace {

class RemoteControl : public bodies::Module {
 public:
  RemoteControl(RemoteControlSettings settings, int vessel, const bodies::Bodies& bodies, double time,
                std::shared_ptr<Channels> commands)
      : settings_(std::move(settings)), vessel_(vessel), commands_(std::move(commands)) {
    if (settings_.force) {
      force_x_ = commands_->add("force_x", "N", 0);
      force_y_ = commands_->add("force_y", "N", 0);
      moment_z_ = commands_->add("moment_z", "N m", 0);
    }
    note(bodies, time);
  }

  std::string name() const override { return "remote_control"; }
  bool exerts_loads() const override { return settings_.force; }
  /// The other program sets the vessel in motion, but free ice at no one velocity.
  std::optional<Vec3> drift() const override { return Vec3::Zero(); }

  void add_forces(const bodies::Bodies& bodies, double /*t*/, bodies::Wrenches& out) override {
    if (!settings_.force) return;
    const Channels& ask = *commands_;
    const Mat3& R = bodies.R_GB[vessel_];
    out[vessel_].force += R * Vec3(ask[force_x_], ask[force_y_], 0);
    out[vessel_].torque += R * Vec3(0, 0, ask[moment_z_]);
  }

  void begin_step() override {
    connect();
    demand(server_->send(line_of(state_, *commands_), settings_.timeout), "did not read the line of the state", "");
    const ReceivedLine line = server_->receive(settings_.timeout);
    demand(line.status, "did not answer", line.text);
    if (const std::string fault = obey(line.text, *commands_); !fault.empty())
      fail("sent a line that is no command: " + fault, line.text);
    ++state_.step;
  }

  void end_substep(const bodies::Bodies& bodies, double t, double /*h*/) override { note(bodies, t); }

  void save(const bodies::Bodies& /*bodies*/, StateWriter out) const override {
    out.add("time", state_.time);
    out.add("step", state_.step);
    out.add("p", state_.p);
    out.add("q", state_.q);
    out.add("v", state_.v);
    out.add("w", state_.w);
  }
  void restore(const StateReader& in) override {
    in.get("time", state_.time);
    in.get("step", state_.step);
    in.get("p", state_.p);
    in.get("q", state_.q);
    in.get("v", state_.v);
    in.get("w", state_.w);
  }

 private:
  void note(const bodies::Bodies& bodies, double t) {
    state_.time = t;
    state_.p = bodies.p_GB[vessel_];
    state_.q = bodies.q_GB[vessel_];
    state_.v = bodies.v_GB[vessel_];
    state_.w = bodies.w_GB[vessel_];
  }

  /// Waits for the other program, once in a run.
  void connect() {
    if (server_) return;
    auto server = std::make_unique<LineServer>(settings_.socket);
    demand(server->accept(settings_.timeout), "did not connect", "");
    server_ = std::move(server);
  }

  /// Throws unless a wait ended as wanted. `lack`: what the controller did not do; `received`: what it sent of a line.
  void demand(LineStatus status, const std::string& lack, const std::string& received) const {
    switch (status) {
      case LineStatus::done:
        return;
      case LineStatus::timed_out:
        fail(fmt::format("{} within {:g} s", lack, settings_.timeout), received);
      case LineStatus::closed:
        fail("closed the connection", received);
      case LineStatus::too_long:
        fail("sent more than a line may hold", received);
      case LineStatus::failed:
        fail("cannot be reached any more", received);
      case LineStatus::stopped:
        throw Interruption(
            fmt::format("the program was asked to stop while it waited for the controller at {:g} s", state_.time));
    }
  }

  [[noreturn]] void fail(const std::string& what, const std::string& received) const {
    constexpr std::size_t k_most = 200;  // characters of a message
    const std::string shown = received.size() > k_most ? received.substr(0, k_most) + "..." : received;
    throw SimulationError(fmt::format("at {:g} s: <vessel><remote_control>: the controller at {} {}{}", state_.time,
                                      settings_.socket, what, shown.empty() ? "" : "; received: " + shown));
  }

  RemoteControlSettings settings_;
  int vessel_;
  std::shared_ptr<Channels> commands_;
  int force_x_ = -1, force_y_ = -1, moment_z_ = -1;
  Measured state_;
  std::unique_ptr<LineServer> server_;
};

}  // namespace

std::unique_ptr<bodies::Module> make_remote_control(const RemoteControlSettings& settings, int vessel,
                                                    const bodies::Bodies& bodies, double time,
                                                    std::shared_ptr<Channels> commands) {
  NILAS_DEMAND(vessel >= 0 && vessel < bodies.size() && settings.timeout > 0 && commands);
  NILAS_DEMAND(static_cast<int>(settings.socket.size()) <= k_longest_socket_path);
  return std::make_unique<RemoteControl>(settings, vessel, bodies, time, std::move(commands));
}

}  // namespace nilas::vessel
