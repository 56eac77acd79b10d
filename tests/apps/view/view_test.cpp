/// `nilas view` and the live view of `nilas run --view`.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <regex>
#include <thread>

#include "apps/view/http.h"
#include "core/hdf5/hdf5_file.h"
#include "tests/apps/small_scenes.h"
#include "tests/core/output/replay/replay_reader.h"
#include "tests/support/mentions.h"
#include "tests/support/started_program.h"

namespace view_test {

using namespace nilas_test;
using nilas::Vec3;
using nilas::test::mentions;
using nilas::test::Replay;

class View : public ::testing::Test {
 protected:
  View() {
    folder.write("ship.xml", k_ship);
    std::string endless = k_ship;
    endless.replace(endless.find("end=\"1\""), 7, "end=\"900\"");
    folder.write("endless.xml", endless);
  }
  ProgramResult nilas(const std::string& arguments) const { return run_nilas(arguments, folder.path()); }
  void run_ship() const { ASSERT_EQ(nilas("run ship.xml --quiet --out run").exit_code, 0); }
  fs::path in(const std::string& file) const { return folder.path() / file; }
  void expect_refusal(const std::string& arguments, int exit_code, const std::string& words) const {
    const auto result = nilas(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_TRUE(mentions(result.err, words)) << result.err;
  }

  ScratchFolder folder;
};

/// The bytes of a block's letters, by the rule of the page's README.
std::string bytes_of_block(std::string_view text) {
  std::array<unsigned, 128> number{};
  unsigned count = 0;
  for (char c = '!'; c <= '~'; ++c)
    if (c != '"' && c != '&' && c != '<') number[static_cast<std::size_t>(c)] = count++;
  const auto of = [&](std::size_t k) { return number[static_cast<std::size_t>(text[k])]; };
  std::string bits;
  const auto take = [&](unsigned value, int width) {
    for (int k = 0; k < width; ++k) bits.push_back(static_cast<char>((value >> k) & 1U));
  };
  for (std::size_t k = 0; k + 1 < text.size(); k += 2) take(of(k) + 91 * of(k + 1), 13);
  if (text.size() % 2 == 1) take(of(text.size() - 1), 6);
  std::string bytes;
  for (std::size_t at = 0; at + 8 <= bits.size(); at += 8) {
    unsigned byte = 0;
    for (std::size_t k = 0; k < 8; ++k) byte |= static_cast<unsigned>(bits[at + k]) << k;
    bytes.push_back(static_cast<char>(byte));
  }
  return bytes;
}

/// The replay within a page.
std::string embedded(const std::string& page) {
  std::string bytes;
  const std::regex block("<script type=\"application/octet-stream\" id=\"replay-[0-9]+\">");
  for (std::sregex_iterator at(page.begin(), page.end(), block), end; at != end; ++at) {
    const auto begin = static_cast<std::size_t>(at->position() + at->length());
    bytes += bytes_of_block(std::string_view(page).substr(begin, page.find('<', begin) - begin));
  }
  return bytes;
}

TEST_F(View, ThePageHoldsTheRunAndNeedsNothingElse) {
  run_ship();
  const auto result = nilas("view run");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "11 frames")) << result.out;
  const std::string page = read_text(in("run/replay.html")), bytes = read_text(in("run/replay.bin"));
  EXPECT_EQ(embedded(page), bytes);
  EXPECT_EQ(page.find("@NILAS"), std::string::npos) << "a place that was not filled";
  EXPECT_FALSE(std::regex_search(page, std::regex("(src|href)=\"?(https?:)?//"))) << "names another machine";
  const Replay replay(bytes);
  ASSERT_EQ(replay.frames.size(), 11u);
  EXPECT_EQ(replay.frames.back().bodies.size(), 3u);
  EXPECT_EQ(replay.end, "The run reached its end.");
}

/// Each frame shows the contacts that contacts.h5 has of its step, with their forces.
TEST_F(View, ContactsOfAFrameAreThoseOfTheTable) {
  ASSERT_EQ(nilas("run ship.xml --quiet --out run --set output/@trajectory_every=0.02").exit_code, 0);
  const Replay replay(read_text(in("run/replay.bin")));
  const nilas::hdf5::Hdf5Reader table(in("run/contacts.h5"));
  const auto times = table.exact_numbers("contacts/time_s");
  const auto force = table.exact_numbers("contacts/fx_N");
  std::size_t shown = 0;
  for (const auto& frame : replay.frames) {
    std::vector<float> stored, drawn;
    for (std::size_t k = 0; k < times.size(); ++k)
      if (std::abs(times[k] - frame.t) < 1e-9) stored.push_back(static_cast<float>(force[k]));
    for (const auto& contact : frame.contacts)
      if (contact.stored) drawn.push_back(static_cast<float>(contact.force.x()));
    EXPECT_EQ(drawn, stored) << "at " << frame.t;
    shown += drawn.size();
  }
  EXPECT_GT(shown, 10u);
}

TEST_F(View, WhatIsNoReplayIsRefused) {
  expect_refusal("view nothing", 4, "no such run folder");
  fs::create_directories(in("empty"));
  expect_refusal("view empty", 2, "is no run folder");
  ASSERT_EQ(nilas("run ship.xml --quiet --out bare --until 0.1 --set output/@trajectory_every=0").exit_code, 0);
  expect_refusal("view bare", 2, "trajectory_every");
  run_ship();
  const std::string bytes = read_text(in("run/replay.bin"));
  folder.write("run/replay.bin", "NILASRP1" + bytes.substr(8));
  expect_refusal("view run", 2, "has version 1");
  folder.write("run/replay.bin", bytes.substr(0, 20));
  expect_refusal("view run", 2, "no frame");
  folder.write("run/replay.bin", bytes.substr(0, bytes.size() - 80));
  const auto result = nilas("view run --out cut.html");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_TRUE(mentions(result.out, "incomplete")) << result.out;
}

TEST_F(View, OfARunFolderOnlyTheReplayIsNeeded) {
  run_ship();
  fs::create_directories(in("copied"));
  fs::copy_file(in("run/replay.bin"), in("copied/replay.bin"));
  const auto result = nilas("view copied");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(read_text(in("copied/replay.html")), "<title>ship (copied)</title>"));
  fs::remove(in("run/replay.bin"));
  expect_refusal("view run", 2, "replay.bin: is missing");
}

TEST_F(View, AFullDiskIsNamed) {
  run_ship();
  // The page is written beside its place first.
  fs::create_symlink("/dev/full", in("page.html.part"));
  expect_refusal("view run --out page.html", 4, "No space left on device");
  EXPECT_FALSE(fs::exists(in("page.html")));
}

TEST_F(View, ASceneWithoutIceVesselAndWaterIsShown) {
  folder.write("box.xml", k_box);
  ASSERT_EQ(nilas("run box.xml --quiet --out box --set output/@trajectory_every=0.1").exit_code, 0);
  const auto result = nilas("view box");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "3 frames")) << result.out;
}

TEST_F(View, AKilledRunIsShownUpToItsLastWholeFrame) {
  Started run("run endless.xml --quiet --out killed --set output/@trajectory_every=0.02", folder.path());
  ASSERT_TRUE(run.reaches(in("killed/steps.csv"), 60));
  EXPECT_EQ(run.stop(SIGKILL), 128 + SIGKILL);
  const auto result = nilas("view killed");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(mentions(result.out, "does not say how the run ended") || mentions(result.out, "incomplete"))
      << result.out;
  EXPECT_GT(Replay(read_text(in("killed/replay.bin"))).frames.size(), 20u);
}

TEST_F(View, RodsAreDrawnWithTheirTension) {
  std::string scene = k_ship;
  const std::string carriage = "<carriage speed=\"0.5\" ramp=\"0.05\"/>";
  scene.replace(scene.find(carriage), carriage.size(), "<rod name=\"bow\" at=\"2.5 0 0.3\" to=\"2.5 4 0.3\"/>");
  folder.write("rods.xml", scene);
  ASSERT_EQ(nilas("run rods.xml --quiet --out rods --until 0.2").exit_code, 0);
  const Replay replay(read_text(in("rods/replay.bin")));
  ASSERT_EQ(replay.frames.size(), 3u);
  for (const auto& frame : replay.frames) {
    ASSERT_EQ(frame.lines.size(), 1u);
    EXPECT_EQ(frame.lines[0].kind, 1);
    EXPECT_EQ(frame.lines[0].name, "bow");
    ASSERT_EQ(frame.lines[0].points.size(), 2u);
    EXPECT_EQ(frame.lines[0].points[1], Vec3(2.5, 4, static_cast<double>(0.3f)));
    const double length = (frame.lines[0].points[0] - frame.lines[0].points[1]).norm();
    EXPECT_NEAR(length, (Vec3(2.5, 0, 0.1) - Vec3(2.5, 4, 0.3)).norm(), 1e-5) << "a rod keeps its length";
  }
  EXPECT_EQ(replay.frames[0].lines[0].force, 0);
  EXPECT_NE(replay.frames[2].lines[0].force, 0);
}

TEST_F(View, WavesAreInTheReplay) {
  std::string scene = k_ship;
  const std::string water = "<water density=\"1005\"/>";
  scene.replace(scene.find(water), water.size(),
                "<water density=\"1005\"><waves kind=\"regular\" height=\"0.04\" period=\"1\" heading_deg=\"90\" "
                "phase_deg=\"30\" ramp=\"2\" attenuation=\"exponential\" attenuation_rate=\"0.5\" ice_edge=\"0 3\"/>"
                "</water>");
  folder.write("waves.xml", scene);
  ASSERT_EQ(nilas("run waves.xml --quiet --out waves --until 0.1").exit_code, 0);
  const auto trains = Replay(read_text(in("waves/replay.bin"))).waves.at("trains");
  ASSERT_EQ(trains.size(), 1u);
  EXPECT_EQ(trains[0].at("start"), 0);
  EXPECT_EQ(trains[0].at("ramp"), 2);
  EXPECT_EQ(trains[0].at("edge"), (std::vector<double>{0, 3}));
  EXPECT_NEAR(trains[0].at("inward")[1].get<double>(), 1, 1e-15);
  const auto wave = trains[0].at("components").at(0).get<std::vector<double>>();
  const double w = 2 * nilas::k_pi;
  const std::vector<double> expected{0.02, w, 0, w * w / 9.81, nilas::k_pi / 6, 0.25};
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(wave.at(k), expected[k], 1e-9) << k;
}

/// A run with a live view, and its address.
class LiveRun {
 public:
  explicit LiveRun(const fs::path& folder, const std::string& flags = "")
      : folder_(folder), run_("run endless.xml --quiet --view --out live " + flags, folder) {
    const std::regex pattern("live view: http://127\\.0\\.0\\.1:([0-9]+)/\\?token=([0-9a-f]{32})\n");
    std::smatch found;
    std::string err;
    while (run_.runs() && !std::regex_search(err, found, pattern)) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      err = read_text(folder / "err.txt");
    }
    if (found.empty()) throw std::runtime_error("no address: " + err);
    port = std::stoi(found[1]);
    token = "?token=" + found[2].str();
  }
  httplib::Client client() const {
    httplib::Client client("127.0.0.1", port);
    client.set_read_timeout(60);
    return client;
  }
  /// Reads the stream until it has so many bytes.
  std::string first_bytes(std::size_t count) const {
    std::string bytes;
    client().Get("/events" + token, [&](const char* data, std::size_t size) {
      bytes.append(data, size);
      return bytes.size() < count;
    });
    return bytes;
  }
  int control(const std::string& json) const {
    const auto answer = client().Post("/control" + token, json, "application/json");
    return answer ? answer->status : -1;
  }
  std::size_t steps() const { return lines_of(folder_ / "live/steps.csv").size(); }
  int stop() { return run_.stop(SIGINT); }
  bool reaches(std::size_t lines) { return run_.reaches(folder_ / "live/steps.csv", lines); }

  int port = 0;
  std::string token;

 private:
  fs::path folder_;
  Started run_;
};

TEST_F(View, ThePageOfALiveRunNeedsTheToken) {
  LiveRun run(folder.path());
  auto client = run.client();
  const auto page = client.Get("/" + run.token);
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_NE(page->get_header_value("Content-Security-Policy").find("default-src 'none'"), std::string::npos);
  EXPECT_NE(page->body.find("\"live\":true"), std::string::npos);
  EXPECT_EQ(client.Get("/")->status, 403);
  EXPECT_EQ(client.Get("/?token=" + std::string(32, '0'))->status, 403);
  EXPECT_EQ(client.Get("/events")->status, 403);
  EXPECT_EQ(client.Post("/control", "{\"action\":\"pause\"}", "application/json")->status, 403);
  EXPECT_EQ(client.Get("/" + run.token, {{"Host", "elsewhere.example:80"}})->status, 403);
  EXPECT_EQ(client.Get("/../../etc/passwd" + run.token)->status, 404);
  EXPECT_EQ(run.stop(), 130);
}

TEST_F(View, TwoPagesReadTheRunAsItGoesOn) {
  LiveRun run(folder.path());
  EXPECT_EQ(run.first_bytes(8).substr(0, 8), "NILASRP4") << "also before the run has begun";
  ASSERT_TRUE(run.reaches(60));
  for (int page = 0; page < 2; ++page) {
    const Replay replay(run.first_bytes(20000));
    EXPECT_EQ(replay.head.at("scene"), "ship");
    EXPECT_GT(replay.frames.size(), 2u);
  }
  const std::size_t before = run.steps();
  EXPECT_TRUE(run.reaches(before + 20)) << "pages that close end nothing";
  EXPECT_EQ(run.stop(), 130);
}

TEST_F(View, ARunPausesStepsAndGoesOnAsThePageAsks) {
  LiveRun run(folder.path());
  ASSERT_TRUE(run.reaches(20));
  EXPECT_EQ(run.control("{\"action\":\"pause\"}"), 204);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const std::size_t paused = run.steps();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_EQ(run.steps(), paused);
  EXPECT_EQ(run.control("{\"action\":\"step\"}"), 204);
  ASSERT_TRUE(run.reaches(paused + 1));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_LE(run.steps(), paused + 10) << "one frame of ten steps at most";
  EXPECT_EQ(run.control("{\"action\":\"jump\"}"), 400);
  EXPECT_EQ(run.control("no json"), 400);
  EXPECT_EQ(run.control("{\"action\":\"slow\",\"factor\":-1}"), 400);
  EXPECT_EQ(run.control("{\"action\":\"resume\"}"), 204);
  EXPECT_TRUE(run.reaches(paused + 30));
  EXPECT_EQ(run.control("{\"action\":\"pause\"}"), 204);
  EXPECT_EQ(run.stop(), 130) << "a paused run can be interrupted";
}

/// Sends the letters of a request one by one, and never the last one.
class SlowClient {
 public:
  explicit SlowClient(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    sender_ = std::thread([this] {
      while (!over_ && ::send(socket_, "a", 1, MSG_NOSIGNAL) == 1)
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    });
  }
  ~SlowClient() {
    over_ = true;
    sender_.join();
    ::close(socket_);
  }
  SlowClient(const SlowClient&) = delete;
  SlowClient& operator=(const SlowClient&) = delete;

  bool connected = false;

 private:
  int socket_;
  std::atomic<bool> over_ = false;
  std::thread sender_;
};

TEST_F(View, AClientThatSendsSlowlyDoesNotHoldTheEndOfTheRun) {
  LiveRun run(folder.path());
  const SlowClient client(run.port);
  ASSERT_TRUE(client.connected);
  ASSERT_TRUE(run.reaches(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // until the server reads from it
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run.stop(), 130);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20))
      << "the letters would last for half an hour";
}

TEST_F(View, AUsedPortAndARunWithoutFramesAreRefused) {
  LiveRun run(folder.path());
  expect_refusal("run ship.xml --out other --view --view-port " + std::to_string(run.port), 4, "another port");
  EXPECT_FALSE(fs::exists(in("other"))) << "a run that did not begin leaves nothing";
  expect_refusal("run ship.xml --out other --view --set output/@trajectory_every=0", 2, "trajectory_every");
  expect_refusal("run ship.xml --out other --view-port 80", 2, "--view");
}

}  // namespace view_test
