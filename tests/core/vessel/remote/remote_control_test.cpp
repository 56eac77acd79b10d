/// Control from outside: lines, and a controller that answers, is late, goes away or sends nonsense. The controller is
/// a thread of the test at the other end of the socket.
#include "core/vessel/remote/remote_control.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <thread>

#include "core/base/error.h"
#include "core/base/stop_request.h"
#include "core/vessel/remote/line_server.h"
#include "core/vessel/remote/remote_lines.h"
#include "tests/support/scratch_folder.h"

namespace remote_control_test {

using namespace nilas;
using namespace nilas::vessel;

/// A client of the socket, as a controller has it.
class Client {
 public:
  explicit Client(const std::string& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    for (int trial = 0; trial < 500; ++trial) {
      socket_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
      if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) return;
      ::close(socket_);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    socket_ = -1;
  }
  ~Client() { ::close(socket_); }
  void send(const std::string& text) const { EXPECT_GT(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), 0); }
  /// The next line; empty where the other end has closed.
  std::string line() {
    std::string text;
    for (char c = 0; ::recv(socket_, &c, 1, 0) == 1 && c != '\n';) text += c;
    return text;
  }

 private:
  int socket_ = -1;
};

bodies::Bodies one_vessel() {
  bodies::Bodies all;
  bodies::BodySpec spec;
  spec.name = "ship";
  spec.kind = bodies::BodyKind::vessel;
  spec.shape = std::make_shared<const geometry::Shape>(geometry::box_shape({2, 1, 1}));
  spec.mass = 100;
  spec.inertia_B = Mat3::Identity();
  spec.pose.p = {1, 2, 0.25};
  spec.pose.q = Quat(Eigen::AngleAxisd(0.5 * k_pi, Vec3::UnitZ()));
  spec.v = {0, 3, 0};
  spec.w = {0, 0, 0.5};
  all.add(spec);
  return all;
}

class RemoteControl : public testing::Test {
 protected:
  RemoteControl() {
    commands_->add("rudder", "rad", 0);
    commands_->add_measured("bow.thrust_actual", "N", 3);
  }

  std::unique_ptr<bodies::Module> module(double timeout = 5, bool force = false) {
    return make_remote_control({socket_, timeout, force}, 0, bodies_, 1.5, commands_);
  }

  /// The message of the error with which a step begins while `controller` acts.
  std::string failure(const std::function<void(Client&)>& controller, double timeout = 5) {
    const auto run = module(timeout);
    std::thread other([&] {
      Client client(socket_);
      client.line();
      controller(client);
    });
    std::string message;
    try {
      run->begin_step();
    } catch (const SimulationError& error) {
      message = error.what();
    }
    other.join();
    return message;
  }

  test::ScratchFolder folder_;
  std::string socket_ = (folder_ / "s").string();
  bodies::Bodies bodies_ = one_vessel();
  std::shared_ptr<Channels> commands_ = std::make_shared<Channels>();
};

/// Heading 90 degrees: 3 m/s along Y are 3 m/s ahead. The line has sixteen digits, enough for every double.
TEST_F(RemoteControl, SendsTheStateAndTakesCommands) {
  const auto run = module();
  std::string first, second;
  std::thread other([&] {
    Client client(socket_);
    first = client.line();
    client.send("{\"commands\": {\"rudder\": 0.25}}\n");
    second = client.line();
    client.send("{}\n");
  });
  run->begin_step();
  EXPECT_EQ((*commands_)[0], 0.25);
  bodies_.set_pose(0, {7, 8, 9}, Quat::Identity());
  run->end_substep(bodies_, 1.6, 0.1);
  run->begin_step();
  EXPECT_EQ((*commands_)[0], 0.25) << "an empty object keeps the commands";
  other.join();
  EXPECT_EQ(first.substr(0, 58), R"({"time_s":1.5,"step":0,"position_m":[1.0,2.0,0.25],"yaw_ra)");
  EXPECT_NE(first.find(R"("velocity_m_s":[0.0,3.0,0.0],"speeds_m_s":[3.0,)"), std::string::npos) << first;
  EXPECT_NE(
      first.find(R"("rates_rad_s":[0.0,0.0,0.5],"commands":{"rudder":0.0},"measured":{"bow.thrust_actual":3.0}})"),
      std::string::npos)
      << first;
  EXPECT_NE(second.find(R"("time_s":1.6,"step":1,"position_m":[7.0,8.0,9.0])"), std::string::npos) << second;
  EXPECT_NE(second.find(R"("commands":{"rudder":0.25},)"), std::string::npos) << second;
}

/// A run that continues from a checkpoint sends the line that the run would have sent.
TEST_F(RemoteControl, ContinuesWithTheSameLine) {
  const auto one_line = [&](bodies::Module& run) {
    std::string line;
    std::thread other([&] {
      Client client(socket_);
      line = client.line();
      client.send("{}\n");
    });
    run.begin_step();
    other.join();
    return line;
  };
  State state;
  std::string before;
  {
    const auto run = module();
    one_line(*run);
    bodies_.set_pose(0, {0.1, 0.2, 0.3}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())));
    run->end_substep(bodies_, 1.7, 0.1);
    run->save(bodies_, StateWriter(state));
  }
  const auto again = module();
  again->restore(StateReader(state));
  before = one_line(*again);
  EXPECT_NE(before.find(R"("time_s":1.7,"step":1,"position_m":[0.1,0.2,0.3])"), std::string::npos) << before;
}

/// 2 N ahead and 1 N to port at a heading of 90 degrees are 2 N along Y and 1 N against X.
TEST_F(RemoteControl, ExertsForcesInTheAxesOfTheVessel) {
  const auto run = module(5, true);
  EXPECT_TRUE(run->exerts_loads());
  std::thread other([&] {
    Client client(socket_);
    client.line();
    client.send("{\"commands\": {\"force_x\": 2, \"force_y\": 1, \"moment_z\": -3}}\n");
  });
  run->begin_step();
  other.join();
  bodies::Wrenches loads(1);
  run->add_forces(bodies_, 1.5, loads);
  EXPECT_TRUE(loads[0].force.isApprox(Vec3(-1, 2, 0), 1e-15));
  EXPECT_TRUE(loads[0].torque.isApprox(Vec3(0, 0, -3), 1e-15));
  EXPECT_FALSE(make_remote_control({socket_, 1, false}, 0, bodies_, 0, commands_)->exerts_loads());
}

TEST_F(RemoteControl, NamesWhatTheControllerDidWrong) {
  const auto sends = [&](const std::string& text) { return failure([&](Client& client) { client.send(text); }); };
  const auto expect = [](const std::string& message, const std::vector<std::string>& words) {
    for (const auto& word : words) EXPECT_NE(message.find(word), std::string::npos) << word << " is not in " << message;
  };
  expect(sends("full ahead\n"), {"at 1.5 s", "no command", "allowed: a JSON object", "received: full ahead"});
  expect(sends("[1]\n"), {"allowed: a JSON object"});
  expect(sends("{\"commands\": 3}\n"), {"allowed: a JSON object of numbers"});
  expect(sends("{\"command\": {}}\n"), {"no key 'command'", "allowed: commands"});
  expect(sends("{\"commands\": {\"ruder\": 1}}\n"), {"no command 'ruder'", "allowed: rudder", "nearest: rudder"});
  expect(sends("{\"commands\": {\"rudder\": \"1\"}}\n"), {"command 'rudder'", "found \"1\"", "finite"});
  expect(sends("{\"commands\": {\"rudder\": 1e999}}\n"), {"received: {\"commands\": {\"rudder\": 1e999}}"});
  expect(sends("{\"commands\": {\"rudder\": NaN}}\n"), {"no command", "NaN"});
  expect(sends("{\"commands\": {\"rudder\": 0.1, \"bow.thrust_actual\": 1}}\n"),
         {"'bow.thrust_actual' is measured and takes no command", "allowed: rudder;"});
  EXPECT_EQ((*commands_)[0], 0) << "nothing of a wrong line is taken";
}

TEST_F(RemoteControl, NoticesAControllerThatIsGone) {
  EXPECT_NE(failure([](Client& client) { client.send("{\"comm"); }).find("closed the connection; received: {\"comm"),
            std::string::npos);
}

TEST_F(RemoteControl, NoticesAControllerThatIsSilent) {
  const auto begun = std::chrono::steady_clock::now();
  const std::string message =
      failure([](Client&) { std::this_thread::sleep_for(std::chrono::milliseconds(600)); }, 0.2);
  EXPECT_NE(message.find("did not answer within 0.2 s"), std::string::npos) << message;
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(5));
}

TEST_F(RemoteControl, NoticesThatNobodyConnects) {
  try {
    module(0.1)->begin_step();
    FAIL();
  } catch (const SimulationError& error) {
    EXPECT_NE(std::string(error.what()).find("did not connect within 0.1 s"), std::string::npos) << error.what();
  }
  EXPECT_FALSE(std::filesystem::exists(socket_)) << "the socket's file is removed";
}

TEST_F(RemoteControl, StopsWhenTheUserAsks) {
  listen_for_stop();
  std::thread other([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ::kill(::getpid(), SIGINT);
  });
  EXPECT_THROW(module(20)->begin_step(), Interruption);
  other.join();
  listen_for_stop();
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

TEST_F(RemoteControl, ReplacesASocketThatWasLeftAndNothingElse) {
  { std::ofstream(socket_) << "a file"; }
  EXPECT_THROW(module()->begin_step(), FileError);
  std::filesystem::remove(socket_);
  const LineServer other(socket_);
  EXPECT_THROW(module()->begin_step(), FileError) << "another program listens";
}

TEST(LineServerTest, JoinsAndSplitsLines) {
  const test::ScratchFolder folder;
  const std::string path = (folder / "s").string();
  LineServer server(path);
  std::thread other([&] {
    Client client(path);
    client.send("one\r\ntwo\nth");
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    client.send("ree\n");
    EXPECT_EQ(client.line(), "four");
  });
  EXPECT_EQ(server.accept(5), LineStatus::done);
  for (const char* expected : {"one", "two", "three"}) EXPECT_EQ(server.receive(5).text, expected);
  EXPECT_EQ(server.send("four", 5), LineStatus::done);
  other.join();
  EXPECT_EQ(server.receive(5).status, LineStatus::closed);
}

}  // namespace remote_control_test
